"""Short runs of the best method on extreme tasks."""

import resource

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.stress.runs import TARGETS, check_run
from tests.stress.scenes import Case, cases, plain

MANY = settings(max_examples=200, suppress_health_check=list(HealthCheck))
GIGABYTE = 1 << 20  # of resource.getrusage, which counts in KiB

POINT = {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 500}
BOWL = {"half_width": [1.0, 1.0], "control_points": [9, 8], "height_range": [-0.3, 0.3]}
NAMED = {
    "one bright pixel": ("one pixel", plain({})),
    "one bright line, aspect 100 to 1": ("line", plain({"lens.half_width": [0.01, 1.0]})),
    "checkerboard": ("checkerboard", plain({"lens.degree": [1, 7]})),
    "denormal target": ("denormal", plain({"source": POINT})),
    "huge target": ("huge", plain({"source": POINT | {"position": [0.5, 0.0, -5.0]}})),
    "a point beside an elliptic lens": (
        "tophat",
        plain({"lens.outline": "ellipse", "source": POINT | {"position": [1.5, 1.0, -5.0]}}),
    ),
    "a mirror of triangles before a point": (
        "tophat",
        plain(
            {"lens": None, "mirror": BOWL, "screen.z": -3.0}
            | {"source": POINT | {"intersection": {"method": "mesh", "subdivisions": [1, 2]}}}
        ),
    ),
    "index 4": ("tophat", plain({"lens.refractive_index": 4.0}, face="critical")),
    "all light in one pixel": ("tophat", plain({"screen.z": 1e4, "screen.half_width": [1e6, 1e6]})),
}


@pytest.mark.parametrize(("image", "case"), NAMED.values(), ids=NAMED.keys())
def test_named_runs(image, case, monkeypatch):
    assert not check_run(case, image, monkeypatch)


def test_a_run_without_any_light_fails_with_its_reason(monkeypatch):
    dark = plain(
        {"screen.half_width": [1e-9, 1e-9], "source": POINT, "lens.height_range": [-1e-9, 1e-9]}
    )
    assert "no light reaches the screen" in check_run(dark, "tophat", monkeypatch)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@MANY
@given(case=cases(most_points=40), image=st.sampled_from(TARGETS))
def test_many_runs(case: Case, image: str):
    with pytest.MonkeyPatch.context() as monkeypatch:
        check_run(case, image, monkeypatch)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss < 4 * GIGABYTE
