"""The light of a scene in Mitsuba: a function for each kind of source, and a row in ``_LIGHTS``."""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench.analysis.tracing.sources.cones import covering_cones
from workbench.analysis.tracing.sources.turning import file_axes
from workbench.errors import Refused
from workbench.measured.lamps import intensity_of, ray_model
from workbench.scene import (
    CollimatedSource,
    GridSource,
    Lens,
    LightOfPoints,
    PhotometricSource,
    PointSource,
    RayFileSource,
    Source,
)

# In half-widths of the lens: how far before it parallel light starts.
_BEFORE = 0.1
# A disk so much smaller than its distance stands for a point with Lambert's law.
_DISK = 1e-4
# Mitsuba's spots fade at their rims, here beyond the cone.
_FADE = 1e-3
# Pixels along each side of the slide of a lamp.
_SLIDE = 1024
# How far the sheet of a beam goes, and its picture.
_WAISTS, _TEXELS = 2.5, 512
_EVEN = {"type": "rgb", "value": 1.0}

Array = npt.NDArray[np.float64]
Lights = tuple[dict[str, Any], float]


def mitsuba_lights(mi: Any, source: Source, lens: Lens, unit: float) -> Lights:
    """Emitters by name, and the flux that they emit towards the lens.

    Parameters
    ----------
    mi : module
        Mitsuba.
    source : Source
        The source.
    lens : Lens
        Gives the entrance face.
    unit : float
        What counts as 1 in Mitsuba, scene units.

    Raises
    ------
    Refused
        If there is nothing in Mitsuba that emits like this source.
    """
    light = _LIGHTS.get(type(source))
    if light is None:
        raise Refused("source.kind", f"{source.kind!r} is no light that Mitsuba is given")
    return light(mi, source, lens, unit)


def _sheets(mi: Any, source: CollimatedSource, lens: Lens, unit: float) -> Lights:
    """Parallel light from a rectangle before the lens."""
    if source.continuous:
        # Sheets of many directions would hide each other: Mitsuba's lights have bodies.
        raise Refused(
            "source.angular_diameter",
            f"{source.angular_diameter:g} is a disc, and Mitsuba is given parallel light alone; 0",
        )
    r_x, r_y = (r / unit for r in lens.half_width)
    z, to = lens.entrance_z / unit, mi.ScalarTransform4f
    if source.along_axis and math.isinf(source.profile.radius):
        place = to().translate([0, 0, z - _BEFORE]).scale([r_x, r_y, 1])
        return {"light": _sheet(place, _EVEN)}, 4 * r_x * r_y
    (way,) = source.directions(np.zeros(1), np.zeros(1))
    size, radiance, emitted = math.hypot(r_x, r_y), _EVEN, 4 * r_x * r_y * float(way[2])
    if math.isfinite(source.profile.radius):
        waist = source.profile.radius / unit
        size, radiance, emitted = _WAISTS * waist, _gaussian(mi), math.pi * waist**2 / 2
    # So far back that all of it is before the lens.
    back = (_BEFORE + 1.5 * size * math.hypot(way[0], way[1])) / way[2]
    centre = [0, 0, z] - back * way
    place = to().look_at(centre, centre + way, [0, 1, 0]).scale([size, size, 1])
    return {"light": _sheet(place, radiance)}, emitted


def _sheet(place: Any, radiance: Any) -> dict[str, Any]:
    emitter = {"type": "directionalarea", "radiance": radiance}
    return {"type": "rectangle", "to_world": place, "emitter": emitter}


def _gaussian(mi: Any) -> Any:
    """A picture of a beam, 1 in the middle, as wide as a sheet."""
    side = np.linspace(-_WAISTS, _WAISTS, _TEXELS + 1)
    middle = np.exp(-2 * ((side[1:] + side[:-1]) / 2) ** 2)
    picture = mi.Bitmap(np.outer(middle, middle)[:, :, None].astype(np.float32))
    return mi.load_dict({"type": "bitmap", "bitmap": picture, "raw": True})


def _points(mi: Any, source: LightOfPoints, lens: Lens, unit: float) -> Lights:
    """A light for each point, into the cone that just covers the lens."""
    r_x, r_y = (r / unit for r in lens.half_width)
    z, to = lens.entrance_z / unit, mi.ScalarTransform4f
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
                "to_world": to().translate(point).scale([radius, radius, 1]),
                "emitter": {"type": "area", "radiance": _EVEN},
            }
            # Area of the disk times the projected solid angle of the cone.
            sine2 = versine * (2 - versine)
            emitted += math.pi * radius**2 * math.pi * sine2 * axis[2]
    return lights, emitted


def _lamp(mi: Any, source: PhotometricSource, lens: Lens, unit: float) -> Lights:
    """A spot behind a slide with the intensities of the file."""
    table, turned = intensity_of(source), file_axes(source.rotation).inv()
    point = np.array(source.position)
    light = _slide(mi, point, lens, unit, lambda ahead: table.at(turned.apply(ahead)))
    return {"light": light}, table.lumens


def _points_of_rays(mi: Any, source: RayFileSource, lens: Lens, unit: float) -> Lights:
    """Spots behind slides for the points that stand for the rays: Mitsuba has no light of rays."""
    model = ray_model(source, lens, source.point_count)
    lights = {}
    for number, point in enumerate(model.places):

        def intensity(ahead: Array, number: int = number) -> Array:
            x, y, z = ahead.T
            return model.intensity(np.full(len(ahead), number), (x, y, z))

        lights[f"light{number}"] = _slide(mi, point, lens, unit, intensity)
    return lights, 1.0


def _slide(
    mi: Any, place: Array, lens: Lens, unit: float, intensity: Callable[[Array], Array]
) -> dict[str, Any]:
    """A spot into the cone that just covers the lens, behind a slide with its intensities."""
    point = place[None, :] / unit
    half_width = (lens.half_width[0] / unit, lens.half_width[1] / unit)
    cone = covering_cones(point, half_width, lens.entrance_z / unit)
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


_LIGHTS: Mapping[type, Callable[[Any, Any, Lens, float], Lights]] = {
    CollimatedSource: _sheets,
    PointSource: _points,
    GridSource: _points,
    PhotometricSource: _lamp,
    RayFileSource: _points_of_rays,
}
