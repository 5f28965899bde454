"""Sessions: a design and its result in one zip, as plain JSON and .npy arrays."""

import zipfile
from pathlib import Path
from typing import Any, Literal

from pydantic import ValidationError

from workbench import __version__
from workbench.design.session import KeptRun as KeptRun  # from here, too
from workbench.design.session import Session as Session
from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.files.atomic import replacing
from workbench.files.entries import Entries
from workbench.files.figures import Figures
from workbench.files.npy import write_array
from workbench.files.reading import opened
from workbench.files.scene import (
    LARGEST_TEXT,
    read_scene,
    with_absolute_image,
    with_portable_image,
)
from workbench.refusals import refusal
from workbench.scene import Part, Scene

_HEADER = "session.json"
_TARGET = "target.npy"
_CONTROL_POINTS = "control_points.npy"
_IRRADIANCE = "irradiance.npy"
_LOSS = "loss.npy"


class _Header(Part):
    """``session.json``; the scene in it is validated by itself."""

    format: Literal["freeform-session"]
    version: Literal[1]
    scene: dict[str, Any]
    result: Figures | None = None
    program: str


def open_design(path: Path) -> Session:
    """Open a session, or a scene file together with its target; told apart by content.

    Raises
    ------
    Refused
        If a file cannot be read or what it says is not possible.
    """
    if is_session(path):
        return read_session(path)
    scene = read_scene(path)
    from workbench.targets import load_target  # late: scipy.ndimage takes long to import

    return Session(scene, load_target(scene, path.parent))


def is_session(path: Path) -> bool:
    """Whether a file is a zip, whole or not; a scene file never is.

    Raises
    ------
    Refused
        If the file cannot be read.
    """
    with opened(path) as file:
        return file.read(2) == b"PK"


def write_session(session: Session, path: Path) -> None:
    """Write a session file; ``target.image`` becomes relative where it lies below its folder.

    Raises
    ------
    Refused
        If it cannot be written; what was at ``path`` before is still there.
    """
    result = session.result
    header = _Header(
        format="freeform-session",
        version=1,
        scene=with_portable_image(session.scene, path).to_data(),
        result=None if result is None else Figures.of(result),
        program=f"freeform-lens-workbench {__version__}",
    )
    arrays = {_TARGET: session.target}
    if result is not None:
        arrays[_CONTROL_POINTS] = result.control_points
        arrays[_IRRADIANCE] = result.irradiance
        arrays[_LOSS] = result.losses
    with replacing(path) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
        with archive.open(_HEADER, "w") as entry:
            entry.write(header.model_dump_json(indent=2, exclude_none=True).encode())
        for name, array in arrays.items():
            with archive.open(name, "w") as entry:
                write_array(entry, array)


def read_session(path: Path) -> Session:
    """Read a session file.

    Nothing is unpickled or unpacked, and nothing is read that is larger than the scene implies.

    Parameters
    ----------
    path : Path
        Session file.

    Returns
    -------
    Session
        Its arrays are read-only.

    Raises
    ------
    Refused
        If it cannot be read or is not, in every entry, what `write_session` writes.
    """
    if not is_session(path):
        raise Refused(str(path), "is no session: it does not begin like a zip")
    with opened(path) as file:
        entries = Entries(path, file)
        header, scene = _read_header(path, entries)
        n_x, n_y = scene.screen.pixels
        figures = header.result
        shapes: dict[str, tuple[int, ...]] = {_TARGET: (n_y, n_x)}
        if figures is not None:
            shapes[_CONTROL_POINTS] = scene.lens.control_points
            shapes[_IRRADIANCE] = (n_y, n_x)
            shapes[_LOSS] = (figures.iterations,)
        entries.check_names({_HEADER, *shapes})
        arrays = {name: entries.array(name, shape) for name, shape in shapes.items()}
    target = arrays[_TARGET]
    if target.min() < 0 or not target.any():
        raise Refused(f"{path}: {_TARGET}", "is dark or has negative values; some light is needed")
    if figures is None:
        return Session(scene, target)
    result = Result(
        control_points=arrays[_CONTROL_POINTS],
        irradiance=arrays[_IRRADIANCE],
        losses=arrays[_LOSS],
        loss=figures.loss,
        seconds=figures.seconds,
        ledger=figures.to_ledger(),
        stage_starts=figures.stage_starts or (),
        stages_left=figures.stages_left or 0,
    )
    return Session(scene, target, result)


def _read_header(path: Path, entries: Entries) -> tuple[_Header, Scene]:
    where = f"{path}: {_HEADER}"
    try:
        header = _Header.model_validate_json(entries.content(_HEADER, LARGEST_TEXT))
    except ValidationError as error:
        refused = refusal(error, _Header, whole="text")
        raise Refused(f"{where}: {refused.path}", refused.reason) from None
    try:
        scene = Scene.from_data(header.scene)
    except Refused as refused:
        raise Refused(f"{where}: {refused.path}", refused.reason) from None
    return header, with_absolute_image(scene, path)
