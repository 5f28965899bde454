"""Traces of extreme scenes: finite, without light gained or lost, the same by every way."""

import pytest
import torch
from hypothesis import HealthCheck, given, settings

from tests.stress.checks import check_traces
from tests.stress.scenes import Case, cases, plain
from tests.stress.symmetry import check_mirrored, check_units
from workbench.optics.plan import Plan

DTYPES = [torch.float64, torch.float32]
FEW = settings(max_examples=12, suppress_health_check=list(HealthCheck))
MANY = settings(max_examples=2000, suppress_health_check=list(HealthCheck))
FAR = {"kind": "point", "emission": "uniform", "rays": 500}
NEAR = {"kind": "point", "emission": "lambertian", "rays": 500}

# Each has broken something once, or stands for an extreme that chance may not meet.
NAMED = {
    "a far source beside the aperture keeps the rim of the entrance face": plain(
        {"source": FAR | {"position": [0.0, -333333.0, -999999.0]}}, samples=(20, 19)
    ),
    "a cone around a far source has digits left": plain(
        {"source": FAR | {"position": [0.0, 0.0, -1e8]}}
    ),
    "squares of a hair in small units stay in range": plain(
        {
            "source": NEAR | {"position": [0.5, 0.0, -1e-9]},
            "lens.control_points": [64, 60],
            "screen.half_width": [0.01, 0.005],
        },
        unit=-19,
        face="rough",
        samples=(18, 1),
    ),
    "a single ray that goes backwards misses": plain(
        {"source": NEAR | {"position": [0.5, 0.0, -1e-4], "rays": 1}, "run": {"seed": 9}}
    ),
    "a source over a corner of the aperture": plain(
        {"source": NEAR | {"position": [1.0, 1.0, -0.5]}}
    ),
    "samples next to a point make too much light and say so": plain(
        {
            "source": NEAR | {"position": [0.0, 0.0, -1e-4]},
            "lens.base": {"shape": "flat", "height": 1e-3},
            "lens.height_range": [-3e-4, 3e-4],
            "lens.min_thickness": 0.0,
        },
        samples=(1, 25),
    ),
    "points share samples of which some meet a crease": plain(
        {
            "source": {"kind": "grid", "points": [1, 3], "half_width": [0.0, 0.0], "rays": 1}
            | {"center": [0.0, 0.0, -1e-9]},
            "lens.degree": [1, 1],
            "lens.control_points": [2, 3],
            "screen.pixels": [1, 2],
            "filter": {"kind": "box"},
        },
        samples=(1, 20),
    ),
    "all rays at the critical angle": plain({"lens.refractive_index": 1.5}, face="critical"),
    "grazing rays in glass of index 4": plain(
        {"source": NEAR | {"position": [0.0, 0.0, -1e-9]}, "lens.refractive_index": 4.0}
    ),
    "all rays beside the screen": plain({"screen.half_width": [1e-9, 1e-9]}),
    "the screen hugs the lens": plain({"screen.z": 0.8 + 1e-9}),
    "index near 1": plain({"lens.refractive_index": 1.0003, "screen.z": 1e4}),
    "a lens far from the origin": plain(
        {"lens.entrance_z": 5e5, "lens.base": {"shape": "flat", "height": 5e5 + 0.5}}
        | {"screen.z": 5e5 + 5}
    ),
    "nets as small as the degree allows": plain(
        {"lens.degree": [7, 1], "lens.control_points": [8, 2]}, face="wild"
    ),
    "nets of 256": plain({"lens.control_points": [256, 256]}, face="wild"),
    "aspect 100 to 1": plain({"lens.half_width": [0.01, 1.0]}),
    "the sharpest filter": plain({"filter": {"kind": "gaussian", "size": [3, 99], "alpha": 1e6}}),
    "the bluntest filter": plain({"filter": {"kind": "gaussian", "size": [99, 3], "alpha": 1e-6}}),
    "one pixel through a box": plain({"screen.pixels": [1, 1], "filter": {"kind": "box"}}),
    "no gradient wanted": plain({}, weight="nothing"),
    "denormal weights": plain({}, weight="denormal"),
    "a checkerboard wanted": plain({}, weight="checkerboard"),
}


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("case", NAMED.values(), ids=NAMED.keys())
def test_named_extremes(case, dtype):
    check_traces(case, dtype)


@pytest.mark.parametrize("case", NAMED.values(), ids=NAMED.keys())
def test_named_extremes_in_a_mirror_and_in_other_units(case):
    check_mirrored(case, torch.float64)
    check_units(case, torch.float64)


@FEW
@given(case=cases())
def test_traces(case):
    for dtype in DTYPES:
        check_traces(case, dtype)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@MANY
@given(case=cases())
def test_many_traces(case: Case):
    for dtype in DTYPES:
        check_traces(case, dtype)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@settings(MANY, max_examples=400)
@given(case=cases())
def test_many_mirrors(case: Case):
    for dtype in DTYPES:
        check_mirrored(case, dtype)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@settings(MANY, max_examples=400)
@given(case=cases())
def test_many_units(case: Case):
    for dtype in DTYPES:
        check_units(case, dtype)


def test_every_one_of_many_rays_in_one_pixel_counts():
    """Sums of float32 would lose light: each ray adds less than they resolve."""
    one_pixel = {"screen.pixels": [1, 1], "filter": {"kind": "box"}}
    scene = plain({"source.rays": [1500, 1500]} | one_pixel).scene
    traced = Plan(scene).trace({"lens.back": torch.full((12, 10), 0.5, dtype=torch.float64)})
    assert traced.account.efficiency == pytest.approx(0.96**2, abs=2e-7)
