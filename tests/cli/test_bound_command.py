import json

import pytest

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
