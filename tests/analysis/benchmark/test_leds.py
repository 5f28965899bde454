"""Light of an LED on a rectangle."""

import pytest

from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.analysis.benchmark.leds import designed, table

SMALL = {"run.iterations": 2, "images[0].receiver.pixels": [29, 14]}
FRONT = {"shape": "bspline", "control_points": [8, 6], "height_range": [-2.0, 2.0]}


@pytest.mark.parametrize("plane_exit", [False, True])
def test_a_lens_is_checked_where_the_target_is_bright(plane_exit, monkeypatch):
    monkeypatch.setattr("workbench.analysis.benchmark.leds._RAYS", 200_000)
    lens = {"lens.back.control_points": [12, 8], "lens.front": FRONT}
    example = BenchmarkTask.of("led-rectangle", changes=lens | SMALL)
    progress = []
    found = designed("led", example, plane_exit, lambda *state: progress.append(state))
    assert 0.2 < found.efficiency < 0.9
    assert 0.05 < found.deviation < 1.5
    assert found.merit == pytest.approx(found.efficiency * (1 - found.deviation))
    assert progress[0] == ("led", "iteration 0") and progress[-1] == ("led", "its check")
    assert "| led | " in table([found]).to_markdown()
