"""The work for a grid grows with its rays: nothing is done for one of its points after another."""

import sys

import pytest

from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources import light_source
from workbench.optics.emission import emit
from workbench.optics.entering import entering
from workbench.optics.transmittance import TransmittanceLaw

_ALONG = 60  # points along each axis of the grid


def calls_of(work):
    """How many Python functions are called, those of numpy among them."""
    count = 0

    def see(_frame, event, _argument):
        nonlocal count
        count += event == "call"

    sys.setprofile(see)
    try:
        work()
    finally:
        sys.setprofile(None)
    return count


@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
def test_many_points_take_as_many_steps_as_four(make_scene, emission):
    def scene(points):
        # Some of the cones reach behind their points.
        grid = {"kind": "grid", "center": [0, 0, -0.05], "half_width": [1.5, 1.5], "rays": 2}
        return make_scene({"source": grid | {"points": [points, points], "emission": emission}})

    few, many = scene(2), scene(_ALONG)
    parts = {
        "rays": lambda s: emit(s.source, s.optic, seed=0),
        "check": lambda s: light_source(s.source, s.optic, Pose(), 1000, 1),
        "account": lambda s: entering.__wrapped__(
            s.source, s.optic, TransmittanceLaw.of(s.optic)[0]
        ),
    }
    for name, work in parts.items():
        work(few)  # imports and caches
        # The account goes row by row.
        assert calls_of(lambda w=work: w(many)) <= calls_of(lambda w=work: w(few)) + 2000, name
