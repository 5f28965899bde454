"""Whole scenes with mirrors, and with lenses of two freeform faces, in any light."""

from typing import Any

import numpy as np
from hypothesis import strategies as st

from tests.stress.lights import cases_of, emitters, glasses, lamps, receivers, sky
from tests.stress.scenes import Case, sources


@st.composite
def mirrors(draw: st.DrawFn, most_points: int) -> dict[str, Any]:
    lens = draw(glasses(most_points))
    kept = ("half_width", "degree", "control_points", "base", "outline")
    extent = draw(st.sampled_from([1e-6, 0.1, 1.0])) * min(lens["half_width"])
    return {name: lens[name] for name in kept} | {
        "height_range": [-extent, extent],
        "reflectance": draw(st.sampled_from([1.0, 0.9, 1e-3])),
    }


@st.composite
def two_faced(draw: st.DrawFn, most_points: int) -> dict[str, Any]:
    """Lenses whose entrance face has a net of its own; its range may leave the exit face none."""
    lens = draw(glasses(most_points))
    degree = draw(st.tuples(st.integers(1, 7), st.integers(1, 7)))
    more = st.one_of(st.integers(0, 8), st.just(30))
    thickness = lens["base"]["height"] - lens["entrance_z"]
    low, high = (draw(st.sampled_from([1e-6, 0.05, 0.3])) * thickness for _ in range(2))
    entrance = {
        "shape": "freeform",
        "degree": list(degree),
        "control_points": [min(p + 1 + draw(more), most_points) for p in degree],
        "height_range": [-low, high],
    }
    return lens | {"entrance": entrance}


@st.composite
def lights(draw: st.DrawFn, before: float) -> dict[str, Any]:
    """Any light from before a plane."""
    kinds = [sky(), sky(), emitters(before), lamps(before), sources(before)]
    return draw(st.one_of(*kinds))


def highest(optic: dict[str, Any]) -> float:
    """Of the base and the range above it."""
    base, rim = optic["base"], np.hypot(*optic["half_width"])
    sag = 0.0
    if base["shape"] == "sphere" and base["form"] == "concave":
        sag = rim**2 / (base["radius"] + np.sqrt(base["radius"] ** 2 - rim**2))
    return float(base["height"] + sag + optic["height_range"][1])


def lowest(optic: dict[str, Any]) -> float:
    """Of the base and the range below it."""
    base, rim = optic["base"], np.hypot(*optic["half_width"])
    sag = 0.0
    if base["shape"] == "sphere" and base["form"] == "convex":
        sag = rim**2 / (base["radius"] + np.sqrt(base["radius"] ** 2 - rim**2))
    return float(base["height"] - sag + optic["height_range"][0])


@st.composite
def optic_cases(draw: st.DrawFn, most_points: int = 24) -> Case:
    """A mirror or a lens of two faces, any light, any receiver on the side where light goes."""
    if draw(st.booleans()):
        optic = draw(mirrors(most_points))
        before = lowest(optic)
        receiver = draw(receivers(-before))
        for screen in receiver.values():
            if "z" in screen:
                screen["z"] = -screen["z"]
        part = {"mirror": optic, "source": draw(lights(before))} | receiver
    else:
        optic = draw(two_faced(most_points))
        before = optic["entrance_z"] + optic["entrance"]["height_range"][0]
        part = {"lens": optic, "source": draw(lights(before))} | draw(receivers(highest(optic)))
    return draw(cases_of(part))
