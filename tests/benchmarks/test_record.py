"""The record of small designs: its scenes, its processes, and what counts as worse."""

import json
from pathlib import Path
from typing import Any

import pytest
import torch

from tests.benchmarks import kernels, record
from tests.benchmarks.measure import measure
from tests.benchmarks.scenes import SCENES, write_scene
from workbench import load
from workbench.analysis.benchmark.examples import BenchmarkTask

BEFORE: dict[str, Any] = {
    "error": 0.02,
    "iterations": 30,
    "seconds": 3.0,
    "step": 0.1,
    "memory": 500.0,
    "efficiency": 0.9,
}


def worse(**after: float) -> list[str]:
    """Names of the figures that are worse after a change."""
    changes = record.compare({"sun": BEFORE}, {"sun": {**BEFORE, **after}})
    assert [change.figure for change in changes] == list(record.FIGURES)
    return [change.figure for change in changes if change.worse]


@pytest.mark.parametrize("name", SCENES)
def test_every_scene_loads_and_is_small(name: str, tmp_path: Path) -> None:
    session = load(write_scene(name, tmp_path))
    assert session.target.max() > 0
    assert max(session.scene.optic.net_shape) <= 48
    assert session.scene.run.iterations <= 40
    assert all((tmp_path / file).is_file() for file in session.scene.light_files)


def test_what_is_worse_than_noise_is_marked() -> None:
    assert worse(error=0.0205, step=0.106) == ["error", "step"]
    assert worse(memory=530.0, efficiency=0.87) == ["memory", "efficiency"]
    assert worse(error=0.0203, step=0.104, efficiency=0.89, iterations=60, seconds=9.0) == []
    assert worse(error=0.01, step=0.05, memory=300.0, efficiency=0.95) == []


def test_a_record_is_written_and_compared(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    found: dict[str, Any] = {"sun": BEFORE, "point": {"failed": "RunFailed: no light"}}
    monkeypatch.setattr(record, "_measured", found.__getitem__)
    before, after = tmp_path / "before.json", tmp_path / "after.json"
    assert record.main(["-o", str(before), "--only", "sun"]) == 0
    assert json.loads(before.read_text())["scenes"] == {"sun": BEFORE}
    assert record.main(["-o", str(after), "--only", "sun", "--compare", str(before)]) == 0
    assert "0 of 6 figures are worse" in capsys.readouterr().out
    assert record.main(["-o", str(after), "--only", "point"]) == 1
    assert "point: failed: RunFailed: no light" in capsys.readouterr().out


def test_a_scene_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    small = SCENES["mirror-collimated"] | {"run": {"iterations": 3}}
    monkeypatch.setitem(SCENES, "mirror-collimated", small)
    found = measure("mirror-collimated")
    assert list(found) == list(record.FIGURES)
    assert found["iterations"] == 3
    assert 0 < found["error"] < 0.2
    assert found["efficiency"] == pytest.approx(0.9, abs=1e-3)
    assert min(found["step"], found["memory"]) > 0


def test_kernels_are_timed_beside_the_reference() -> None:
    example = BenchmarkTask.of("flame", changes={"source.rays": 64, "lens.back.control_points": 12})
    reference, compiled = (kernels.evaluation(example, fused) for fused in (False, True))
    times = kernels.milliseconds({"reference": reference, "kernels": compiled}, rounds=1)
    assert list(times) == ["reference", "kernels"] and min(times.values()) > 0
    torch.testing.assert_close(reference(), compiled(), rtol=1e-3, atol=1e-6)
