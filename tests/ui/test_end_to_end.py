"""The installed program, driven from outside by keyboard and mouse on a screen of its own."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.soak.screen import SIZE, Screen, needs_hands, virtual_screen, wait_for
from workbench.files.session import read_session

pytestmark = [needs_hands, pytest.mark.full, pytest.mark.usefixtures("kernels")]

BIN = Path(sys.executable).parent
TITLE = "Freeform Lens Workbench"
SCENE = {
    "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [16, 16]},
    "source": {"kind": "collimated", "rays": [64, 64]},
    "screen": {"z": 5, "half_width": [1, 1], "pixels": [32, 32]},
    "target": {"builtin": "tophat", "radius": 0.6},
    "run": {"method": "paper", "iterations": 1_000_000},
}

# Where a field stands, reported by a window of the same size with the same scene.
FIND = """
import sys
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication
from ui import app
from ui.document.document import Document
from ui.main_window import MainWindow
from workbench.files.session import open_design
from pathlib import Path
application = app._application()
scene, settings, path = sys.argv[1:]
window = MainWindow(
    Document(open_design(Path(scene)), "scene"), QSettings(settings, QSettings.Format.IniFormat)
)
window.show()
application.processEvents()
rows = [row for panel in window.forms.panels for row in panel.rows]
editor = next(row for row in rows if row.path == path).editors[path]
place = editor.mapTo(window, editor.rect().center())
print(place.x(), place.y(), flush=True)
window.discard_and_close()
"""


@pytest.fixture
def screen(tmp_path):
    folder = tmp_path / "screen"
    folder.mkdir()
    with virtual_screen(folder) as screen:
        screen.environment["XDG_CONFIG_HOME"] = str(tmp_path / "settings")
        yield screen


@pytest.fixture
def scene(tmp_path):
    file = tmp_path / "scene.json"
    file.write_text(json.dumps(SCENE))
    return file


def place_of(path: str, scene: Path, screen: Screen) -> list[str]:
    settings = scene.with_suffix(".ini")
    found = subprocess.run(
        [sys.executable, "-c", FIND, scene, settings, path],
        env=screen.environment,
        capture_output=True,
        text=True,
    )
    assert found.returncode == 0, found.stderr
    return found.stdout.split()


def three_dimensional(screen: Screen) -> bool:
    """Whether the place of the 3D scene is shaded, as a placeholder is not."""
    middle = screen.pixels()[SIZE[1] * 5 // 8 : SIZE[1] * 7 // 8, SIZE[0] // 3 : SIZE[0] // 2]
    _, counts = np.unique(middle.reshape(-1, 3), axis=0, return_counts=True)
    return bool(counts.max() < counts.sum() / 2)


def test_a_lens_is_designed_and_saved_by_hand(scene, screen, tmp_path):
    place = place_of("images[0].target.radius", scene, screen)
    saved = tmp_path / "by-hand.freeform"
    process = subprocess.Popen(
        [BIN / "freeform-workbench", scene],
        env=screen.environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    try:
        screen.focus(TITLE)
        wait_for(lambda: three_dimensional(screen), "the 3D scene")
        screen.do("mousemove", *place, "click", "--repeat", 3, "--delay", 50, 1)
        screen.do("type", "0.45")
        screen.do("key", "Return", "F5")
        wait_for(screen.moves, "a run that shows")
        screen.do("key", "F6")
        wait_for(screen.rests, "the run to pause")
        screen.do("key", "F6")
        wait_for(screen.moves, "the run to go on")
        screen.do("key", "F7")
        wait_for(screen.rests, "the run to stop")
        screen.do("key", "ctrl+shift+s")
        screen.focus("Save as")
        screen.do("type", saved)
        screen.do("key", "Return")
        wait_for(saved.exists, "the file")
        screen.focus(TITLE)
        screen.do("key", "ctrl+q")
        received, _ = process.communicate(timeout=60)
    finally:
        process.kill()
        process.wait()
    assert (process.returncode, received) == (0, "")
    session = read_session(saved)
    assert session.scene.target.radius == 0.45
    assert 0 < session.result.iterations < SCENE["run"]["iterations"]
    check = [BIN / "freeform", "validate", saved, "--rays", "1000000", "--json"]
    done = subprocess.run(check, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    figures = json.loads(done.stdout)
    assert 0 < figures["relative_l2"] < 0.8
    assert 0.2 < figures["efficiency"] <= 0.93
    assert figures["ledger"]["emitted"] == pytest.approx(
        sum(part for name, part in figures["ledger"].items() if name != "emitted"), abs=1e-9
    )
