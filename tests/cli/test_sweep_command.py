import json
import subprocess
import sys
import time
from pathlib import Path

import pytest

FREEFORM = Path(sys.executable).with_name("freeform")
FEW = ("--validate-rays", 10_000)


@pytest.fixture
def scene_file(tmp_path, scene_data):
    scene_data["run"] = {"method": "paper", "iterations": 1}
    path = tmp_path / "hat.json"
    path.write_text(json.dumps(scene_data))
    return path


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "out"


@pytest.fixture
def here(monkeypatch):
    """Have sweeps of this process work in it."""
    from workbench.sweep.processes import attempt

    class Here:
        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def work(self, tasks):
            return ((key, attempt(task)) for key, task in tasks)

    monkeypatch.setattr("workbench.sweep.processes.Processes.of", lambda *_: Here())


@pytest.mark.usefixtures("here")
class TestTable:
    def test_figures_are_those_of_the_check(self, freeform, scene_file, folder):
        stdout = freeform("sweep", scene_file, "-o", folder, *FEW, "--json")[1]
        (point,) = json.loads(stdout)["points"]
        session = folder / point["session"]
        check = json.loads(freeform("validate", session, "--rays", FEW[1], "--json")[1])
        for name in ("loss", "relative_l2", "relative_l2_corrected", "efficiency"):
            assert point["figures"][name] == check[name]

    def test_ctrl_c_keeps_what_is_finished(self, freeform, scene_file, folder, monkeypatch):
        from workbench.sweep import sweep

        def interrupted(*arguments):
            for found in sweep.sweep(*arguments):
                yield found
                raise KeyboardInterrupt

        monkeypatch.setattr("workbench.cli.sweep.sweep_all", interrupted)
        status, stdout, stderr = freeform(
            "sweep", scene_file, "--vary", "run.seed=0..2", "-o", folder, *FEW, "--json"
        )
        assert status == 130
        assert len(json.loads(stdout)["points"]) == 1
        assert "interrupted; 1 of 3 points are finished" in stderr

    def test_another_sweep_in_the_folder_is_refused(self, freeform, scene_file, folder):
        from workbench.sweep.sweep import Store

        with Store(folder).locked():
            status, stdout, stderr = freeform("sweep", scene_file, "-o", folder, *FEW)
        assert (status, stdout) == (2, "")
        assert stderr.startswith(f"freeform: {folder}: another sweep is at work in this folder; ")
        assert freeform("sweep", scene_file, "-o", folder, *FEW)[0] == 0

    def test_a_point_that_fails_is_a_row(self, freeform, scene_file, folder):
        vary = ("--vary", "lens.back.control_points=3,12")
        status, stdout, stderr = freeform("sweep", scene_file, *vary, "-o", folder, *FEW)
        assert status == 1
        assert "1 of 2 points have no lens" in stderr.splitlines()[-1]
        assert "3 is too few for degree 3" in stdout


def children(process):
    found = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
    return [Path(f"/proc/{child}") for child in found.split()]


def finished(folder):
    """Files of figures and when they were written."""
    return {path: path.stat().st_mtime_ns for path in folder.glob("hat-*.json")}


def ends(workers):
    deadline = time.monotonic() + 20
    while any(worker.exists() for worker in workers) and time.monotonic() < deadline:
        time.sleep(0.05)
    return not any(worker.exists() for worker in workers)


@pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc")
@pytest.mark.usefixtures("here")
def test_a_killed_sweep_resumes_where_it_was(freeform, scene_file, folder):
    vary = ("--vary", "run.seed=0..1", "--vary", "run.iterations=1,2")
    command = ["sweep", scene_file, *vary, "-o", folder, *map(str, FEW), "--jobs", "1", "--json"]
    with subprocess.Popen([FREEFORM, *command], stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr.readline().startswith("1/4  hat run.seed=0 run.iterations=1: error")
        workers = children(process)
        process.kill()
    assert workers
    assert ends(workers)
    before = finished(folder)
    assert 1 <= len(before) < 4
    status, stdout, _ = freeform(*command)
    assert status == 0
    assert len(json.loads(stdout)["points"]) == 4
    assert before.items() <= finished(folder).items()
    assert len(list(folder.glob("*.freeform"))) == 4
