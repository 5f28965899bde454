"""``freeform pictures``."""

from pathlib import Path

from workbench.cli.designed import read_designed
from workbench.errors import Refused
from workbench.files.atomic import check_writable, replacing
from workbench.pictures import PICTURES, write_images


def pictures(path: Path, folder: Path) -> None:
    """Draw the lens of a session into a folder, which is made where it is missing.

    Parameters
    ----------
    path : Path
        Session with a lens.
    folder : Path
        Gets irradiance.png, lens.png and loss.png, and irradiance-2.png and so on of further
        images.

    Raises
    ------
    Refused
        If the session cannot be read or holds no lens, or the folder or a picture cannot be
        written.
    """
    session, _ = read_designed(path)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Refused(str(folder), f"cannot be made: {error.strerror or error}") from error
    drawn = [(name, write, session) for name, write in PICTURES.items()]
    drawn += [
        (f"irradiance-{number + 1}.png", write_images, session.of_image(number))
        for number in range(1, len(session.scene.receivers))
    ]
    for name, _, _ in drawn:
        check_writable(folder / name)
    for name, write, shown in drawn:
        with replacing(folder / name) as file:
            write(shown, file)
