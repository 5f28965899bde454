"""Sessions: a design and its result in one zip, as plain JSON and .npy arrays."""

import zipfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from workbench import __version__
from workbench.arrays import Array, Mask
from workbench.design.net import definite
from workbench.design.session import KeptRun as KeptRun  # to be had from here, too
from workbench.design.session import Session as Session
from workbench.design.task import LARGEST_PICTURE, begin
from workbench.errors import Refused
from workbench.files.atomic import replacing
from workbench.files.designs import (
    NEWEST,
    Names,
    designed_faces,
    entries_of,
    face_entries,
    kept_ending,
    names_of,
    names_of_pictures,
    picture_entries,
    read_heights,
    read_picture,
    read_result,
    read_target,
    with_read_targets,
)
from workbench.files.entries import Entries, write_array
from workbench.files.figures import Figures, VerifiedFigures
from workbench.files.header import (
    MOST_RUNS,
    VERSION,
    Header,
    RunHeader,
    chosen_net,
    plain_view,
    read_header,
    read_part,
)
from workbench.files.scene import LARGEST_TEXT, read_scene, with_absolute_files, with_portable_files
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import nets_of
from workbench.messages import Message
from workbench.reading import digest, opened
from workbench.scene import Scene

HEADER = "session.json"
_LOCKED, _START = "locked", "start"
"""Entries of faces: which heights are locked; heights to begin with, where no result has any."""


def open_design(path: Path) -> Session:
    """Open a session, or a scene file together with its target; distinguished by content.

    Raises `Refused` if a file cannot be read or what it says is not possible.
    """
    if is_session(path):
        return read_session(path)
    return begin(read_scene(path), path.parent)


def is_session(path: Path) -> bool:
    """Whether a file begins like a zip; raise Refused if it cannot be read."""
    with opened(path) as file:
        return file.read(2) == b"PK"


def write_session(session: Session, path: Path) -> str:
    """Write a session file, with relative names of files below its folder; return its fingerprint.

    Raises `Refused` if it cannot be written or would be too large to be read; then the file at
    ``path`` stays as it was.

    Examples
    --------
    >>> from resources import path
    >>> fingerprint = write_session(
    ...     open_design(path("examples", "tophat.json")), Path("tophat.freeform"))
    >>> read_session(Path("tophat.freeform")).scene.receiver.pixels
    (256, 256)
    """
    text = _header(session, path).model_dump_json(indent=2, exclude_none=True).encode()
    if len(text) > LARGEST_TEXT:
        raise Refused(
            str(path),
            Message(
                "its text would have {size} bytes; at most {most} can be read",
                size=len(text),
                most=LARGEST_TEXT,
            ),
        )
    arrays: dict[str, Array | Mask] = {
        **entries_of("", session.scene, session.target, session.result)
    }
    placed = {each.name: each for each in designed_faces(session.scene)}
    arrays |= {NEWEST.face(placed[face], _LOCKED): each for face, each in session.locked.items()}
    if session.result is None and session.start is not None:
        arrays |= face_entries(session.scene, session.start, _START)
    for number, run in enumerate(session.runs):
        arrays |= entries_of(_folder(number), run.scene, run.target, run.result)
    with replacing(path) as file:
        with zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
            with archive.open(HEADER, "w") as entry:
                entry.write(text)
            for name, array in arrays.items():
                with archive.open(name, "w") as entry:
                    write_array(entry, array)
            for name, light in _light_of(session).items():
                archive.writestr(name, light)
            for name, picture in _pictures_of(session).items():
                archive.writestr(name, picture)
        file.seek(0)
        return digest(file)


def read_session(path: Path) -> Session:
    """Read a session file; its arrays are read-only.

    Nothing is unpickled or unpacked, or larger than the scenes imply. Raises `Refused` if an entry
    is not as `write_session` writes it.
    """
    if not is_session(path):
        raise Refused(str(path), Message("is no session: it does not begin like a zip"))
    with opened(path) as file:
        entries = Entries(path, file)
        where = entries.where(HEADER)
        header = read_header(entries.content(HEADER, LARGEST_TEXT), where)
        named = Names(header.version)
        scene = _scene_of(header, where, entries, named, "", path, {})
        light = scene.light_files
        runs = [
            (
                run,
                _scene_of(
                    run, f"{where}: runs[{k}].scene", entries, named, _folder(k), path, light
                ),
            )
            for k, run in enumerate(header.runs or ())
        ]
        names = {HEADER} | names_of(entries, named, "", scene, header.result)
        names |= _names_of_light(entries, "", scene)
        nets = nets_of(scene)
        faces = designed_faces(scene)
        locks = {each.name: named.face(each, _LOCKED) for each in faces}
        locks = {face: name for face, name in locks.items() if name in entries}
        names.update(locks.values())
        begins = {named.face(each, _START) for each in faces}
        starts = header.result is None and any(name in entries for name in begins)
        if starts:
            names |= begins
        names |= names_of_pictures(entries, named, scene)
        for number, (run, task) in enumerate(runs):
            names |= names_of(entries, named, _folder(number), task, run.result)
            names |= _names_of_light(entries, _folder(number), task)
        entries.check_names(names)
        for placed in faces:
            name = named.face(placed, _START if starts else "")
            if placed.name in scene.fixed_faces and name in entries:
                data = entries.content(name, LARGEST_PICTURE)
                scene = scene.with_fixed_heights(placed.name, data)
        return Session(
            scene,
            read_target(entries, named, "", scene),
            None
            if header.result is None
            else read_result(entries, named, "", scene, header.result),
            FaceArrays({face: entries.mask(locks[face], nets[face].shape) for face in locks}),
            tuple(_read_runs(entries, named, runs)),
            header.view,
            read_heights(entries, named, scene, what=_START) if starts else None,
            read_picture(entries, named, scene),
        )


def _light_of(session: Session) -> dict[str, bytes]:
    """Files of sources by names of entries; of kept runs only if they differ."""
    found = _light_entries("", session.scene, {})
    for number, run in enumerate(session.runs):
        found |= _light_entries(_folder(number), run.scene, session.scene.light_files)
    return found


def _pictures_of(session: Session) -> dict[str, bytes]:
    """Kept image files of the targets by names of entries."""
    names = picture_entries(session.scene)
    return {
        name: data
        for name, data in zip(names, session.pictures, strict=True)
        if name is not None and data is not None
    }


def _header(session: Session, path: Path) -> Header:
    if len(session.runs) > MOST_RUNS:
        raise Refused(
            str(path),
            Message(
                "would hold {count} kept runs; at most {most}",
                count=len(session.runs),
                most=MOST_RUNS,
            ),
        )
    runs = [
        RunHeader(
            name=run.name,
            scene=with_portable_files(run.scene, path).to_data(),
            control_points=chosen_net(run.scene),
            result=Figures.of(run.result),
            verified=None if run.verified is None else VerifiedFigures(**run.verified._asdict()),
        )
        for run in session.runs
    ]
    return Header(
        version=VERSION,
        scene=with_portable_files(session.scene, path).to_data(),
        control_points=chosen_net(session.scene),
        result=None if session.result is None else Figures.of(session.result),
        runs=tuple(runs) or None,
        view=plain_view(session.view, f"{path}: view"),
        program=f"freeform-lens-workbench {__version__}",
    )


def _scene_of(
    header: Header | RunHeader,
    where: str,
    entries: Entries,
    names: Names,
    folder: str,
    path: Path,
    light: Mapping[str, bytes | None],
) -> Scene:
    """The scene of a design, with a definite net."""
    scene = read_part(header.scene, header.control_points, where)
    scene = with_read_targets(entries, names, folder, scene)
    if scene.optic.known_shape is None:
        scene = definite(scene, read_target(entries, names, folder, scene))
    return _with_kept_light(entries, folder, with_absolute_files(scene, path), light)


def _read_runs(
    entries: Entries, names: Names, runs: Sequence[tuple[RunHeader, Scene]]
) -> Iterator[KeptRun]:
    for number, (run, scene) in enumerate(runs):
        target = read_target(entries, names, _folder(number), scene)
        result = read_result(entries, names, _folder(number), scene, run.result)
        verified = None if run.verified is None else run.verified.to_error()
        yield KeptRun(run.name, scene, target, result, verified)


def _folder(number: int) -> str:
    return f"runs/{number}/"


def _light_entries(folder: str, scene: Scene, kept: Mapping[str, bytes | None]) -> dict[str, bytes]:
    """Files of the sources of a scene by names of entries, without those in ``kept``."""
    files = scene.light_files
    names = _light_names(folder, scene)
    return {
        names[file]: data
        for file, data in files.items()
        if data is not None and kept.get(file) != data
    }


def _names_of_light(entries: Entries, folder: str, scene: Scene) -> set[str]:
    """Names of the existing entries of source files."""
    return {name for name in _light_names(folder, scene).values() if name in entries}


def _with_kept_light(
    entries: Entries, folder: str, scene: Scene, kept: Mapping[str, bytes | None]
) -> Scene:
    """Return the scene with the contents of its source files, also from ``kept``, by file name."""
    found = dict(kept)
    for file, name in _light_names(folder, scene).items():
        if name in entries:
            found[file] = entries.content(name, LARGEST_PICTURE)
    return scene.carrying(found)


def _light_names(folder: str, scene: Scene) -> dict[str, str]:
    return {
        file: f"{folder}light_{number}{kept_ending(file)}"
        for number, file in enumerate(scene.light_files)
    }
