"""``freeform pictures``."""

from pathlib import Path

from workbench.cli.designed import read_designed
from workbench.errors import Refused


def pictures(path: Path, folder: Path) -> None:
    """Draw the lens of a session into a folder, which is made where it is missing.

    Parameters
    ----------
    path : Path
        Session with a lens.
    folder : Path
        Gets irradiance.png, lens.png and loss.png.

    Raises
    ------
    Refused
        If the session cannot be read or holds no lens, or the folder cannot be written.
    """
    session, _ = read_designed(path)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        from workbench.pictures import write_pictures  # late: draws, which takes long to import

        write_pictures(session, folder)
    except OSError as error:
        reason = error.strerror or error
        raise Refused(str(folder), f"pictures cannot be written there: {reason}") from error
