"""Single rays as a light in Mitsuba: where it has no light of a kind, it is given its rays.

So it is where rays beside the aperture would meet a first face that is not in its plane.

Each ray is a tiny triangle just before the entrance face, whose normal is the ray's direction and
whose area is its flux; Mitsuba draws from them and traces the light. All triangles are in one
plane, so none hides another. They are drawn anew for each seed: with too few of them, two images
of different seeds differ by as much.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from workbench.analysis.tracing.sources.cones import covering_cones
from workbench.analysis.tracing.sources.measured import file_axes
from workbench.arrays import Array
from workbench.geometry.outlines import outline_of
from workbench.measured.lamps import intensity_of, placed_rays
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

# Most triangles: single precision still distinguishes so many.
_MOST = 1 << 19
# In half-widths of the lens: their size for the brightest ray, and how far before the face they
# are. Light of a mirror at 45° that meets them comes at a right angle to their normals, and half
# of it ends there: 25 times as large they cost 3 % of the light, of this size 0.005 %.
_SIZE, _BEFORE = 2e-5, 0.01


class FaceRays(NamedTuple):
    """Rays where they cross the plane of the entrance face.

    Attributes
    ----------
    x, y : ndarray, shape (m,)
        Places, scene units.
    way : ndarray, shape (m, 3)
        Unit vectors with z above 0.
    flux : ndarray, shape (m,)
        Flux of each, in any unit.
    emitted : float
        Flux of the source in the same unit.
    """

    x: Array
    y: Array
    way: Array
    flux: Array
    emitted: float


def rays_as_light(
    mi: Any, source: Source, optic: Element, unit: float, rays: int, seed: int
) -> tuple[dict[str, Any], float]:
    """An emitter of rays of a source; parameters and result are those of `mitsuba_lights`."""
    random = np.random.default_rng([seed, 3])
    found = row_of(_RAYS, source)(source, optic, random, min(rays, _MOST))
    size = max(optic.half_width)
    before = _BEFORE * size + optic.front_z - optic.lowest
    met = outline_of(optic).contains(found.x, found.y) & (found.flux > 0)
    if not met.any():
        return {}, 1.0
    way, flux = found.way[met], found.flux[met]
    place = np.column_stack([found.x[met], found.y[met], np.full(len(flux), optic.front_z)])
    mesh = _facets(mi, (place - way * (before / way[:, 2:])) / unit, way, flux, size / unit)
    return {"light": mesh}, mesh.surface_area() * found.emitted / float(flux.sum())


def _facets(mi: Any, places: Array, ways: Array, flux: Array, lens: float) -> Any:
    """Triangles about places, as large as the flux, that shine along their normals.

    `lens`: half-width of the lens.
    """
    around = 2 * math.pi * np.arange(3) / 3
    corner = np.column_stack([np.cos(around), np.sin(around), np.zeros(3)])
    size = _SIZE * lens * np.sqrt(flux / flux.max())
    vertices = places[:, None] + size[:, None, None] * corner
    count = len(flux)
    properties = mi.Properties()
    properties["emitter"] = mi.load_dict(
        {"type": "directionalarea", "radiance": {"type": "rgb", "value": 1.0}}
    )
    # Light that a mirror sends back goes through them.
    properties["bsdf"] = mi.load_dict({"type": "null"})
    mesh = mi.Mesh("", 3 * count, count, props=properties, has_vertex_normals=True)
    content = mi.traverse(mesh)
    content["vertex_positions"] = vertices.astype(np.float32).ravel()
    content["vertex_normals"] = np.repeat(ways, 3, axis=0).astype(np.float32).ravel()
    content["faces"] = np.arange(3 * count, dtype=np.uint32)
    content.update()
    return mesh


def _from_disc(
    source: CollimatedSource, optic: Element, random: np.random.Generator, count: int
) -> FaceRays:
    """Light of random directions: even over the entrance face, or a beam across each of them."""
    way = source.directions(*_in_disc(random, count))
    if math.isinf(source.profile.radius):
        return FaceRays(*_on_face(optic, random, count), way, way[:, 2], float(way[:, 2].sum()))
    right = np.cross([0.0, 1.0, 0.0], way)
    right /= np.linalg.norm(right, axis=1, keepdims=True)
    a, b = random.normal(0.0, source.profile.radius / 2, (2, count, 1))
    place = a * right + b * np.cross(way, right)
    place -= way * (place[:, 2:] / way[:, 2:])  # along the ray to the plane of the face
    return FaceRays(place[:, 0], place[:, 1], way, np.ones(count), float(count))


def _from_area(
    source: AreaSource, optic: Element, random: np.random.Generator, count: int
) -> FaceRays:
    """Light of random places of an emitter to random ones of the face."""
    start = _in_disc(random, count) if source.outline == "ellipse" else _in_square(random, count)
    (a, b), (r_x, r_y) = start, source.half_width
    x, y, way, solid = _onto_face(source.places(r_x * a, r_y * b), optic, random)
    ahead = (way @ source.facing).clip(min=0)
    intensity = ahead / math.pi if source.emission == "lambertian" else (ahead > 0) / (2 * math.pi)
    return FaceRays(x, y, way, intensity * solid, float(count))


def _from_points(
    source: LightOfPoints, optic: Element, random: np.random.Generator, count: int
) -> FaceRays:
    """Light of random ones of some points to random places of the face."""
    points = source.positions
    x, y, way, solid = _onto_face(points[random.integers(len(points), size=count)], optic, random)
    cones = covering_cones(points, optic.half_width, optic.front_z)
    if source.emission == "lambertian":
        power = math.pi * cones.versine * (2 - cones.versine) * (cones.axis @ source.facing)
        solid = solid * (way @ source.facing).clip(min=0)
    else:
        power = 2 * math.pi * cones.versine
    return FaceRays(x, y, way, solid, count * float(power.mean()))


def _from_lamp(
    source: PhotometricSource, optic: Element, random: np.random.Generator, count: int
) -> FaceRays:
    """Light of the point of a lamp to random places of the face."""
    table, turned = intensity_of(source), file_axes(source.rotation).inv()
    x, y, way, solid = _onto_face(np.tile(source.position, (count, 1)), optic, random)
    return FaceRays(x, y, way, solid * table.at(turned.apply(way)), count * table.lumens)


def _from_file(
    source: RayFileSource, optic: Element, random: np.random.Generator, count: int
) -> FaceRays:
    """The rays of the file themselves, or some of them."""
    found = placed_rays(source)
    chosen = random.permutation(len(found.flux))[:count]
    x, y, come = found.onto(optic.front_z)
    flux = found.flux[chosen]
    way, lit = found.direction[chosen], flux * come[chosen]
    return FaceRays(x[chosen], y[chosen], way, lit, float(flux.sum()))


def _on_face(optic: Element, random: np.random.Generator, count: int) -> tuple[Array, Array]:
    """Random places of its rectangle."""
    x, y = _in_square(random, count)
    return optic.half_width[0] * x, optic.half_width[1] * y


def _onto_face(
    start: Array, optic: Element, random: np.random.Generator
) -> tuple[Array, Array, Array, Array]:
    """Places (x, y) of the face for points, unit vectors there, and the solid angle of the face."""
    x, y = _on_face(optic, random, len(start))
    way = np.column_stack([x, y, np.full(len(start), optic.front_z)]) - start
    distance = np.linalg.norm(way, axis=1)
    way /= distance[:, None]
    return x, y, way, 4 * math.prod(optic.half_width) * way[:, 2] / distance**2


def _in_square(random: np.random.Generator, count: int) -> Array:
    return random.uniform(-1, 1, (2, count))


def _in_disc(random: np.random.Generator, count: int) -> Array:
    radius, turn = np.sqrt(random.random(count)), 2 * math.pi * random.random(count)
    return np.asarray(radius * [np.cos(turn), np.sin(turn)])


_RAYS: Mapping[type, Callable[[Any, Element, np.random.Generator, int], FaceRays]] = {
    CollimatedSource: _from_disc,
    AreaSource: _from_area,
    LightOfPoints: _from_points,
    PhotometricSource: _from_lamp,
    RayFileSource: _from_file,
}
