"""Sessions that commands need a lens of."""

from pathlib import Path

from workbench.design.session import result_of
from workbench.design.snapshot import Result
from workbench.files.session import Session, read_session


def read_designed(path: Path) -> tuple[Session, Result]:
    """Read a session and its result.

    Raises
    ------
    Refused
        If it cannot be read or has no result.
    """
    session = read_session(path)
    return session, result_of(session, str(path))
