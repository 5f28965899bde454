"""The account of unsaved work: what a window held, and what was written of it for a recovery."""

import hashlib
import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QTimer

from ui.files.recovery import Recovery
from workbench.files.session import Session

_LOOK_MS = 250


class Line(NamedTuple):
    """One line of the account.

    Attributes
    ----------
    time : float
        Seconds since 1970.
    name : str
        Of the window's recovery file.
    event : str
        "holds", "writes" or "wrote".
    work : str or None
        Fingerprint of the session; None where all is saved.
    """

    time: float
    name: str
    event: str
    work: str | None


class AccountedRecovery(Recovery):
    """Keeps work as any other does, and writes down what it does.

    Parameters
    ----------
    account : Path
        Where; lines are appended.
    """

    def __init__(self, *arguments, account: Path, every_ms: int) -> None:
        super().__init__(*arguments, every_ms=every_ms)
        self._account = account.open("a", buffering=1)
        self._last: tuple[Session | None, str | None] = (None, None)
        self._looking = QTimer(self, interval=_LOOK_MS)
        self._looking.timeout.connect(self._look)
        self._looking.start()

    def close(self, leave: bool = False) -> None:
        """End keeping and looking."""
        self._looking.stop()
        super().close(leave)
        self._note("holds", None)  # a person has been asked

    def _look(self) -> None:
        session = self._unsaved()
        if session is not self._last[0]:
            self._last = session, None if session is None else fingerprint(session)
        self._note("holds", self._last[1])

    def _write(self, session: Session, *rest) -> None:
        work = fingerprint(session)
        self._note("writes", work)
        super()._write(session, *rest)
        self._note("wrote", work)

    def _note(self, event: str, work: str | None) -> None:
        self._account.write(json.dumps([time.time(), self._file.stem, event, work]) + "\n")


def fingerprint(session: Session) -> str:
    """A short word for a session's content; the same for one that was written and read."""
    data = session.scene.to_data()
    for image in data["images"]:
        image["target"].pop("image", None)  # relative to where it was written
    found = hashlib.sha256(json.dumps(data, sort_keys=True).encode())
    found.update(session.target.tobytes())
    if session.result is not None:
        result = session.result
        for array in (*result.state.heights.values(), result.state.irradiance, result.losses):
            found.update(array.tobytes())
    return found.hexdigest()[:16]


def read_account(file: Path) -> Iterator[Line]:
    """The lines of an account; what was cut off by the end of its process is left out."""
    for line in file.read_text().splitlines():
        try:
            yield Line(*json.loads(line))
        except ValueError:
            continue
