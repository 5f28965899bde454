"""Writes a session's lens and light, each file whole or not at all."""

from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from workbench.design.session import result_of
from workbench.errors import Refused, RunFailed
from workbench.files.atomic import check_writable, replacing
from workbench.files.export.cutting import PLAIN, Cutting
from workbench.files.export.design import Design, Deviation
from workbench.files.export.formats import OF_ONE_FACE, Format, format_of
from workbench.files.export.mesh_unit import MILLIMETRES, mesh_unit_of
from workbench.files.session import Session
from workbench.geometry.body import check_body
from workbench.powers import written
from workbench.said import Said
from workbench.watch import Watch, unwatched

if TYPE_CHECKING:
    from workbench.files.export.cut_plan import CutPlan


class Written(NamedTuple):
    """A file that has been written.

    Attributes
    ----------
    path : Path
        The file.
    format : str
        Name of its format; for a lens of two freeform faces, also which of them it holds.
    deviation : Deviation
        How far what stands in it is from the design.
    """

    path: Path
    format: str
    deviation: Deviation

    @property
    def sentence(self) -> str:
        """All of it for people to read."""
        kind, size, unit, note = self.deviation
        described = [self.format, f"{kind} {written(size, unit, 2)}", *([note] if note else [])]
        return f"{self.path}: {', '.join(described)}"


def export(
    session: Session,
    paths: Sequence[Path],
    chord_error: float | None = None,
    cutting: Cutting = PLAIN,
    mesh_unit: str = MILLIMETRES,
    plan: "CutPlan | None" = None,
    watch: Watch = unwatched,
) -> Iterator[Written]:
    """Write a lens and its light, one file after the other; one that is refused stops no other.

    Parameters
    ----------
    session : Session
        A session with a lens.
    paths : sequence of Path
        Files to write; their endings tell the formats.
    chord_error : float, optional
        How far a mesh may be from the exit face, scene units; 1e-4 of the larger half-width of
        the lens by default.
    cutting : Cutting
        How faces are cut, for G-code.
    mesh_unit : str
        Unit of lengths in STL, OBJ, PLY and 3MF files, or "scene" for that of the scene.
    plan : CutPlan, optional
        The cuts of this lens, where they have been planned and simulated before; it has a
        ``cutting`` of its own.
    watch : callable
        Is told which part of a file is done, where it takes long.

    Yields
    ------
    Written
        After each file.

    Raises
    ------
    Refused
        If the session has no lens or one that is no body, the unit is unknown, an ending tells no
        format or a file cannot be written, all of it before anything is written. At the end, if a
        format cannot hold what is asked; it names each such file.
    RunFailed
        At the end, if nothing was refused and another program's library that is needed fails.
    """
    result = result_of(session)
    check_body(session.scene, result.state.heights)
    unit = mesh_unit_of(mesh_unit, session.scene.unit)
    design = Design(session.scene, result, chord_error, None, cutting, unit, plan, watch)
    formats = [format_of(path) for path in paths]
    faces = result.state.heights.keys()
    for path, found in zip(paths, formats, strict=True):
        if found.face is not None and found.face not in faces:
            raise Refused(
                str(path), Said("the {face} face is flat, so it has no file", face=found.face)
            )
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
            yield Written(path, _described(found, faces), deviation)
    if failures:
        raise failures[0][1] if len(paths) == 1 else _together(failures)


def _together(failures: Sequence[tuple[Path, Refused | RunFailed]]) -> Refused | RunFailed:
    """One refusal or failure that names each file."""
    (first, failure), *others = failures
    reason: str = _of_file(first, failure)
    for path, other in others:
        reason = Said(
            "{reason}; {path}: {other}", reason=reason, path=path, other=_of_file(path, other)
        )
    if all(isinstance(each, RunFailed) for _, each in failures):
        return RunFailed(Said("{path}: {reason}", path=first, reason=reason))
    return Refused(str(first), reason)


def _of_file(path: Path, failure: Refused | RunFailed) -> str:
    """Why a file is not written, without its name."""
    if isinstance(failure, Refused) and failure.path == str(path):
        return failure.reason
    return str(failure)


def _described(found: Format, faces: Collection[str]) -> str:
    """What is in a file of a lens with freeform faces of these names."""
    if found not in OF_ONE_FACE or "entrance" not in faces:
        return found.name
    other = found.of_entrance.endings[0]
    return f"{found.name}, exit face (*{other} is for the entrance face)"
