"""The public Python interface: the page, its examples, and the lines that the manual shows."""

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import workbench
from workbench import DesignRun, api, begin, check, export, load, save
from workbench.scene.paths import with_values

ROOT = Path(__file__).parents[1]


def test_the_package_offers_what_the_page_lists():
    assert workbench.__all__ == api.__all__
    for name in api.__all__:
        assert getattr(workbench, name) is getattr(api, name)
    with pytest.raises(ImportError, match="cannot import name 'unheard_of' from 'workbench'"):
        from workbench import unheard_of  # noqa: F401


def test_importing_the_package_loads_nothing_slow_and_the_page_no_torch():
    script = (
        "import sys, workbench; first = set(sys.modules); from workbench import load; "
        "slow = {'torch', 'pyvista', 'matplotlib', 'PySide6'} & set(sys.modules); "
        "print({'numpy', 'pydantic', 'numba', 'workbench.api'} & first, slow)"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.stdout == "set() set()\n", done.stderr


@pytest.mark.usefixtures("fewer_rays")
def test_the_lines_of_the_manual_run_as_they_stand(tmp_path, monkeypatch, capsys):
    page = (ROOT / "resources" / "manual" / "python.md").read_text("utf-8")
    (lines,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    for number, fewer in (("=300", "=2"), ("16_000_000", "100_000")):
        assert lines.count(number) == 1
        lines = lines.replace(number, fewer)
    flame = load(ROOT / "resources" / "examples" / "flame.json").scene
    few = {"lens.back.control_points": 120, "images[0].receiver.pixels": 64}
    folder = tmp_path / "resources" / "examples"
    folder.mkdir(parents=True)
    (folder / "flame.json").write_text(with_values(flame, few).to_json())
    folder.with_name("targets").symlink_to(ROOT / "resources" / "targets")
    monkeypatch.chdir(tmp_path)
    exec(compile(lines, "python.md", "exec"), {})
    *snapshots, error = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in snapshots] == ["0", "1", "2", "2"]
    assert re.fullmatch(r"error \d+\.\d\d%, 92\.\d% on the screen", error)
    made = {file.name: file.stat().st_size for file in tmp_path.glob("flame.*")}
    assert set(made) == {"flame.step", "flame.stl", "flame.freeform"} and min(made.values()) > 1000
    assert load("flame.freeform").result.iterations == 2


@pytest.fixture
def session(make_scene):
    return begin(make_scene())


class TestDesignRun:
    def test_leaving_the_loop_keeps_the_best_lens_so_far(self, session):
        run = DesignRun(session)
        assert run.session is session
        for snapshot in run:
            if snapshot.iteration == 1:
                break
        assert run.session.result.iterations == 1
        assert run.session.result.ended == "stopped"


def test_api_gives_the_figures_of_the_commands(session, tmp_path, capsys):
    """One implementation: the lens, the check and the files are those of the command line."""
    from workbench.cli import main

    scene, one, other = (
        tmp_path / "scene.json",
        tmp_path / "one.freeform",
        tmp_path / "other.freeform",
    )
    scene.write_text(session.scene.to_json())
    run = DesignRun(load(scene), iterations=2)
    for _ in run:
        pass
    save(run.session, one)
    assert main(["design", str(scene), "-o", str(other), "--iterations", "2"]) == 0
    assert np.array_equal(load(one).heights, load(other).heights)
    export(load(one), tmp_path / "one.obj")
    assert main(["export", str(other), str(tmp_path / "other.obj")]) == 0
    assert (tmp_path / "one.obj").read_text() == (tmp_path / "other.obj").read_text()
    capsys.readouterr()
    assert main(["validate", str(other), "--rays", "10000", "--json"]) == 0
    assert f'"relative_l2": {check(load(one), rays=10_000).relative_l2},' in capsys.readouterr().out
