"""The bound in a report: only where the size of the source sets one."""

from workbench.extended.bound import Bound
from workbench.report.figures import bound_rows, percent

GRID = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.3, 0.3], "points": [50, 50]}


def test_report_says_what_no_lens_is_below(make_scene, rng):
    found = Bound(make_scene({"source": GRID}), rng.random((32, 32)))
    least, narrower, blur = bound_rows(found)
    assert (least.name, least.value) == ("no lens is below", percent(found.relative_l2))
    assert (narrower.name, narrower.value) == (
        "a source half as wide would allow",
        percent(found.half_as_wide),
    )
    assert found.half_as_wide < found.relative_l2
    assert "pixels" in blur.value
