"""A designed face, and where a measurement of it stands in the face's coordinates."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Self

import numpy as np
from scipy.ndimage import map_coordinates
from scipy.spatial.transform import Rotation

from workbench.arrays import Array, Mask
from workbench.geometry.outlines import Outline, outline_of
from workbench.geometry.surface import ControlNet, nets_of
from workbench.scene import Scene

_SAMPLES = 129  # of the face along x and y, for the first comparison


class Offsets(NamedTuple):
    """Where points are beside a face, for those within its outline."""

    inside: Mask  # (n,), within the outline
    height: Array  # (m,), z of the points above the face
    normals: Array  # (m, 3), unit normals of the face towards +z

    @property
    def distance(self) -> Array:
        """Distance of the points along the normal."""
        return np.asarray(self.height * self.normals[:, 2])


@dataclass(frozen=True, eq=False)
class DesignedFace:
    """A B-spline face with its outline, in the coordinates of its control heights."""

    name: str
    net: ControlNet
    heights: Array  # (n_u, n_v)
    outline: Outline

    @classmethod
    def of(cls, scene: Scene, heights: Array, name: str) -> Self:
        """Return a freeform face of a scene."""
        return cls(name, nets_of(scene)[name], heights, outline_of(scene.element_of(name)))

    def inside(self, points: Array) -> Mask:
        """Mask (n,) of the points (n, 3) within the outline."""
        return np.asarray(self.outline.contains(points[:, 0], points[:, 1]), dtype=np.bool_)

    def offsets(self, points: Array) -> Offsets:
        """Offsets of points (n, 3) from the face."""
        inside = self.inside(points)
        x, y, z = points[inside].T
        there, slope_x, slope_y = self.net.at(x, y, self.heights)
        normals = np.stack([-slope_x, -slope_y, np.ones_like(x)], axis=1)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        return Offsets(inside, z - there, normals)

    @cached_property
    def samples(self) -> Array:
        """Points (n, 3) of the face on a square grid within its outline."""
        r_x, r_y = self.net.half_width
        x, y = np.meshgrid(
            np.linspace(-r_x, r_x, _SAMPLES), np.linspace(-r_y, r_y, _SAMPLES), indexing="ij"
        )
        points = np.stack([x, y, self._grid], axis=-1).reshape(-1, 3)
        return np.asarray(points[self.inside(points)])

    @cached_property
    def _grid(self) -> Array:
        t = np.linspace(0, 1, _SAMPLES)
        return self.net.grid(t, t).evaluate(self.heights)[0]

    def rough_heights(self, points: Array) -> Array:
        """Height (n,) of points above the face, by linear interpolation of samples."""
        places = [
            (points[:, axis] / r + 1) * ((_SAMPLES - 1) / 2)
            for axis, r in enumerate(self.net.half_width)
        ]
        found = map_coordinates(self._grid, places, order=1, mode="nearest")
        return np.asarray(points[:, 2] - found)


@dataclass(frozen=True, eq=False)
class Placement:
    """Takes points q of a measurement to ``scale * rotation @ q + shift``."""

    rotation: Array  # (3, 3), orthogonal; its determinant is -1 for a mirror image
    shift: Array  # (3,)
    scale: float = 1.0

    def applied(self, points: Array) -> Array:
        """Return points (n, 3) in the coordinates of the face."""
        return np.asarray(self.scale * points @ self.rotation.T + self.shift)

    @property
    def mirrored(self) -> bool:
        """Whether it takes points to their mirror image."""
        return float(np.linalg.det(self.rotation)) < 0

    @property
    def rotation_vector(self) -> Array:
        """Axis (3,) of the rotation times its angle, degrees."""
        return np.asarray(np.degrees(Rotation.from_matrix(self.rotation).as_rotvec()))

    def moved(self, about: Array, turn: Array, shift: Array, growth: float = 0.0) -> Self:
        """Return it with a further rotation vector (radians), shift and growth about a point."""
        further = Rotation.from_rotvec(turn).as_matrix()
        there = (1 + growth) * further @ (self.shift - about) + about + shift
        return type(self)(further @ self.rotation, there, (1 + growth) * self.scale)
