"""Étendue between the last element of a train and a receiver, and the radiance of sources."""

import math
from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.design.limits import CLOSEST, bounded
from workbench.geometry.outlines import outline_named, outline_of
from workbench.geometry.reach import projected_solid_angle
from workbench.scene import (
    AnyReceiver,
    AreaSource,
    CollimatedSource,
    Diffuser,
    Element,
    Lens,
    Scene,
)

_SIDES = 64  # of the polygon around an elliptic aperture
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(32)


def radiance(source: Any, optic: Element, way: Array) -> Array | float:
    """Radiance of rays of a source, as part of its flux; infinite where its size is not known.

    Of a Gaussian beam it is that on its axis.
    """
    if isinstance(source, AreaSource):
        area = outline_named(source.outline, source.half_width).area
        if source.emission == "lambertian":
            return 1 / (math.pi * area)
        return np.asarray(1 / (2 * math.pi * area * (way @ source.facing).clip(min=1e-300)))
    if isinstance(source, CollimatedSource) and source.continuous:
        versine = 2 * math.sin(math.radians(source.angular_diameter) / 4) ** 2
        waist, solid_angle = source.profile.radius, 2 * math.pi * versine
        if math.isfinite(waist):
            return 2 / (math.pi * waist**2) / solid_angle
        facing = (1 - versine / 2) * float(source.heading[2])
        return 1 / (4 * math.prod(optic.half_width) * facing * solid_angle)
    return math.inf


def etendue_to(scene: Scene, receiver: AnyReceiver) -> float:
    """Étendue of all rays from the last element to a receiver; infinite where it has no bound."""
    last = scene.elements[-1].lit(scene.source.wavelength)
    if isinstance(last, Diffuser) or (last.designed and not last.free):
        return math.inf
    near, far = _ends(scene, last)
    middle = receiver.stands_at
    if middle is None:
        return _to_angles(last, abs(far - near), receiver)
    return _to_plane(last, near, far, receiver, middle)


def _ends(scene: Scene, last: Element) -> tuple[float, float]:
    """Where light can leave an element, z from its front to the receiver."""
    if last.free:
        last = bounded(scene, CLOSEST) if isinstance(last, Lens) else last
        low, high = last.z_min, last.z_max
        if last.height_range is not None:
            down, up = last.height_range
            least, most = last.base.extent(last.half_width)
            low, high = max(low, least + down), min(high, most + up)
    else:
        placed = last.placed_faces[-1]
        low, high = (placed.z + z for z in placed.face.undesigned.extent(last.half_width))
    return (low, high) if last.onwards > 0 else (high, low)


def _to_angles(last: Element, height: float, receiver: AnyReceiver) -> float:
    """Projected area of the box that holds the face, over the directions of a far field."""
    left, right, bottom, top = np.radians(receiver.bounds)
    h, v = (
        (low + high) / 2 + (high - low) / 2 * _NODES for low, high in ((left, right), (bottom, top))
    )
    weight = np.outer(_WEIGHTS, np.cos(v) * _WEIGHTS) * (right - left) * (top - bottom) / 4
    h, v = np.meshgrid(h, v, indexing="ij")
    way = np.stack([np.cos(v) * np.sin(h), np.sin(v), np.cos(v) * np.cos(h)], axis=-1)
    x, y, z = np.moveaxis(way @ (last.turn * [[1], [1], [last.onwards]]), -1, 0)
    rim = outline_of(last).boundary(_SIDES)[:, :, None, None]
    wide = 2 * np.abs(rim[:, 0] * y - rim[:, 1] * x).max(axis=0)
    return float((weight * (outline_of(last).area * np.abs(z) + height * wide)).sum())


def _to_plane(
    last: Element, near: float, far: float, receiver: AnyReceiver, middle: Array
) -> float:
    """Étendue from a polygon to the receiver, by Lambert's formula at places of the receiver.

    The polygon is across the element's axis at its end; all light from the face between `near` and
    `far` passes through it on its way to the receiver.
    """
    corners = last.seen(receiver.outline(last).reshape(-1, 3))
    ahead = (corners[:, 2] - far) * last.onwards
    if ahead.min() <= 0:
        return math.inf
    part = (abs(far - near) / (ahead + abs(far - near)))[:, None]
    half = np.array(last.half_width)
    low = np.minimum((1 - part) * -half + part * corners[:, :2], -half).min(axis=0)
    high = np.maximum((1 - part) * half + part * corners[:, :2], half).max(axis=0)
    outline = outline_of(last)
    rim = outline.boundary(_SIDES)[:-1] / (1 if outline.whole else math.cos(math.pi / _SIDES))
    if (low < -half).any() or (high > half).any():
        rim = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    rim = last.in_scene(np.column_stack([rim, np.full(len(rim), far)]))
    (r_x, r_y), (right, up, across) = receiver.half_extent, receiver.sides
    x, y = (each.ravel() for each in np.meshgrid(r_x * _NODES, r_y * _NODES))
    place = middle + x[:, None] * right + y[:, None] * up
    ahead = (rim - middle) @ across
    if ahead.min() < 0 < ahead.max():  # some of it is behind the receiver
        return math.inf
    seen = np.abs(projected_solid_angle(rim, place, across))
    return float(seen @ np.outer(_WEIGHTS, _WEIGHTS).ravel() * r_x * r_y)


def scattered_to(scene: Scene, receiver: AnyReceiver) -> float:
    """The most of the light of a diffuser that comes to a receiver.

    Behind a Lambertian one it is that of the place opposite its middle; of others all may come.
    """
    last, middle = scene.elements[-1], receiver.stands_at
    if not isinstance(last, Diffuser) or last.scatter.about_ray or middle is None:
        return 1.0
    x, y, _ = last.seen(middle)
    place = last.in_scene(np.array([[x, y, last.front_z]]))
    rim = receiver.outline(last).reshape(4, 3)[[0, 1, 3, 2]]
    return float(np.abs(projected_solid_angle(rim, place, last.turn[:, 2])[0])) / math.pi
