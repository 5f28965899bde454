"""Extreme scenes with mirrors and lenses of two faces: any light, receiver and outline."""

import pytest
import torch
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.stress.checks import any_light, check_traces
from tests.stress.optics import optic_cases
from tests.stress.runs import TARGETS, check_run
from tests.stress.scenes import Case, plain

DTYPES = [torch.float64, torch.float32]
MANY = settings(max_examples=1000, suppress_health_check=list(HealthCheck))

ENTRANCE = {"shape": "freeform", "control_points": [9, 8], "height_range": [-0.05, 0.05]}
BOWL = {"half_width": [1.0, 1.0], "control_points": [9, 8], "height_range": [-0.3, 0.3]}
POINTS = {"kind": "grid", "points": [2, 3], "half_width": [0.2, 0.2], "rays": 25}
BEAM = {"kind": "collimated", "rays": [5, 4], "profile": {"kind": "gaussian", "radius": 0.05}}
ROOF = {
    "half_width": [1.0, 1.0],
    "degree": [1, 1],
    "base": {"shape": "flat", "height": 0.001},
    "height_range": [-0.1, 0.1],
}
SPECK = {"kind": "area", "center": [0.0, 0.0, -0.099000001], "half_width": [1e-9, 1e-9], "rays": 1}
TO_A_POINT = {"screen": None, "far_field": {"half_angle": [0.001, 0.001], "pixels": [1, 1]}}
ASIDE = {"z": -3.0, "half_width": [1.0, 1.0], "center": [4.0, 0.0], "tilt": [0.0, -50.0]}

# Each has broken something once, or stands for an extreme that chance may not meet.
NAMED = {
    "cells at the rim of an ellipse have corners without light": plain(
        {"lens.outline": "ellipse", "lens.entrance": ENTRANCE}, samples=(12, 9)
    ),
    "beams end between corners without light": plain(
        {"lens.entrance": ENTRANCE, "source": BEAM | {"direction": [0.0, 9.0]}}, samples=(12, 9)
    ),
    "rays far beside a face of high degree": plain(
        {
            "lens": None,
            "mirror": {
                "half_width": [0.3, 1.0],
                "degree": [6, 3],
                "control_points": [14, 11],
                "base": {"shape": "sphere", "height": 2.0, "radius": 1.05, "form": "convex"},
                "height_range": [-0.03, 0.03],
            },
            "source": POINTS | {"center": [1.0, -1.0, 0.1]},
            "screen": None,
            "far_field": {"half_angle": [45.0, 20.0], "pixels": [7, 7]},
        },
        face="wild",
        samples=(7, 15),
        seed=54,
    ),
    "a grid of points before two faces of triangles": plain(
        {
            "lens.entrance": ENTRANCE,
            "source": POINTS
            | {"center": [1.0, -1.0, -2.0]}
            | {"intersection": {"method": "mesh", "subdivisions": [1, 2]}},
        },
        samples=(12, 9),
    ),
    "a mirror whose screen is beside it": plain(
        {"lens": None, "mirror": BOWL, "screen": ASIDE | {"pixels": [16, 17]}}, face="rough"
    ),
    "a roof that sends light across the axis": plain(
        {"lens": None, "mirror": BOWL | {"outline": "ellipse"}, "screen.z": -3.0}, face="critical"
    ),
    "a source that touches the mirror for float32": plain(
        {"lens": None, "mirror": ROOF | {"control_points": [3, 2]}, "source": SPECK} | TO_A_POINT,
        face="critical",
        samples=(2, 1),
        origins=1,
    ),
    "long triangles of nearly no width": plain(
        {
            "lens": None,
            "mirror": ROOF | {"control_points": [24, 2]},
            "source": {"kind": "collimated", "rays": [1, 1]},
        }
        | TO_A_POINT,
        face="critical",
        samples=(7, 1),
        origins=1,
    ),
}


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("case", NAMED.values(), ids=NAMED.keys())
def test_named_extremes_of_mirrors_and_lenses_of_two_faces(case, dtype):
    check_traces(case, dtype, any_light)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@MANY
@given(case=optic_cases())
def test_many_traces_of_mirrors_and_lenses_of_two_faces(case: Case):
    for dtype in DTYPES:
        check_traces(case, dtype, any_light)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@settings(MANY, max_examples=200)
@given(case=optic_cases(), image=st.sampled_from(TARGETS))
def test_many_runs_of_mirrors_and_lenses_of_two_faces(case: Case, image: str):
    with pytest.MonkeyPatch.context() as monkeypatch:
        check_run(case, image, monkeypatch)
