"""Commands that write files of a designed lens: ``freeform export``, ``pictures``, ``report``."""

from collections.abc import Callable, Sequence
from contextlib import closing
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import BinaryIO

from workbench.analysis.tolerance_fields import Tolerances
from workbench.cli.progress import PartProgress
from workbench.design.session import Session, result_of
from workbench.errors import Refused
from workbench.files.atomic import check_writable, replacing
from workbench.files.export.options import Cutting
from workbench.files.export.write import export as write_all
from workbench.files.session import read_session
from workbench.pictures import PICTURES, write_images
from workbench.report.content import HTML, Report, check_ending


def export(
    path: Path, files: Sequence[Path], chord_error: float | None, cutting: Cutting, mesh_unit: str
) -> None:
    """Write the lens of a session and its light in the formats of the file endings.

    Raise Refused if the session has no valid lens, or a file cannot be written, or, after the other
    files, a format cannot hold the data; RunFailed if an external library fails.
    """
    session = read_session(path)
    result_of(session, str(path))
    for written in write_all(session, files, chord_error, cutting, mesh_unit):
        print(written.sentence, flush=True)


def pictures(path: Path, folder: Path, stops: float | None = None, light: str = "") -> None:
    """Draw the lens of a session into a folder, which is made if missing.

    Raise Refused if the session has no lens, or the folder or a picture cannot be written;
    RunFailed if no light reaches the screen of a photo.
    """
    session = read_session(path)
    result_of(session, str(path))
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Refused(str(folder), f"cannot be made: {error.strerror or error}") from error
    drawn = [(name, write, session) for name, write in PICTURES.items()]
    images = [(session.of_image(number), number) for number in range(len(session.scene.receivers))]
    drawn += [(_named("irradiance", number), write_images, shown) for shown, number in images[1:]]
    if stops is not None:
        photo = partial(_write_photo, stops=stops, light=light)
        drawn += [(_named("photo", number), photo, shown) for shown, number in images]
    for name, _, _ in drawn:
        check_writable(folder / name)
    for name, write, shown in drawn:
        with replacing(folder / name) as file:
            write(shown, file)


def _named(name: str, number: int) -> str:
    return f"{name}-{number + 1}.png" if number else f"{name}.png"


def _write_photo(session: Session, file: BinaryIO, stops: float, light: str) -> None:
    # Slow imports, rarely needed.
    from workbench.analysis.photo.light import LIGHTS
    from workbench.analysis.photo.photo import photograph
    from workbench.analysis.photo.png import write_png

    heights = result_of(session).state.heights
    with closing(PartProgress("photo")) as progress:
        photo = photograph(session.scene, session.target, heights, LIGHTS.get(light), progress.show)
    write_png(photo, stops, file)
    print(f"photo: {photo.summary}")


def report(
    path: Path,
    files: Sequence[Path],
    rays: int,
    tolerances: tuple[Tolerances, int] | None,
    with_mitsuba: bool,
) -> None:
    """Check the lens of a session and write its report.

    Raise Refused if the session has no lens, a file cannot be written, a tolerance is not possible,
    or Mitsuba is not installed; RunFailed if no light reaches the receiver.
    """
    writers = [_writer(file) for file in files]
    session = read_session(path)
    result_of(session, str(path))
    for file in files:
        check_writable(file)
    from workbench.report.gather import gather  # slow import

    dated = datetime.fromtimestamp(path.stat().st_mtime)
    found = gather(session, path.stem, dated, rays, tolerances, with_mitsuba)
    for file, write in zip(files, writers, strict=True):
        with replacing(file) as stream:
            write(found, stream)


def _writer(file: Path) -> Callable[[Report, BinaryIO], None]:
    check_ending(file)
    if file.suffix.lower() in HTML:
        from workbench.report.write import write_html

        return write_html
    from workbench.report.write import write_pdf

    return write_pdf
