"""Sweeps in the window: what is asked, shown, stopped and opened."""

import time

import pytest
from PySide6.QtWidgets import QFileDialog

from workbench.progress import check_interruption
from workbench.sweep.processes import Failed, attempt

pytestmark = pytest.mark.usefixtures("kernels")


@pytest.fixture
def session(make_session):
    return make_session({"run.iterations": 1})


class Here:
    """Works in the thread that asks, so that no process has to start."""

    waits = False  # before each task, until it is to end

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def work(self, tasks):
        for key, task in tasks:
            while self.waits:
                check_interruption()
                time.sleep(0.01)
            if task.scene.run.seed == 7:
                yield key, Failed("stopped at iteration 3: no light")
            else:
                yield key, attempt(task._replace(rays=10_000))


@pytest.fixture
def workers(monkeypatch):
    here = Here()
    monkeypatch.setattr("workbench.sweep.processes.Processes.of", lambda points: here)
    return here


@pytest.fixture
def dialog(window, tmp_path, workers):
    window.commands["sweep"].trigger()
    dialog = window.sweep
    dialog.folder.setText(str(tmp_path / "lenses"))
    return dialog


def choose(dialog, number, path, values):
    field = dialog.form.fields[number]
    field.setCurrentIndex(field.findData(path))
    dialog.form.values[number].setText(values)


def texts(dialog, row):
    cells = (dialog.table.item(row, column) for column in range(dialog.table.columnCount()))
    return [cell.text() for cell in cells if cell is not None]


def test_fields_are_offered_with_what_they_are_now(dialog):
    choose(dialog, 0, "elements[0].faces[1].control_points", "")
    assert dialog.form.fields[0].currentText() == "Elements 1 · Back face · Control points"
    assert dialog.form.values[0].placeholderText() == "now 12 × 10"
    assert dialog.form.fields[0].findData("unit") < 0
    assert dialog.form.fields[1].currentText() == "none"
    assert not dialog.form.values[1].isEnabled()


def test_each_pair_of_values_gets_a_lens_and_a_row(dialog, qtbot, tmp_path):
    choose(dialog, 0, "run.iterations", "1, 2")
    choose(dialog, 1, "run.seed", "3,7")
    with qtbot.waitSignal(dialog.background.done, timeout=60_000):
        dialog.begin.click()
        assert dialog.begin.text() == "Stop" and not dialog.form.isEnabled()
        assert texts(dialog, 3) == ["2", "7", "…"]
    assert dialog.status.text().startswith("4 of 4 designs, ")
    assert dialog.begin.text() == "Start" and dialog.form.isEnabled()
    first = texts(dialog, 0)
    assert first[:2] == ["1", "3"] and first[2].endswith(" %") and first[3].endswith(" %")
    assert texts(dialog, 1)[2] == "stopped at iteration 3: no light"
    qtbot.waitUntil(lambda: not dialog.curve._soon.isActive())
    (axes,) = dialog.curve.figure.axes
    (line, *_) = axes.containers[0]
    assert list(line.get_xdata()) == [1, 2]
    assert f"{line.get_ydata()[0]:.2f} %" == first[2]
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["Run · Seed 3"]
    assert axes.get_xlabel() == "Run · Iterations"
    table = (tmp_path / "lenses" / "table.csv").read_text().splitlines()
    assert len(table) == 5 and table[0].startswith("scene,run.iterations,run.seed,")


def test_a_sweep_that_is_stopped_keeps_what_is_finished_and_goes_on_from_there(
    dialog, workers, qtbot, tmp_path
):
    choose(dialog, 0, "run.seed", "0..2")
    dialog.begin.click()
    qtbot.waitUntil(lambda: len(dialog._rows) >= 1, timeout=60_000)
    workers.waits = True
    with qtbot.waitSignal(dialog.background.done, timeout=60_000):
        dialog.begin.click()
    done = len(dialog._rows)
    assert dialog.status.text().startswith(f"{done} of 3 designs, ")
    kept = set((tmp_path / "lenses").glob("*.freeform"))
    assert len(kept) == done
    workers.waits = False
    with qtbot.waitSignal(dialog.background.done, timeout=60_000):
        dialog.begin.click()
    assert dialog.status.text().startswith("3 of 3 designs, ")
    assert kept <= set((tmp_path / "lenses").glob("*.freeform"))


def test_a_design_without_a_file_is_swept_only_into_a_folder_that_is_chosen(
    window, workers, qtbot, tmp_path, monkeypatch
):
    window.commands["sweep"].trigger()
    dialog = window.sweep
    choose(dialog, 0, "run.seed", "1")
    assert dialog.folder.text() == ""
    chosen = [str(tmp_path / "mine"), ""]
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: chosen.pop())
    dialog.toggle()
    assert "Choose a folder" in dialog.status.text() and not dialog.background.busy
    dialog.toggle()
    qtbot.waitUntil(lambda: len(dialog._rows) == 1, timeout=60_000)
    assert (tmp_path / "mine").is_dir()
