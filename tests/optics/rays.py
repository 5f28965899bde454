"""Given rays in place of those of a source."""

import torch

from workbench.optics.path import Path
from workbench.optics.rays import RayBundle


class Given:
    """An emitter of given rays."""

    by_area, beside = False, 0.0

    samples = None

    def __init__(self, rays):
        self._rays = rays

    def rays(self, seed, draw=0):
        return self._rays

    def towards(self, x, y):
        raise AssertionError("nobody looks at it")


def with_rays(path, rays):
    """A path with given rays in place of those of its source."""
    return Path(Given(rays), path.steps, path.receiver, path.datum, path.outline, 0, path.dtype)


def bundle(position, direction, flux):
    """Rays from rows of positions and directions, shape (m, 3)."""

    def vector(rows):
        return tuple(torch.as_tensor(rows, dtype=torch.float64).unbind(1))

    flux = torch.as_tensor(flux, dtype=torch.float64)
    alive = torch.ones(len(flux), dtype=torch.bool)
    return RayBundle(vector(position), vector(direction), flux, alive)
