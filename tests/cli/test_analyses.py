"""Commands that analyse a lens: manufacture, and the bound of a task."""

import json
import math

import numpy as np
import pytest

from tests.accounts import result_of
from workbench.files.session import Session, write_session
from workbench.geometry.surface import ControlNet

GRID = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.3, 0.3], "points": [50, 50]}


@pytest.fixture
def extended(tmp_path, scene_data):
    path = tmp_path / "extended.json"
    path.write_text(json.dumps(scene_data | {"source": GRID}))
    return path


def test_json_has_the_bound_and_its_assumptions(freeform, extended):
    status, stdout, stderr = freeform("bound", extended, "--json")
    assert (status, stderr) == (0, "")
    found = json.loads(stdout)
    assert 0 < found["relative_l2_bound"] <= found["relative_l2_reached"] < 1
    assert 0 < found["relative_l2_half_as_wide"] < found["relative_l2_bound"]
    assert 0 < found["on_target_bound"] <= found["efficiency_bound"] <= 1
    assert any("one blur over the whole lens" in each for each in found["assumptions"])
    (limit,) = found["light_limits"]
    assert 0 < limit["most"] <= limit["turned"] <= limit["passes"] < limit["meets"] < 1


@pytest.fixture(autouse=True)
def few_places(monkeypatch):
    monkeypatch.setattr("workbench.analysis.manufacture._PARTS", 32)
    monkeypatch.setattr("workbench.cli.manufacture._SAMPLES", 65)


@pytest.fixture
def bowl(make_scene, tmp_path):
    """A session with a lens that is 0.2 x² thicker beside the middle."""
    scene = make_scene()
    x, _ = ControlNet.of(scene.optic).positions
    heights = 0.5 + 0.2 * x[:, None] ** 2 + np.zeros((12, 10))
    image = np.ones((32, 32))
    path = tmp_path / "bowl.freeform"
    write_session(Session(scene, image, result_of(heights, image)), path)
    return path


def test_figures(freeform, bowl):
    status, stdout, stderr = freeform("manufacture", bowl, "--json")
    assert (status, stderr) == (0, "")
    found = json.loads(stdout)
    assert found["unit"] == "cm"
    assert [(v["limit"], v["state"]) for v in found["limits"]] == [(0.05, "met")]  # the scene's
    assert found["thickest"]["value"] == pytest.approx(0.7)
    assert found["tightest_convex"]["value"] is found["tightest_convex"]["bound"] is None
    assert found["draft"] == pytest.approx(90 - math.degrees(math.atan(0.4)), abs=1.0)
    status, stdout, _ = freeform("manufacture", bowl)
    assert status == 0
    assert "convex radius     -\n" in stdout
