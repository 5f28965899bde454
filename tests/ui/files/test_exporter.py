"""Exports from the window: written beside it, told with their measured error."""

import itertools
import re
import threading
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QTimer

from workbench.files.export.design import Design
from workbench.files.export.gcode import planning
from workbench.files.export.options import Cutting
from workbench.progress import finished


@pytest.fixture
def window(open_window, designed):
    return open_window(designed)


def export(window, path, qtbot, monkeypatch):
    monkeypatch.setattr(window.exporter, "ask_for_name", lambda: path)
    window.commands["export"].trigger()
    qtbot.waitUntil(lambda: not window.exporter._background.busy, timeout=60_000)


@pytest.mark.parametrize("name", ["lens.stl", "lens.dat", "lens.irradiance.npy"])
def test_a_file_is_written_and_its_deviation_shown(window, name, tmp_path, qtbot, monkeypatch):
    path = tmp_path / name
    export(window, path, qtbot, monkeypatch)
    assert path.stat().st_size > 0
    received = window.messages.text
    assert received.startswith(f"{path}: ")
    assert re.search(r"\d", received.removeprefix(str(path)))
    assert window.log.toPlainText().endswith(received)


@pytest.mark.parametrize("name", ["lens.docx", "no/lens.stl"])
def test_a_file_that_cannot_be_written_is_reported(window, name, tmp_path, qtbot, monkeypatch):
    export(window, tmp_path / name, qtbot, monkeypatch)
    assert str(tmp_path / name.split("/")[0]) in window.messages.text
    assert window.messages.objectName() == "warning"
    assert not (tmp_path / name).exists()


@pytest.fixture
def held(monkeypatch):
    """An export that goes on until it is let."""
    release = threading.Event()

    def write(session, path, plan, mesh_unit, task):
        assert release.wait(30)
        return SimpleNamespace(sentence="written")

    monkeypatch.setattr("ui.files.exporter._write", write)
    yield release
    release.set()


def test_the_window_stays_responsive_and_exports_one_file_at_a_time(window, held, tmp_path, qtbot):
    ticks = []
    timer = QTimer(interval=5)
    timer.timeout.connect(lambda: ticks.append(1))
    timer.start()
    window.exporter.export(tmp_path / "one.stl")
    assert "Writing one.stl" in window.messages.text
    qtbot.waitUntil(lambda: len(ticks) > 5)
    window.exporter.export(tmp_path / "two.stl")
    assert "still being written" in window.messages.text
    timer.stop()
    held.set()
    qtbot.waitUntil(lambda: window.messages.text.startswith("written; this lens"))


def test_the_writing_of_g_code_shows_its_progress_and_can_be_cancelled(
    window, designed, tmp_path, qtbot, monkeypatch
):
    cutting = Cutting(0.2, 0.002)
    plan = finished(planning(Design(designed.scene, designed.result, cutting=cutting)))
    begun = threading.Event()

    def endless(design, file):
        for part in itertools.chain([0.4], itertools.repeat(0.5)):
            yield part
            begun.set()

    with monkeypatch.context() as changed:
        changed.setattr("workbench.files.export.gcode.writing", endless)
        path = tmp_path / "lens.nc"
        window.exporter.export(path, plan)
        qtbot.waitUntil(lambda: "50" in window.messages.text and begun.is_set())
        (cancel,) = window.messages.buttons
        cancel.click()
        qtbot.waitUntil(lambda: window.messages.text == "No file was written.")
        assert list(tmp_path.glob("*lens*")) == []
    window.exporter.export(path, plan)
    qtbot.waitUntil(lambda: str(path) in window.messages.text)
    assert path.read_text().endswith("M5\nM30\n")
