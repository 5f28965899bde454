"""The light of a scene in Mitsuba: a function for each kind of source, and a row in ``_LIGHTS``."""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from workbench.analysis.mitsuba_rays import rays_as_light
from workbench.analysis.tracing.sources.cones import covering_cones
from workbench.analysis.tracing.sources.measured import file_axes
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.measured.lamps import intensity_of
from workbench.scene import (
    AreaSource,
    CollimatedSource,
    Element,
    LightOfPoints,
    PhotometricSource,
    RayFileSource,
    Source,
)
from workbench.scene.part import row_of
from workbench.scene.source import AnySource

# In half-widths of the lens: how far before it parallel light starts.
_BEFORE = 0.1
# A disk so much smaller than its distance stands for a point with Lambert's law.
_DISK = 1e-4
# Mitsuba's spots fade at their rims, here beyond the cone.
_FADE = 1e-3
# Pixels along each side of the slide of a lamp.
_SLIDE = 1024
_EVEN = {"type": "rgb", "value": 1.0}

Lights = tuple[dict[str, Any], float]


def mitsuba_lights(
    mi: Any, source: Source, optic: Element, unit: float, rays: int, seed: int
) -> Lights:
    """Emitters by name, and the flux that they emit towards the lens.

    Parameters
    ----------
    mi : module
        Mitsuba.
    source : Source
        The source, of a kind that `check_known` lets pass.
    optic : Element
        The element that light meets first.
    unit : float
        What counts as 1 in Mitsuba, scene units.
    rays, seed : int
        How many rays to draw, and how, of light that is given by its rays.
    """
    low, high = optic.entrance_range
    in_aperture = optic.onwards > 0 and low == high
    light = row_of(_LIGHTS, source) if in_aperture or source.along_axis else rays_as_light
    return light(mi, source, optic, unit, rays, seed)


def check_known(source: Source) -> None:
    """Refuse a source of which Mitsuba is given no light.

    Raises
    ------
    Refused
        If its kind has none.
    """
    if not isinstance(source, tuple(_LIGHTS)):
        raise Refused("source.kind", f"{source.kind!r} is no light that Mitsuba is given")


def _sheets(
    mi: Any, source: CollimatedSource, optic: Element, unit: float, rays: int, seed: int
) -> Lights:
    """Parallel light from a rectangle before the lens; of discs and beams, rays."""
    if source.continuous or math.isfinite(source.profile.radius):
        return rays_as_light(mi, source, optic, unit, rays, seed)
    r_x, r_y = (r / unit for r in optic.half_width)
    z, to = optic.front_z / unit, mi.ScalarTransform4f
    before = _BEFORE * max(r_x, r_y) + (optic.front_z - optic.lowest) / unit
    if source.along_axis:
        place = to().translate([0, 0, z - before]).scale([r_x, r_y, 1])
        return {"light": _sheet(place)}, 4 * r_x * r_y
    (way,) = source.directions(np.zeros(1), np.zeros(1))
    deep = (optic.entrance_range[1] - optic.front_z) / unit
    size = math.hypot(r_x, r_y) + deep * math.hypot(way[0], way[1]) / way[2]
    # So far back that all of it is before the lens.
    back = (before + 1.5 * size * math.hypot(way[0], way[1])) / way[2]
    centre = [0, 0, z] - back * way
    place = to().look_at(centre, centre + way, [0, 1, 0]).scale([size, size, 1])
    return {"light": _sheet(place)}, 4 * r_x * r_y * float(way[2])


def _sheet(place: Any) -> dict[str, Any]:
    emitter = {"type": "directionalarea", "radiance": _EVEN}
    # Light that a mirror sends back goes through it.
    return {"type": "rectangle", "to_world": place, "emitter": emitter, "bsdf": {"type": "null"}}


def _emitter(
    mi: Any, source: AreaSource, optic: Element, unit: float, rays: int, seed: int
) -> Lights:
    """A face that emits by Lambert's law; of even light, rays."""
    if source.emission == "uniform":
        return rays_as_light(mi, source, optic, unit, rays, seed)
    shape, whole = {"rectangle": ("rectangle", 4.0), "ellipse": ("disk", math.pi)}[source.outline]
    r_x, r_y = (r / unit for r in source.half_width)
    place = _standing(mi, source, np.array(source.position) / unit).scale([r_x, r_y, 1])
    light = {"type": shape, "to_world": place, "emitter": {"type": "area", "radiance": _EVEN}}
    return {"light": light}, math.pi * whole * r_x * r_y


def _standing(mi: Any, source: AnySource, place: Array) -> Any:
    """Where a face of a source stands that is at a place."""
    to_world = np.eye(4)
    to_world[:3, 3] = place
    if source.turn is not None:
        to_world[:3, :3] = source.turn
    return mi.ScalarTransform4f(to_world)


def _points(
    mi: Any, source: LightOfPoints, optic: Element, unit: float, rays: int, seed: int
) -> Lights:
    """A light for each point, into the cone that just covers the lens."""
    r_x, r_y = (r / unit for r in optic.half_width)
    z, to = optic.front_z / unit, mi.ScalarTransform4f
    lights, emitted = {}, 0.0
    points = source.positions / unit
    cones = covering_cones(points, (r_x, r_y), z)
    cases = zip(points, cones.axis, cones.versine, strict=True)
    for number, (point, axis, versine) in enumerate(cases):
        if source.emission == "uniform":
            angle = math.degrees(2 * math.asin(math.sqrt(versine / 2)))
            lights[f"light{number}"] = {
                "type": "spot",
                "to_world": to().look_at(point, point + axis, [1, 0, 0]),
                "intensity": _EVEN,
                "beam_width": angle,
                "cutoff_angle": angle * (1 + _FADE),
            }
            emitted += 2 * math.pi * versine
        else:
            radius = _DISK * (z - point[2])
            lights[f"light{number}"] = {
                "type": "disk",
                "to_world": _standing(mi, source, point).scale([radius, radius, 1]),
                "emitter": {"type": "area", "radiance": _EVEN},
            }
            # Area of the disk times the projected solid angle of the cone.
            sine2 = versine * (2 - versine)
            emitted += math.pi * radius**2 * math.pi * sine2 * (axis @ source.facing)
    return lights, emitted


def _lamp(
    mi: Any, source: PhotometricSource, optic: Element, unit: float, rays: int, seed: int
) -> Lights:
    """A spot behind a slide with the intensities of the file."""
    table, turned = intensity_of(source), file_axes(source.rotation).inv()
    point = np.array(source.position)
    light = _slide(mi, point, optic, unit, lambda ahead: table.at(turned.apply(ahead)))
    return {"light": light}, table.lumens


def _slide(
    mi: Any, place: Array, optic: Element, unit: float, intensity: Callable[[Array], Array]
) -> dict[str, Any]:
    """A spot into the cone that just covers the lens, behind a slide with its intensities."""
    point = place[None, :] / unit
    half_width = (optic.half_width[0] / unit, optic.half_width[1] / unit)
    cone = covering_cones(point, half_width, optic.front_z / unit)
    axis, angle = cone.axis[0], 2 * math.asin(math.sqrt(cone.versine[0] / 2))
    look = mi.ScalarTransform4f().look_at(point[0], point[0] + axis, [1, 0, 0])
    # Directions through the middles of the slide's pixels; the slide is as wide as the cone.
    tangent = (2 * (np.arange(_SLIDE) + 0.5) / _SLIDE - 1) * math.tan(angle * (1 + _FADE))
    x, y = np.meshgrid(tangent, tangent)
    local = np.stack([x, y, np.ones_like(x)], axis=-1).reshape(-1, 3)
    local /= np.linalg.norm(local, axis=1, keepdims=True)
    lit = intensity(local @ np.array(look.matrix)[:3, :3].T)
    slide = mi.Bitmap(lit.reshape(x.shape).astype(np.float32)[..., None])
    return {
        "type": "spot",
        "to_world": look,
        "intensity": _EVEN,
        "texture": {"type": "bitmap", "bitmap": slide, "raw": True, "wrap_mode": "clamp"},
        "beam_width": math.degrees(angle),
        "cutoff_angle": math.degrees(angle) * (1 + _FADE),
    }


_LIGHTS: Mapping[type, Callable[[Any, Any, Element, float, int, int], Lights]] = {
    CollimatedSource: _sheets,
    AreaSource: _emitter,
    LightOfPoints: _points,
    PhotometricSource: _lamp,
    RayFileSource: rays_as_light,
}
