"""A person at the real window: finds what is seen by its name, and uses mouse and keyboard.

The program runs as it is started, with ``SeenWidgets`` added, which writes down what is seen: text
and place of each widget. All input comes from outside the program, by xdotool.
"""

import json
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from PIL import Image
from PySide6.QtCore import QObject, QPoint, QTimer
from PySide6.QtGui import QRegion
from PySide6.QtWidgets import QAbstractScrollArea, QApplication, QListWidget, QWidget

from tests.soak.screen import Screen
from ui import app

_EVERY_MS = 200
_STEPS_OF_DRAG = 5


class SeenWidgets(QObject):
    """Writes what is seen of all windows to a file, now and then."""

    def __init__(self, file: Path, application: QApplication) -> None:
        super().__init__(application)
        self._file = file
        self._look = QTimer(self, interval=_EVERY_MS)
        self._look.timeout.connect(self._write)
        self._look.start()

    def stop(self) -> None:
        """Look no more: it takes the program some time."""
        self._look.stop()

    def _write(self) -> None:
        seen = [
            entry
            for top in QApplication.topLevelWidgets()
            if top.isVisible()
            for widget in [top, *top.findChildren(QWidget)]
            if widget.isVisible() and not _seen(widget).isEmpty()
            for entry in _entries(widget)
        ]
        passing = self._file.with_suffix(".new")
        passing.write_text(json.dumps(seen))
        passing.replace(self._file)


def _seen(widget: QWidget) -> QRegion:
    """What is seen of a widget; a table without frame and bars is all covered by its viewport."""
    seen = widget.visibleRegion()
    if seen.isEmpty() and isinstance(widget, QAbstractScrollArea):
        return widget.viewport().visibleRegion()
    return seen


def _entries(widget: QWidget) -> list[dict[str, Any]]:
    ratio, area = widget.devicePixelRatioF(), _seen(widget).boundingRect()
    found = [(_text(widget), area)]
    if isinstance(widget, QListWidget):
        rows = [widget.item(row) for row in range(widget.count())]
        found += [(row.text(), widget.visualItemRect(row)) for row in rows]
    entries = []
    for text, part in found:
        corner = widget.mapToGlobal(QPoint(0, 0)) + part.topLeft()
        place = [corner.x(), corner.y(), part.width(), part.height()]
        entries.append(
            {
                "kind": type(widget).__name__,
                "text": text,
                "name": widget.accessibleName(),
                "place": [round(ratio * each) for each in place],
                "enabled": widget.isEnabled(),
                "window": widget.window().windowTitle(),
            }
        )
    return entries


def _text(widget: QWidget) -> str:
    for name in ("text", "currentText", "windowTitle"):
        text = getattr(widget, name, None)
        if callable(text) and (found := text()):
            return str(found)
    return ""


class Hand:
    """Starts the program with an empty home folder, and uses it.

    Parameters
    ----------
    screen : Screen
        Where it is started.
    folder : Path
        For its home folder, its log, and pictures.
    scale : str
        Factor of the user interface.
    theme : str
        "light" or "dark".
    program : sequence, optional
        Module and its arguments; by default this one, which writes down what is seen.
    language : str
        Code of that which the program speaks.

    Attributes
    ----------
    steps : int
        Clicks, keys and words typed so far.
    """

    def __init__(
        self,
        screen: Screen,
        folder: Path,
        scale: str = "1",
        theme: str = "light",
        program: Sequence[object] = (),
        language: str = "en",
    ) -> None:
        self._screen, self.folder = screen, folder
        self.steps = 0
        self._file = folder / "seen.json"
        home = folder / "home"
        settings = home / ".config" / "freeform-workbench" / "freeform-workbench.conf"
        settings.parent.mkdir(parents=True, exist_ok=True)
        settings.write_text(f"[window]\ntheme={theme}\nlanguage={language}\n")
        environment = {
            name: value for name, value in screen.environment.items() if "XDG" not in name
        }
        environment |= {"HOME": str(home), "QT_SCALE_FACTOR": scale}
        self._log = (folder / "program.log").open("w")
        self.program = subprocess.Popen(
            [sys.executable, "-m", *map(str, program or ("tests.soak.hand", self._file))],
            env=environment,
            stdout=self._log,
            stderr=subprocess.STDOUT,
        )

    def close(self) -> None:
        """End the program."""
        self.program.terminate()
        self.program.wait(60)
        self._log.close()

    def seen(self) -> list[dict[str, Any]]:
        """All that is seen now."""
        try:
            found: list[dict[str, Any]] = json.loads(self._file.read_text())
        except FileNotFoundError:
            return []
        return found

    def find(self, text: str, kind: str = "", window: str = "") -> dict[str, Any] | None:
        """What is seen with this text or name in a window, mnemonics left out."""
        for each in self.seen():
            words = (each["text"].replace("&", ""), each["name"])
            if text in words and kind in each["kind"] and window in each["window"]:
                return each
        return None

    def having(self, part: str) -> str:
        """The text of the first label that has this part; empty if none has."""
        return next((each["text"] for each in self.seen() if part in each["text"]), "")

    def wait(
        self, text: str, seconds: float = 60.0, kind: str = "", window: str = ""
    ) -> dict[str, Any]:
        """Wait until something of this text or name can be used."""
        found: dict[str, Any] = self.until(
            lambda: (seen := self.find(text, kind, window)) and seen["enabled"] and seen,
            text,
            seconds,
        )
        return found

    def until(self, condition: Any, what: str, seconds: float = 60.0) -> Any:
        """Wait until a condition holds; its value."""
        give_up = time.monotonic() + seconds
        while not (found := condition()):
            assert self.program.poll() is None, f"the program has ended while waiting for {what}"
            assert time.monotonic() < give_up, f"waited in vain for {what}"
            time.sleep(0.1)
        return found

    def click(self, text: str, kind: str = "", times: int = 1, window: str = "") -> None:
        """Click in the middle of something."""
        found = self.wait(text, kind=kind, window=window)
        self.click_at(*middle(found["place"]), times=times)

    def click_at(self, x: int, y: int, times: int = 1) -> None:
        """Click somewhere."""
        self.steps += 1
        self._screen.do("mousemove", x, y)
        time.sleep(0.1)
        self._screen.do("click", "--repeat", times, "--delay", 60, 1)
        time.sleep(0.3)

    def press(self, *keys: str) -> None:
        """Press keys, one after the other."""
        for key in keys:
            self.steps += 1
            self._screen.do("key", key)
            time.sleep(0.1)
        time.sleep(0.3)

    def fill(self, name: str, text: str, kind: str = "QLineEdit") -> None:
        """Type into a field in place of what it holds, and enter it."""
        self.click(name, kind, times=3)
        self.type(text)

    def type(self, text: str, enter: str = "Tab") -> None:
        """Type into the field that has the keyboard, in place of what it holds, and enter it."""
        self.press("ctrl+a")
        self.steps += 1
        self._screen.do("type", "--delay", 15, text)
        time.sleep(0.3)
        self.press(enter)

    def drag(self, start: tuple[int, int], end: tuple[int, int]) -> None:
        """Drag with the left button."""
        self.steps += 1
        (x, y), (across, down) = start, (end[0] - start[0], end[1] - start[1])
        self._screen.do("mousemove", x, y)
        self._screen.do("mousedown", 1)
        for part in range(1, _STEPS_OF_DRAG + 1):
            time.sleep(0.08)
            way = part / _STEPS_OF_DRAG
            self._screen.do("mousemove", round(x + way * across), round(y + way * down))
        self._screen.do("mouseup", 1)
        time.sleep(0.3)

    def focus(self, title: str) -> None:
        """Give a window the keyboard, as a window manager would."""
        self._screen.focus(title)
        time.sleep(0.2)

    def fill_screen(self, title: str) -> None:
        """Make windows as large as the screen, as a window manager would."""
        height, width, _ = self._screen.pixels().shape
        for window in self._screen.do("search", "--onlyvisible", "--name", title).split():
            self._screen.do("windowmove", window, 0, 0)
            self._screen.do("windowsize", window, width, height)

    def picture(self, name: str) -> Path:
        """Keep what is on the screen."""
        time.sleep(0.4)
        path = self.folder / f"{name}.png"
        Image.fromarray(self._screen.pixels()[..., ::-1]).save(path)
        return path


def middle(place: list[int]) -> tuple[int, int]:
    """The middle of a place, as `Hand.seen` gives it."""
    x, y, width, height = place
    return x + width // 2, y + height // 2


def main() -> int:
    """Run the program, and write down what is seen."""
    (file,) = sys.argv[1:]
    make = app._application

    def with_sight() -> QApplication:
        application = make()
        SeenWidgets(Path(file), application)
        return application

    app._application = with_sight
    return app.main([])


if __name__ == "__main__":
    sys.exit(main())
