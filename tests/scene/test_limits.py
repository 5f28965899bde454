"""Magnitudes that cannot be computed with are refused in a sentence; those at the limits work."""

import math

import numpy as np
import pytest
import torch

from workbench.analysis.validation import validate
from workbench.errors import Refused, RunFailed
from workbench.optics.plan import Plan

POINT = {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 500}
GRID = {"kind": "grid", "center": [0, 0, -5], "half_width": [1, 1], "points": [3, 2], "rays": 100}


LENGTHS = (
    "lens.half_width[0]",
    "lens.half_width[1]",
    "lens.entrance_z",
    "lens.base.height",
    "lens.base.radius",
    "lens.height_range[0]",
    "lens.height_range[1]",
    "lens.max_thickness",
    "lens.min_thickness",
    "lens.refractive_index",
    "screen.z",
    "screen.half_width[0]",
    "run.min_radius",
    "run.min_tool_radius",
    "source.position[0]",
    "source.position[2]",
    "source.center[1]",
    "source.half_width[0]",
)


@pytest.mark.parametrize("value", [1e13, 1e155, 1.7e308])
def test_too_large_a_number_is_refused_where_it_stands(make_scene, value):
    assert [refused_with(make_scene, path, value) for path in LENGTHS] == [*LENGTHS]


def refused_with(make_scene, path, value):
    """The path that is refused in a scene with a value at a path."""
    field, _, index = path.rstrip("]").partition("[")
    source = POINT if "position" in path else GRID if "source" in path else None
    changes = {"source": dict(source)} if source else {}
    if path == "lens.base.radius":
        changes["lens.base"] = {"shape": "sphere", "height": 0.5, "radius": value}
    elif index:
        pair = {"lens.half_width": [1, 1], "lens.height_range": [-0.3, 0.3]}
        pair |= {"screen.half_width": [1, 1], "source.half_width": [1, 1]}
        pair |= {"source.position": [0, 0, -5], "source.center": [0, 0, -5]}
        numbers = list(pair[field])
        numbers[int(index)] = -value if numbers[int(index)] < 0 else value
        changes[field] = numbers
    else:
        changes[field] = value
    with pytest.raises(Refused) as refused:
        make_scene(changes)
    return refused.value.path


@pytest.mark.parametrize(
    ("changes", "path"),
    [
        ({"lens.half_width": [1e-200, 1e-200]}, "lens.half_width[0]"),
        ({"lens.half_width": [1.0, 1e-4]}, "lens.half_width[1]"),
        ({"source": POINT | {"position": [0, 0, -1e-200]}}, "source.position[2]"),
        ({"source": GRID | {"center": [0, 0, -1e-11]}}, "source.center[2]"),
    ],
)
def test_too_small_a_number_is_refused_with_what_is_possible(make_scene, changes, path):
    with pytest.raises(Refused, match=r"from .* to|at least") as refused:
        make_scene(changes)
    assert refused.value.path == path


@pytest.mark.parametrize(
    ("scale", "distance", "aside", "index"),
    [  # each value beside each value of every other limit
        (1e-6, 1e-10, 0.0, 1.0003),
        (1e-6, 1e-3, 0.7, 1.5),
        (1e-6, 3e11, 3.0, 10.0),
        (1.0, 1e-10, 0.7, 10.0),
        (1.0, 1e-3, 3.0, 1.0003),
        (1.0, 3e11, 0.0, 1.5),
        (1e6, 1e-10, 3.0, 1.5),
        (1e6, 1e-3, 0.0, 10.0),
        (1e6, 3e11, 0.7, 1.0003),
    ],
)
def test_at_the_limits_the_account_adds_up(make_scene, scale, distance, aside, index):
    way = max(distance, 1.0)
    position = [aside * way * scale, 0.0, -distance * scale]
    scene = make_scene(
        {
            "lens.half_width": [scale, scale],
            "lens.refractive_index": index,
            "lens.base": {"shape": "flat", "height": 0.5 * scale},
            "lens.height_range": [-0.3 * scale, 0.3 * scale],
            "lens.min_thickness": 0.05 * scale,
            "screen": {"z": 5 * scale, "half_width": [9 * scale, 9 * scale], "pixels": [8, 8]},
            "source": POINT | {"position": position},
        }
    )
    heights = torch.full((12, 10), 0.5 * scale, dtype=torch.float64)
    accounts = [
        Plan(scene, samples=samples).trace({"lens.back": heights}).account
        for samples in (None, (64, 64))
    ]
    try:
        accounts.append(
            validate(scene, np.ones((8, 8)), {"lens.back": heights.numpy()}, 4096).account
        )
    except RunFailed:  # light so flat that none comes to the screen
        assert aside > 0
    for account in accounts:
        emitted, *parts = account.to_data().values()
        assert all(math.isfinite(part) for part in parts)
        assert sum(parts) == pytest.approx(emitted, abs=1e-5)
        assert -1e-6 < account.efficiency < 1
