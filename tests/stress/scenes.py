"""Whole scenes over the extremes of every field, as hypothesis draws them."""

from typing import Any, NamedTuple

import numpy as np
import torch
from hypothesis import strategies as st

from tests.scenes import changed
from tests.stress.lamps import LAMPS
from workbench.arrays import Array
from workbench.design.bounds import HeightRange
from workbench.design.limits import HeightLimits
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene

Heights = dict[str, torch.Tensor]
LENGTHS = {
    "lens": ("half_width", "entrance_z", "height_range", "min_thickness"),
    "entrance": ("height_range",),
    "mirror": ("half_width", "height_range", "thickness"),
    "base": ("height", "radius"),
    "screen": ("z", "half_width", "center"),
    "source": ("position", "center", "half_width"),
    "profile": ("radius",),
}
FACES = ("flat", "wavy", "rough", "wild", "critical", "lowest")
SIZES = {"flat": 0.0, "wavy": 0.01, "rough": 0.1, "wild": 2.0, "lowest": 0.0}
WEIGHTS = ("noise", "one pixel", "checkerboard", "nothing", "denormal")


class Case(NamedTuple):
    """A scene with a lens or a mirror.

    Attributes
    ----------
    data : dict
        The scene as plain data, the larger half-width of the element 1.
    unit : int
        All lengths are to be multiplied by 2 to this.
    face : str
        One of FACES, for each freeform face.
    weight : str
        Cotangent of the image, one of WEIGHTS.
    samples : tuple[int, int]
        Of the exit face, where the source is one of points; cells of beams.
    origins : int
        Of light that comes from everywhere in a disc or an area.
    seed : int
        Of the face and the weights.
    """

    data: dict[str, Any]
    unit: int = 0
    face: str = "wavy"
    weight: str = "noise"
    samples: tuple[int, int] = (20, 20)
    origins: int = 8
    seed: int = 0

    @property
    def scene(self) -> Scene:
        return Scene.from_data(in_units(self.data, 2.0**self.unit)).carrying(LAMPS)

    def heights(self) -> Heights:
        """Control heights of each freeform face within their range."""
        optic, rng = self.scene.optic, np.random.default_rng(self.seed)
        found = {}
        for face, limits in HeightLimits.of_faces(optic).items():
            free = HeightRange.within(limits)
            noise = rng.normal(size=free.rest.shape)
            if self.face == "critical":
                found[face] = self._roof(face, free, noise)
                continue
            shift = -3.0 if self.face == "lowest" else 0.0
            moved = free.rest + SIZES[self.face] * torch.as_tensor(noise) + shift
            found[face] = free.heights(moved)
        return found

    def _roof(self, face: str, free: HeightRange, noise: Array) -> torch.Tensor:
        """A roof whose slope is that of total reflection, with a hair of noise.

        That of a mirror sends light across the axis.
        """
        optic = self.scene.optic
        steep = (optic.index**2 - 1) ** -0.5 if optic.index > 1 else 1.0
        roof = np.abs(freeform_nets(optic)[face].positions[0])[:, None] * steep
        wanted = free.heights(free.rest).numpy() + roof - roof.mean()
        wanted = wanted * (1 + 1e-7 * noise)
        return torch.as_tensor(np.clip(wanted, free.lower.numpy(), free.upper.numpy()))

    def cotangent(self) -> torch.Tensor:
        """Cotangent of the image."""
        n_x, n_y = self.scene.receiver.pixels
        rng = np.random.default_rng(self.seed + 1)
        values = np.zeros((n_y, n_x))
        if self.weight in ("noise", "denormal"):
            values = rng.normal(size=(n_y, n_x)) * (1e-41 if self.weight == "denormal" else 1)
        elif self.weight == "one pixel":
            values[rng.integers(n_y), rng.integers(n_x)] = 1
        elif self.weight == "checkerboard":
            values = (-1.0) ** np.add.outer(np.arange(n_y), np.arange(n_x))
        return torch.as_tensor(values)


def in_units(data: dict[str, Any], factor: float) -> dict[str, Any]:
    """The scene's data with all lengths multiplied, and what is per length divided."""

    def walk(part: dict[str, Any], name: str) -> dict[str, Any]:
        powers = dict.fromkeys(LENGTHS.get(name, ()), 1) | {"absorption": -1}
        return {
            key: walk(value, key)
            if isinstance(value, dict)
            else (np.multiply(value, factor ** powers[key]).tolist() if key in powers else value)
            for key, value in part.items()
        }

    return walk(data, "scene")


def sizes(least: float, most: float) -> st.SearchStrategy[float]:
    """Positive numbers, even in their logarithm."""
    return st.floats(np.log10(least), np.log10(most)).map(lambda exponent: 10.0**exponent)


@st.composite
def lenses(draw: st.DrawFn, most_points: int) -> dict[str, Any]:
    degree = draw(st.tuples(st.integers(1, 7), st.integers(1, 7)))
    more = st.one_of(st.integers(0, 8), st.sampled_from([0, 30, 248]))
    half_width = draw(st.sampled_from([1.0, 1.0, 0.3, 0.01])), 1.0
    smallest = min(half_width)
    if draw(st.booleans()):
        half_width = half_width[::-1]
    entrance = draw(st.sampled_from([0.0, 0.0, 1.0, -1e3, 1e5]))
    thickness = draw(st.sampled_from([1e-3, 0.1, 0.5, 3.0])) * draw(st.sampled_from([1, smallest]))
    base: dict[str, Any] = {"shape": "flat", "height": entrance + thickness}
    if draw(st.booleans()):
        radius = np.hypot(*half_width) * draw(st.sampled_from([1.0001, 1.5, 10, 1e6]))
        base |= {"shape": "sphere", "radius": radius}
        base["form"] = draw(st.sampled_from(["concave", "convex"]))
        if base["form"] == "convex":
            base["height"] += radius - np.sqrt(radius**2 - np.hypot(*half_width) ** 2)
    extent = draw(st.sampled_from([1e-6, 0.3, 0.9])) * thickness
    return {
        "half_width": list(half_width),
        "entrance_z": entrance,
        "refractive_index": draw(st.sampled_from([1.0003, 1.1, 1.5, 2.0, 4.0])),
        "degree": list(degree),
        "control_points": [min(p + 1 + draw(more), most_points) for p in degree],
        "base": base,
        "height_range": [-extent, extent],
        "min_thickness": draw(st.sampled_from([0.0, 0.05])) * thickness,
    }


@st.composite
def sources(draw: st.DrawFn, entrance: float) -> dict[str, Any]:
    kind = draw(st.sampled_from(["collimated", "collimated", "point", "grid"]))
    if kind == "collimated":
        return {"kind": kind, "rays": [draw(st.integers(1, 40)), draw(st.integers(1, 40))]}
    away = draw(st.sampled_from([1e-9, 1e-4, 0.1, 1.0, 5.0, 1e3, 1e6]))
    off = st.sampled_from([0.0, 0.0, 0.5, 1.0, 3.0])
    place = [draw(off) * max(1, away / 9), draw(off) * -max(1, away / 9), entrance - away]
    source: dict[str, Any] = {
        "kind": kind,
        "emission": draw(st.sampled_from(["uniform", "lambertian"])),
        "sampling": draw(st.sampled_from(["sobol", "random"])),
        "rays": draw(st.integers(1, 600)),
    }
    if draw(st.integers(0, 3)) == 0:
        source["intersection"] = {"method": "mesh", "subdivisions": [1, 2]}
    if kind == "point":
        return source | {"position": place}
    source["rays"] = source["rays"] // 9 + 1
    source["points"] = [draw(st.integers(1, 4)), draw(st.integers(1, 4))]
    source["half_width"] = [draw(st.sampled_from([0.0, 0.2, 2.0])) for _ in range(2)]
    return source | {"center": place}


@st.composite
def cases(draw: st.DrawFn, most_points: int = 256) -> Case:
    lens = draw(lenses(most_points))
    base = lens["base"]
    sag = 0.0
    if base["shape"] == "sphere" and base["form"] == "concave":
        radius, rim = base["radius"], np.hypot(*lens["half_width"])
        sag = rim**2 / (radius + np.sqrt(radius**2 - rim**2))
    top = base["height"] + sag + lens["height_range"][1]
    gap = draw(st.sampled_from([1e-6, 1e-2, 1.0, 5.0, 5.0, 100.0, 1e6]))
    gap = max(gap, 1e-9 * abs(top))
    wide = draw(st.sampled_from([1.0, 1.0, 1e-2, 10.0])) * draw(st.sampled_from([1.0, max(1, gap)]))
    pixels = [draw(st.sampled_from([1, 2, 7, 16, 33])) for _ in range(2)]
    filter: dict[str, Any] = {"kind": "box"}
    if draw(st.integers(0, 3)):
        filter = {
            "kind": "gaussian",
            "alpha": draw(st.sampled_from([1e-6, 0.1, 1, 1, 6, 100, 1e6])),
        }
        filter["size"] = [draw(st.sampled_from([1, 3, 3, 5, 15, 99])) for _ in range(2)]
        if sum(filter["size"]) > 60:
            filter["size"] = [filter["size"][0], 3]
    data = {
        "lens": lens,
        "source": draw(sources(lens["entrance_z"])),
        "screen": {"z": top + gap, "half_width": [wide, wide / 2], "pixels": pixels},
        "filter": filter,
        "target": {"builtin": "tophat"},
        "run": {"seed": draw(st.integers(0, 9))},
    }
    return Case(
        data,
        unit=draw(st.sampled_from([0, 0, -19, 19])),
        face=draw(st.sampled_from(FACES)),
        weight=draw(st.sampled_from(WEIGHTS)),
        samples=(draw(st.integers(1, 30)), draw(st.integers(1, 30))),
        seed=draw(st.integers(0, 999)),
    )


def plain(changes: dict[str, Any], **others: Any) -> Case:
    """A common scene with some fields changed, ``{"screen.z": 7}``."""
    few = {"source.rays": [30, 31], "screen.pixels": [16, 17], "run": {"seed": 0}}
    return Case(changed(few | changes), **others)
