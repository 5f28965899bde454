"""Exports from the window: written beside it, reported with their measured error."""

import dataclasses
import itertools
import re
import threading

import pytest
import trimesh
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QInputDialog, QMessageBox

from workbench.design.limits import HeightLimits
from workbench.files.export.cut_plan import planning
from workbench.files.export.design import Design
from workbench.files.export.options import Chosen, Cutting
from workbench.progress import finished


@pytest.fixture
def window(open_window, designed):
    return open_window(designed)


def export(window, path, qtbot, monkeypatch):
    monkeypatch.setattr(window.dialogs, "to_save", lambda *_: path)
    window.commands["export"].trigger()
    qtbot.waitUntil(lambda: not window.exporter.background.busy, timeout=60_000)


def test_a_file_is_written_and_its_deviation_shown(window, tmp_path, qtbot, monkeypatch):
    for name in ("lens.step", "lens.dat", "lens.irradiance.npy"):
        path = tmp_path / name
        export(window, path, qtbot, monkeypatch)
        assert path.stat().st_size > 0
        received = window.messages.text
        assert received.startswith(f"{path}: ")
        assert re.search(r"\d", received.removeprefix(str(path)))
        assert window.log.toPlainText().endswith(received)


def test_a_file_that_cannot_be_written_is_reported(window, tmp_path, qtbot, monkeypatch):
    for name in ("lens.docx", "no/lens.step"):
        export(window, tmp_path / name, qtbot, monkeypatch)
        assert str(tmp_path / name.split("/")[0]) in window.messages.text
        assert window.messages.notices[-1].kind == "warning"
        assert not (tmp_path / name).exists()


@pytest.fixture
def train(open_window, designed):
    """A window with two designed lenses of different size."""
    lens = designed.scene.elements[0]
    second = lens.model_copy(
        update={"name": "second", "half_width": (1.5, 1.5), "position": (0.0, 0.0, 2.0)}
    )
    scene = designed.scene.model_copy(update={"elements": (lens, second)})
    result = designed.result
    heights = {face: each.undesigned for face, each in HeightLimits.of_scene(scene).items()}
    result = dataclasses.replace(result, state=dataclasses.replace(result.state, heights=heights))
    return open_window(dataclasses.replace(designed, scene=scene, result=result))


def answer(choose):
    """Answer dialogs that open, one after the other, by functions of them."""

    def look():
        dialog = QApplication.activeModalWidget()
        if dialog is None:
            QTimer.singleShot(20, look)
        else:
            choose.pop(0)(dialog)
            if choose:
                QTimer.singleShot(20, look)

    QTimer.singleShot(20, look)


def test_the_element_of_a_file_is_chosen_where_several_are_designed(
    train, tmp_path, qtbot, monkeypatch
):
    def chosen(text):
        def choose(dialog):
            assert isinstance(dialog, QInputDialog)
            dialog.setTextValue(text)
            dialog.accept()

        return choose

    sizes = {}
    for name in ("lens", "second"):
        answer([chosen(name)])
        export(train, tmp_path / f"{name}.dat", qtbot, monkeypatch)
        sizes[name] = (tmp_path / f"{name}.dat").read_text().split()[2]
    assert float(sizes["second"]) == pytest.approx(1.5 * float(sizes["lens"]))
    answer([chosen("all, one file each")])
    export(train, tmp_path / "all.face.step", qtbot, monkeypatch)
    files = {tmp_path / f"all.{name}.face.step" for name in ("lens", "second")}
    assert set(tmp_path.glob("all*")) == files
    before = [each.stat().st_mtime_ns for each in sorted(files)]
    answer([chosen("all, one file each"), lambda box: box.button(QMessageBox.No).click()])
    export(train, tmp_path / "all.face.step", qtbot, monkeypatch)
    assert [each.stat().st_mtime_ns for each in sorted(files)] == before
    answer([lambda dialog: dialog.reject()])
    export(train, tmp_path / "left.stl", qtbot, monkeypatch)
    assert not (tmp_path / "left.stl").exists()
    export(train, tmp_path / "light.irradiance.npy", qtbot, monkeypatch)  # asks nothing
    assert (tmp_path / "light.irradiance.npy").exists()


def test_a_test_tile_is_an_option_of_meshes(window, tmp_path, qtbot, monkeypatch):
    path = tmp_path / "tile.stl"
    answer([lambda dialog: (dialog.fields[0].enter(tile_side=0.5, tile_x=-0.2), dialog.accept())])
    export(window, path, qtbot, monkeypatch)
    assert trimesh.load_mesh(path).bounds[:, 0] == pytest.approx([-4.5, 0.5], abs=1e-4)
    assert "test tile, lengths in mm" in window.messages.text


@pytest.fixture
def held(monkeypatch):
    """An export that goes on until it is let."""
    release = threading.Event()

    def write(session, files, chosen, mesh_unit, lens, task):
        assert release.wait(30)
        task.outcome = f"written; {lens}"

    monkeypatch.setattr("ui.files.exporter._write", write)
    yield release
    release.set()


def test_the_window_stays_responsive_and_exports_one_file_at_a_time(window, held, tmp_path, qtbot):
    ticks = []
    timer = QTimer(interval=5)
    timer.timeout.connect(lambda: ticks.append(1))
    timer.start()
    window.exporter.export(tmp_path / "one.step")
    (entry,) = window.early.shelf.entries
    assert entry.task.title == "Export one.step"
    qtbot.waitUntil(lambda: len(ticks) > 5)
    window.exporter.export(tmp_path / "two.step")
    assert "still being written" in window.messages.text
    timer.stop()
    held.set()
    qtbot.waitUntil(lambda: entry.outcome.text().startswith("written; this lens"))


def test_the_writing_of_g_code_shows_its_progress_and_can_be_cancelled(
    window, designed, tmp_path, qtbot, monkeypatch
):
    cutting = Cutting(tool_radius=0.2, scallop=0.002)
    plan = finished(planning(Design(designed.scene, designed.result, options=(cutting,))))
    begun = threading.Event()

    def endless(design, file):
        for part in itertools.chain([0.4], itertools.repeat(0.5)):
            yield part
            begun.set()

    with monkeypatch.context() as changed:
        changed.setattr("workbench.files.export.gcode.writing", endless)
        path = tmp_path / "lens.nc"
        window.exporter._write(designed, {path: "lens"}, Chosen(plan=plan))
        (entry,) = window.early.shelf.entries
        qtbot.waitUntil(lambda: entry.part.text() == "50 %" and begun.is_set())
        entry.cancel.click()
        qtbot.waitUntil(lambda: entry.outcome.text() == "No file was written.")
        assert list(tmp_path.glob("*lens*")) == []
    window.exporter._write(designed, {path: "lens"}, Chosen(plan=plan))
    qtbot.waitUntil(lambda: str(path) in window.messages.text)
    assert path.read_text().endswith("M5\nM30\n")
