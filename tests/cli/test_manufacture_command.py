import json
import math

import numpy as np
import pytest

from workbench.design.snapshot import Result
from workbench.files.session import Session, write_session
from workbench.geometry.surface import ControlNet
from workbench.optics.ledger import Ledger


@pytest.fixture(autouse=True)
def few_places(monkeypatch):
    monkeypatch.setattr("workbench.analysis.manufacture._PARTS", 32)
    monkeypatch.setattr("workbench.cli.manufacture._PLACES", 65)


@pytest.fixture
def bowl(make_scene, tmp_path):
    """A session with a lens that is 0.2 x² thicker beside the middle."""
    scene = make_scene()
    x, _ = ControlNet.of(scene.lens).positions
    heights = 0.5 + 0.2 * x[:, None] ** 2 + np.zeros((12, 10))
    image = np.ones((32, 32))
    ledger = Ledger(1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    path = tmp_path / "bowl.freeform"
    write_session(Session(scene, image, Result(heights, image, np.ones(1), 1, 1, ledger)), path)
    return path


def test_figures(freeform, bowl):
    status, printed, told = freeform("manufacture", bowl, "--json")
    assert (status, told) == (0, "")
    found = json.loads(printed)
    assert found["unit"] == "cm"
    assert found["limits"] == []
    assert found["thickest"]["value"] == pytest.approx(0.7)
    assert found["tightest_convex"]["value"] is found["tightest_convex"]["bound"] is None
    assert found["draft"] == pytest.approx(90 - math.degrees(math.atan(0.4)), abs=1.0)
    status, printed, _ = freeform("manufacture", bowl)
    assert status == 0
    assert "convex radius     -\n" in printed


def test_limits(freeform, bowl, tmp_path):
    plot = tmp_path / "maps.png"
    given = "manufacture", bowl, "--min-thickness", 0.45, "--max-slope", 10
    status, printed, told = freeform(*given, "--plot", plot)
    assert status == 1
    assert told.startswith("freeform: slope 21")
    assert told.endswith("at most 10° wanted\n")
    assert "thickness at least 0.45 cm: met\n" in printed
    assert "slope at most 10°: NOT MET\n" in printed
    assert plot.read_bytes().startswith(b"\x89PNG")
    status, printed, _ = freeform(*given, "--json")
    assert status == 1
    assert [v["state"] for v in json.loads(printed)["limits"]] == ["met", "broken"]
    status, _, told = freeform("manufacture", bowl, "--min-radius", 1.0, "--max-thickness", 0.8)
    assert (status, told) == (0, "")


@pytest.mark.parametrize("value", ["0", "-1", "inf", "thin"])
def test_impossible_limits_are_refused(freeform, bowl, value):
    status, _, told = freeform("manufacture", bowl, "--min-radius", value)
    assert status == 2
    assert told.count("\n") == 1
