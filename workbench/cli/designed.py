"""Sessions that commands need a lens of."""

from pathlib import Path

from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.files.session import Session, read_session


def read_designed(path: Path) -> tuple[Session, Result]:
    """Read a session and its result.

    Raises
    ------
    Refused
        If it cannot be read or has no result.
    """
    session = read_session(path)
    if session.result is None:
        raise Refused(str(path), "holds no lens yet; freeform design finds one")
    return session, session.result
