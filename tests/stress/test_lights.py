"""Extreme scenes of version 2: any light, receiver and outline, coated and absorbing glass."""

import pytest
import torch
from hypothesis import HealthCheck, given, settings

from tests.stress.checks import any_light, check_traces
from tests.stress.lights import lit_cases
from tests.stress.scenes import Case, plain

DTYPES = [torch.float64, torch.float32]
FEW = settings(max_examples=6, suppress_health_check=list(HealthCheck))
MANY = settings(max_examples=2000, suppress_health_check=list(HealthCheck))

FAR_FIELD = {"half_angle": [40.0, 30.0], "center": [5.0, -10.0], "pixels": [16, 17]}
SLIM = {"kind": "collimated", "rays": [5, 4], "direction": [-20.0, 5.0]}
SUN = {"kind": "collimated", "rays": [20, 20], "angular_diameter": 5.0}
LED = {"kind": "area", "center": [0.0, 0.1, -1.0], "half_width": [0.3, 0.2], "rays": 300}

# Each has broken something once, or stands for an extreme that chance may not meet.
NAMED = {
    "a point far aside keeps its flux before an ellipse": plain(
        {"source": {"kind": "point", "position": [0.0, -1e5, -1e6], "rays": 500}}
        | {"lens.outline": "ellipse"},
        samples=(12, 16),
    ),
    "rays beside totally reflected ones": plain({"source": SUN}, face="wild"),
    "a slim beam of few rays": plain(
        {"source": SLIM | {"profile": {"kind": "gaussian", "radius": 0.01}}}
    ),
    "an emitter before a coated, absorbing lens and a far field": plain(
        {"source": LED, "screen": None, "far_field": FAR_FIELD, "lens.reflection": "fresnel"}
        | {"lens.absorption": 1.0, "lens.coating": [0.0, 0.3], "lens.outline": "ellipse"},
    ),
    "a point far aside before a far field": plain(
        {"source": {"kind": "point", "position": [3e5, -5e4, -1e6], "rays": 300}}
        | {"screen": None, "far_field": FAR_FIELD},
        samples=(2, 22),
    ),
    "thin glass that absorbs, across which places in float32 have few digits": plain(
        {
            "source": {"kind": "collimated", "rays": [1, 1], "angular_diameter": 50.0},
            "lens.half_width": [0.01, 1.0],
            "lens.base": {"shape": "flat", "height": 1e-5},
            "lens.height_range": [-1e-11, 1e-11],
            "lens.min_thickness": 0.0,
            "lens.absorption": 99999.0,
            "lens.reflection": "schlick",
            "screen.z": 1.01e-3,
        },
        samples=(1, 1),
    ),
    "light that goes across a far field": plain(
        {
            "source": {"kind": "area", "emission": "lambertian", "rays": 1}
            | {"center": [-1.0, 0.0, -1e-9], "half_width": [1e-9, 1e-9]},
            "lens.refractive_index": 1.0003,
            "lens.degree": [1, 1],
            "lens.control_points": [2, 2],
            "lens.base": {"shape": "flat", "height": 1e-3},
            "lens.height_range": [-1e-9, 1e-9],
            "lens.min_thickness": 0.0,
            "screen": None,
            "far_field": {"half_angle": [1e-3, 1e-3], "pixels": [1, 1]},
        },
        face="wild",
        samples=(1, 14),
        seed=264,
    ),
    "so few rays of a lamp that they make more than all light": plain(
        {
            "source": {
                "kind": "photometric",
                "file": "narrow.ies",
                "position": [0.5, 0.0, -5.0],
                "rotation": [180.0, 180.0, 0.0],
                "rays": 3,
            }
        }
    ),
    "a lamp that is turned away gives no light": plain(
        {
            "source": {
                "kind": "photometric",
                "file": "narrow.ies",
                "position": [0.0, 0.0, -2.0],
                "rotation": [180.0, 0.0, 0.0],
                "rays": 200,
            }
        }
    ),
    "light in one point of a far field, in boxes far narrower than pixels": plain(
        {"source": {"kind": "collimated", "rays": [1, 1], "angular_diameter": 1e-6}}
        | {"screen": None, "far_field": {"half_angle": [1.0, 0.001], "pixels": [1, 1]}}
        | {"lens.control_points": [2, 2], "lens.degree": [1, 1], "lens.refractive_index": 1.0003},
        samples=(1, 1),
    ),
}


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("case", NAMED.values(), ids=NAMED.keys())
def test_named_extremes_of_any_light(case, dtype):
    check_traces(case, dtype, any_light)


@FEW
@given(case=lit_cases())
def test_traces_of_any_light(case):
    for dtype in DTYPES:
        check_traces(case, dtype, any_light)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@MANY
@given(case=lit_cases())
def test_many_traces_of_any_light(case: Case):
    for dtype in DTYPES:
        check_traces(case, dtype, any_light)
