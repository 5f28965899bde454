"""A scene in another unit is the same scene: all of its lengths are converted, nothing else is."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.scenes import changed
from workbench.analysis.tracing.trace import Trace
from workbench.errors import Refused
from workbench.scene import Scene

POINT = {"kind": "point", "position": [0.25, -0.5, -4.0], "emission": "lambertian"}
GRID = {"kind": "grid", "center": [0.0, 0.1, -3.0], "half_width": [0.3, 0.2], "points": [2, 3]}
SPHERE = {"shape": "sphere", "height": 0.5, "radius": 8.0, "form": "convex"}
UNITS = ("mm", "cm", "m", "inch")


def leaves(data, path=""):
    """All numbers and words in plain data, by their paths."""
    if isinstance(data, dict):
        for name, value in data.items():
            yield from leaves(value, f"{path}.{name}" if path else name)
    elif isinstance(data, list):
        for number, value in enumerate(data):
            yield from leaves(value, f"{path}[{number}]")
    else:
        yield path, data


def test_every_length_is_converted_and_nothing_else():
    stages = [{"iterations": 2, "source": GRID}]
    run = {
        "method": "auto",
        "iterations": 10,
        "min_radius": 0.5,
        "min_tool_radius": 0.25,
        "smoothness": 0.5,
        "stages": stages,
    }
    data = changed({"source": POINT, "lens.base": SPHERE, "lens.entrance_z": 0.125, "run": run})
    before = Scene.from_data(data)
    found = dict(leaves(before.in_unit("mm").to_data()))
    converted = {path for path, value in leaves(before.to_data()) if found[path] != value}
    assert converted == {
        "unit",
        *(f"elements[0].half_width[{axis}]" for axis in (0, 1)),
        "elements[0].position[2]",
        "elements[0].thickness",
        "elements[0].faces[1].base.radius",
        *(f"elements[0].faces[1].height_range[{end}]" for end in (0, 1)),
        "elements[0].min_thickness",
        *(f"source.position[{axis}]" for axis in (0, 1, 2)),
        *(f"run.stages[0].source.position[{axis}]" for axis in (1, 2)),  # the first one is 0
        *(f"run.stages[0].source.half_width[{axis}]" for axis in (0, 1)),
        "images[0].receiver.position[2]",
        *(f"images[0].receiver.half_width[{axis}]" for axis in (0, 1)),
        "run.min_radius",
        "run.min_tool_radius",
    }
    for path, value in leaves(before.to_data()):
        if path in converted - {"unit"}:
            assert found[path] == pytest.approx(10 * value, rel=1e-15)


@pytest.mark.parametrize(("factor", "unit"), [(1e6, "mm"), (1e-6, "m")])
def test_a_unit_that_makes_numbers_too_large_or_too_small_is_refused(make_scene, factor, unit):
    scene = make_scene()
    scene = Scene.from_data(scene.scaled(Fraction(factor)).to_data())
    with pytest.raises(Refused, match="cannot be computed with"):
        scene.in_unit(unit)


@settings(max_examples=15, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    units=st.tuples(st.sampled_from(UNITS), st.sampled_from(UNITS)),
    source=st.sampled_from([{"kind": "collimated", "rays": [64, 64]}, POINT, GRID]),
    base=st.sampled_from([SPHERE, {"shape": "flat", "height": 0.5}]),
    half_width=st.floats(0.5, 1.5),
    seed=st.integers(0, 1000),
)
def test_the_converted_lens_sends_the_same_flux_to_each_pixel(
    units, source, base, half_width, seed
):
    lens = {"lens.base": base, "lens.half_width": [1.0, half_width], "source": source}
    scene = Scene.from_data(changed({"unit": units[0], **lens}))
    heights = 0.5 + 0.02 * np.random.default_rng(seed).normal(size=scene.optic.net_shape)
    other = scene.in_unit(units[1])
    one = flux(scene, heights, seed)
    two = flux(other, heights * (other.receiver.z / scene.receiver.z), seed)
    assert one.sum() > 0
    # Rounding may put a ray on the other side of an edge between two pixels.
    assert np.abs(one - two).sum() < 1e-3 * one.sum()


def flux(scene, heights, seed):
    batches = Trace(scene, {"lens.back": heights}, 20_000, seed).batches(threads=1)
    return sum(tally.flux[0] for tally in batches if tally is not None)
