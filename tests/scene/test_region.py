"""Regions: what they may be, and that they are no part of what a lens is for."""

import pytest

from tests.scenes import changed
from workbench.errors import Refused
from workbench.scene import Scene

DESK = {"name": "Desk", "shape": "rectangle", "center": [0.1, -0.2], "size": [0.5, 0.25]}
SPOT = {"name": "Spot", "shape": "ellipse", "size": [0.5, 0.25]}
ARROW = {"name": "Arrow", "shape": "polygon", "corners": [[-0.5, -0.5], [0.5, -0.5], [0, 0.5]]}


def with_regions(*regions):
    return Scene.from_data(changed({"regions": list(regions)}))


def test_regions_are_written_as_they_are_read():
    scene = with_regions(DESK, SPOT, ARROW)
    assert Scene.from_data(scene.to_data()) == scene
    assert scene.needed_version == 2
    assert scene.to_data()["regions"][0] == DESK


@pytest.mark.parametrize(
    ("region", "path", "reason"),
    [
        ({**DESK, "size": [0.9, 0.1]}, "size[0]", "at most 0.8 there"),
        ({**DESK, "center": [0.7, 0]}, "center[0]", "at most 0.5"),
        ({**DESK, "shape": "star"}, "", "'star' is not available"),
        ({**ARROW, "corners": [[0, 0], [0.5, 0]]}, "corners", "at least 3"),
        ({**ARROW, "corners": [[0, 0], [0.2, 0], [0.4, 0]]}, "corners", "have no area"),
        (
            {**ARROW, "corners": [[-0.5, -0.5], [0.5, 0.5], [0.5, -0.5], [-0.5, 0.4]]},
            "corners",
            "make sides that cross",
        ),
    ],
)
def test_impossible_regions_are_refused(region, path, reason):
    with pytest.raises(Refused, match=reason) as refused:
        with_regions(SPOT, region)
    assert refused.value.path.startswith(f"regions[1].{path}".rstrip("."))
