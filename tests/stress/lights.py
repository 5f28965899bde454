"""Whole scenes of version 2: light of some size, measured light, and receivers of all kinds."""

from typing import Any

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

from tests.stress.scenes import FACES, WEIGHTS, Case, lenses, sources
from workbench.errors import Refused
from workbench.measured.lamps import ray_model
from workbench.optics.sources import emitter_of


@st.composite
def glasses(draw: st.DrawFn, most_points: int) -> dict[str, Any]:
    """Lenses with all that version 2 knows of them."""
    lens = draw(lenses(most_points))
    thickness = lens["base"]["height"] - lens["entrance_z"]
    return lens | {
        "outline": draw(st.sampled_from(["rectangle", "ellipse"])),
        "reflection": draw(st.sampled_from(["schlick", "fresnel", "fresnel", "none"])),
        "coating": draw(st.sampled_from([None, None, [0.0, 0.999], [0.3, 0.0]])),
        "absorption": draw(st.sampled_from([0.0, 0.0, 1e-9, 1.0, 13.0])) / thickness,
    }


@st.composite
def sky(draw: st.DrawFn) -> dict[str, Any]:
    """Collimated light: straight or tilted, sharp or of a disc, even or a beam."""
    angle = st.sampled_from([0.0, 0.0, 1e-6, 5.0, -20.0, 60.0])
    source: dict[str, Any] = {
        "kind": "collimated",
        "rays": [draw(st.integers(1, 30)), draw(st.integers(1, 30))],
        "direction": [draw(angle), draw(angle)],
        "angular_diameter": draw(st.sampled_from([0.0, 1e-6, 0.533, 5.0, 50.0])),
    }
    if draw(st.booleans()):
        radius = draw(st.sampled_from([0.01, 0.3, 1.0, 1e3]))
        source["profile"] = {"kind": "gaussian", "radius": radius}
    return source


@st.composite
def places(draw: st.DrawFn, entrance: float) -> list[float]:
    """Before the lens, on the axis and beside it."""
    away = draw(st.sampled_from([1e-9, 1e-3, 0.1, 1.0, 5.0, 5.0, 1e3, 1e6]))
    off = st.sampled_from([0.0, 0.0, 0.5, -1.0, 3.0])
    far = max(1, away / 9)
    return [draw(off) * far, draw(off) * far, entrance - away]


@st.composite
def emitters(draw: st.DrawFn, entrance: float) -> dict[str, Any]:
    half = st.sampled_from([1e-9, 1e-3, 0.1, 1.0, 10.0])
    return {
        "kind": "area",
        "center": draw(places(entrance)),
        "half_width": [draw(half), draw(half)],
        "outline": draw(st.sampled_from(["rectangle", "ellipse"])),
        "emission": draw(st.sampled_from(["lambertian", "uniform"])),
        "rays": draw(st.integers(1, 600)),
    }


@st.composite
def lamps(draw: st.DrawFn, entrance: float) -> dict[str, Any]:
    """Lamps by their files."""
    name = st.sampled_from(["crooked.ies", "crooked.ldt", "narrow.ies", "batwing.ies"])
    turn = st.sampled_from([0.0, 0.0, 15.0, -80.0, 180.0])
    source = {"kind": "photometric", "file": draw(name)}
    if draw(st.booleans()):
        name = st.sampled_from(["led.tm25ray", "led.dat", "two.csv"])
        source = {"kind": "ray_file", "file": draw(name), "file_unit": "mm"}
    return source | {
        "position": draw(places(entrance)),
        "rotation": [draw(turn) for _ in range(3)],
        "rays": draw(st.integers(1, 600)),
    }


@st.composite
def receivers(draw: st.DrawFn, top: float) -> dict[str, Any]:
    """Screens anywhere and far fields."""
    pixels = [draw(st.sampled_from([1, 2, 7, 16, 33])) for _ in range(2)]
    if draw(st.booleans()):
        half = st.sampled_from([1e-3, 1.0, 20.0, 45.0])
        middle = st.sampled_from([0.0, 0.0, 10.0, -44.0])
        field = {"half_angle": [draw(half), draw(half)], "center": [draw(middle), draw(middle)]}
        return {"far_field": field | {"pixels": pixels}}
    gap = max(draw(st.sampled_from([1e-3, 1.0, 5.0, 5.0, 100.0, 1e6])), 1e-9 * abs(top))
    wide = draw(st.sampled_from([1.0, 1.0, 1e-2, 10.0])) * draw(st.sampled_from([1.0, max(1, gap)]))
    tilt = [draw(st.sampled_from([0.0, 0.0, 20.0, -50.0])) for _ in range(2)]
    risen = wide * (abs(np.sin(np.radians(tilt[1]))) + abs(np.sin(np.radians(tilt[0]))) / 2)
    aside = st.sampled_from([0.0, 0.0, 0.5, -1.0])
    return {
        "screen": {
            "z": top + gap + risen,
            "half_width": [wide, wide / 2],
            "center": [draw(aside) * max(1, gap / 5), draw(aside) * max(1, gap / 5)],
            "tilt": tilt,
            "pixels": pixels,
        }
    }


@st.composite
def lit_cases(draw: st.DrawFn, most_points: int = 40) -> Case:
    """Cases of version 2, with any light."""
    lens = draw(glasses(most_points))
    base, entrance = lens["base"], lens["entrance_z"]
    rim = np.hypot(*lens["half_width"])
    sag = 0.0
    if base["shape"] == "sphere" and base["form"] == "concave":
        sag = rim**2 / (base["radius"] + np.sqrt(base["radius"] ** 2 - rim**2))
    top = base["height"] + sag + lens["height_range"][1]
    kinds = [sky(), sky(), emitters(entrance), emitters(entrance), lamps(entrance)]
    source = draw(st.one_of(*kinds, sources(entrance)))
    return draw(cases_of({"lens": lens, "source": source} | draw(receivers(top))))


@st.composite
def cases_of(draw: st.DrawFn, part: dict[str, Any]) -> Case:
    """Cases with a given optic, source and receiver; those that are refused are left out."""
    data = part | {
        "version": 2,
        "filter": {"kind": "gaussian", "size": [3, 3], "alpha": 1.0},
        "target": {"builtin": "tophat"},
        "run": {"seed": draw(st.integers(0, 9))},
    }
    in_file = data["source"]["kind"] == "ray_file"  # its lengths are its own
    case = Case(
        data,
        unit=0 if in_file else draw(st.sampled_from([0, 0, -19, 19])),
        face=draw(st.sampled_from(FACES)),
        weight=draw(st.sampled_from(WEIGHTS)),
        samples=(draw(st.integers(1, 24)), draw(st.integers(1, 24))),
        origins=draw(st.sampled_from([1, 2, 7, 16])),
        seed=draw(st.integers(0, 999)),
    )
    try:
        scene = case.scene
        emitter_of(scene.source, scene.optic)
        if in_file:
            ray_model(scene.source, scene.optic, case.origins)
    except Refused as refused:
        assert str(refused).strip()
        assert "\n" not in str(refused)
        assume(False)
    return case
