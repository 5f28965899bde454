"""``freeform pictures``."""

from contextlib import closing
from functools import partial
from pathlib import Path
from typing import BinaryIO

from workbench.cli.designed import read_designed
from workbench.cli.progress import PartProgress
from workbench.design.session import Session, result_of
from workbench.errors import Refused
from workbench.files.atomic import check_writable, replacing
from workbench.pictures import PICTURES, write_images


def pictures(path: Path, folder: Path, stops: float | None = None, light: str = "") -> None:
    """Draw the lens of a session into a folder, which is made where it is missing.

    Raises
    ------
    Refused
        If the session cannot be read or holds no lens, or the folder or a picture cannot be
        written.
    RunFailed
        If no light reaches the screen that a photo is to be of.
    """
    session, _ = read_designed(path)
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
    """Predict the photo, and say how it was made."""
    # Late: it takes two thirds of the start of a command that most often draws none.
    from workbench.analysis.photo.light import LIGHTS
    from workbench.analysis.photo.photo import photograph
    from workbench.analysis.photo.png import write_png

    heights = result_of(session).state.heights
    with closing(PartProgress("photo")) as progress:
        photo = photograph(session.scene, session.target, heights, LIGHTS.get(light), progress.show)
    write_png(photo, stops, file)
    print(f"photo: {photo.summary}")
