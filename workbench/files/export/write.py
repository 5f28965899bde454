"""Export of a session's lens and light; each file is written atomically."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from workbench.design.session import result_of, verified_error
from workbench.errors import Refused, RunFailed
from workbench.files.atomic import check_writable, replacing
from workbench.files.export.design import Design, Deviation
from workbench.files.export.formats import OF_ONE_FACE, Format, format_of
from workbench.files.export.options import MILLIMETRES, mesh_unit_of
from workbench.files.session import Session
from workbench.geometry.body import check_body
from workbench.messages import Message
from workbench.option_groups import OptionGroup
from workbench.powers import written
from workbench.progress import Progress, no_progress
from workbench.scene import Element, Scene

if TYPE_CHECKING:
    from workbench.files.export.cut_plan import CutPlan


class Written(NamedTuple):
    """A written file: path, format (with the face, if there are two), deviation from the design."""

    path: Path
    format: str
    deviation: Deviation

    @property
    def sentence(self) -> str:
        """All of it as one sentence."""
        kind, size, unit, note = self.deviation
        described = [self.format, f"{kind} {written(size, unit, 2)}", *([note] if note else [])]
        return f"{self.path}: {', '.join(described)}"


def export(
    session: Session,
    paths: Sequence[Path],
    chord_error: float | None = None,
    options: Sequence[OptionGroup] = (),
    mesh_unit: str = MILLIMETRES,
    plan: "CutPlan | None" = None,
    progress: Progress = no_progress,
    element: str | None = None,
) -> Iterator[Written]:
    """Write a lens and its light, one file after the other; a refused file stops no other.

    `session`: a session with a lens; `paths`: files to write; their endings select the formats;
    `chord_error`: largest distance of a mesh from the exit face, scene units; 1e-4 of the larger
    half-width by default; `options`: groups of options of formats; `mesh_unit`: unit of lengths in
    STL, OBJ, PLY and 3MF files, or "scene" for that of the scene; `plan`: a finished plan of this
    lens, with its own options of G-code; `progress`: called with the finished fraction of a slow
    file; `element`: name of the designed element that files of one element hold, the last one by
    default. Raises
    `Refused` before anything is written: if the session has no solid lens, the unit is unknown, an
    ending selects no format or a file cannot be written. At the end: if a format cannot hold the
    data; it names each such file; `RunFailed` at the end, if nothing was refused and an external
    library fails.
    """
    result = result_of(session)
    check_body(session.scene, result.state.heights)
    unit = mesh_unit_of(mesh_unit, session.scene.unit)
    optic = designed_element(session.scene, element)
    checks = (run.verified for run in session.runs if run.result.state.heights == session.heights)
    verified = next((verified_error(each) for each in checks if each is not None), None)
    face = optic.designed_face
    design = Design(
        session.scene, result, chord_error, face, tuple(options), unit, verified, plan, progress
    )
    formats = [format_of(path) for path in paths]
    front = optic.designed_front
    for path, found in zip(paths, formats, strict=True):
        if found.front and front is None:
            raise Refused(
                str(path), Message("the entrance face is not freeform, so it has no file")
            )
        found.check_design(design)
        check_writable(path)
    failures: list[tuple[Path, Refused | RunFailed]] = []
    for path, found in zip(paths, formats, strict=True):
        try:
            write = found.load()
            with replacing(path) as file:
                deviation = write(design, file)
        except (Refused, RunFailed) as failure:
            failures.append((path, failure))
        else:
            yield Written(path, _described(found, front), deviation)
    if failures:
        raise failures[0][1] if len(paths) == 1 else _together(failures)


def designed_element(scene: Scene, name: str | None) -> Element:
    """Return a designed element by its name, by default the last one; raise Refused without it."""
    if name is None:
        return scene.optic
    names = [optic.name for optic in scene.optics]
    if name not in names:
        raise Refused(
            "element",
            Message("{name} is no designed element; {names}", name=name, names=", ".join(names)),
        )
    return scene.focused_on(name).optic


def _together(failures: Sequence[tuple[Path, Refused | RunFailed]]) -> Refused | RunFailed:
    (first, failure), *others = failures
    reason: str = _of_file(first, failure)
    for path, other in others:
        reason = Message(
            "{reason}; {path}: {other}", reason=reason, path=path, other=_of_file(path, other)
        )
    if all(isinstance(each, RunFailed) for _, each in failures):
        return RunFailed(Message("{path}: {reason}", path=first, reason=reason))
    return Refused(str(first), reason)


def _of_file(path: Path, failure: Refused | RunFailed) -> str:
    if isinstance(failure, Refused) and failure.path == str(path):
        return failure.reason
    return str(failure)


def _described(found: Format, front: str | None) -> str:
    if found not in OF_ONE_FACE or front is None:
        return found.name
    other = found.of_entrance.endings[0]
    return f"{found.name}, exit face (*{other} is for the entrance face)"
