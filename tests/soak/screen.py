"""A virtual screen that a program has for itself, seen and used from outside the program."""

import os
import shutil
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

SIZE = (1600, 1000)
_PATIENCE = 60.0  # seconds, on a machine that does much else

needs_screen = pytest.mark.skipif(
    not shutil.which("Xvfb"), reason="needs Xvfb (Debian package xvfb)"
)
needs_hands = pytest.mark.skipif(
    not (shutil.which("Xvfb") and shutil.which("xdotool")),
    reason="needs Xvfb and xdotool (Debian packages xvfb, xdotool)",
)


class Screen:
    """What is on a virtual screen, and events from its keyboard and mouse.

    Parameters
    ----------
    display : str
        Its name, as in DISPLAY.
    buffer : Path
        The file that the X server draws into.
    """

    def __init__(self, display: str, buffer: Path) -> None:
        self.environment = {**os.environ, "DISPLAY": display, "QT_QPA_PLATFORM": "xcb"}
        self._buffer = buffer

    def pixels(self) -> npt.NDArray[np.uint8]:
        """All that is seen now, of shape (ny, nx, 3)."""
        content = self._buffer.read_bytes()  # an X window dump
        header = np.frombuffer(content, ">u4", 25)
        start = header[0] + 12 * header[19]  # behind header and colours
        width, height, line = int(header[4]), int(header[5]), int(header[12])
        rows = np.frombuffer(content, np.uint8, height * line, start).reshape(height, line)
        return rows[:, : 4 * width].reshape(height, width, 4)[..., :3]

    def do(self, *orders: object) -> str:
        """Have xdotool do something; what it says."""
        command = ["xdotool", *map(str, orders)]
        done = subprocess.run(
            command, env=self.environment, capture_output=True, text=True, timeout=_PATIENCE
        )
        return done.stdout

    def focus(self, title: str) -> None:
        """Wait for a window and give it the keyboard, as a window manager would."""
        found = wait_for(
            lambda: self.do("search", "--onlyvisible", "--name", title).split(), f"window {title}"
        )
        self.do("windowfocus", "--sync", found[-1])

    def moves(self) -> bool:
        """Whether something happens on and on, rather than once, as at the click of a button."""
        return all(self._changes(0.8) for _ in range(3))

    def rests(self) -> bool:
        """Whether nothing happens."""
        return not any(self._changes() for _ in range(3))

    def _changes(self, seconds: float = 0.4, pixels: int = 100) -> bool:
        """Whether more changes than a cursor that blinks."""
        before = self.pixels()
        time.sleep(seconds)
        return int((before != self.pixels()).any(axis=2).sum()) > pixels


@contextmanager
def virtual_screen(folder: Path, size: tuple[int, int] = SIZE) -> Iterator[Screen]:
    """A screen without a window manager, whose picture lies in ``folder``."""
    ready, answer = os.pipe()
    command = ["Xvfb", "-displayfd", answer, "-screen", 0, f"{size[0]}x{size[1]}x24"]
    server = subprocess.Popen(
        [str(word) for word in [*command, "-fbdir", folder]],
        pass_fds=[answer],
        stderr=subprocess.DEVNULL,
    )
    os.close(answer)
    try:
        with os.fdopen(ready) as reported:
            display = reported.readline().strip()
        assert display, "Xvfb did not start"
        yield Screen(f":{display}", folder / "Xvfb_screen0")
    finally:
        server.terminate()
        server.wait()


def wait_for(condition: Callable[[], Any], what: str) -> Any:
    """Wait until something holds; its value."""
    give_up = time.monotonic() + _PATIENCE
    while not (found := condition()):
        assert time.monotonic() < give_up, f"waited in vain for: {what}"
        time.sleep(0.1)
    return found
