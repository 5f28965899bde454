"""Images of light that a diffuser scatters."""

from collections.abc import Mapping
from typing import Protocol

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.blurred_light import LightBlurring
from workbench.design.lens_blur import powers
from workbench.extended.scattering import Directions, Scattering
from workbench.optics.light import Light
from workbench.optics.paths import ray_paths
from workbench.said import Said
from workbench.scene import GaussianScatter, Scene, Screen

# Rays that tell the directions of light at a receiver, and the degree of polynomials through them.
_RAYS, _DEGREE = (48, 48), 3
# Fewer rays do not tell. Those that come to the plane farther out, in half-widths of the screen,
# are left out; beyond nearly all of the others, directions are as at that border.
_FEWEST, _NEAR, _NEARLY_ALL = 100, 2.0, (0.002, 0.998)


class BeamImages(Protocol):
    """A plan of images, such as `workbench.optics.beam_plan.BeamPlan`."""

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen and what is left out, in words, for a run's log."""
        ...

    def trace(self, heights: Mapping[str, Tensor], margin: tuple[int, int] = (0, 0)) -> Light:
        """Image and light account of a lens."""
        ...


class ScatteredPlan:
    """Images of undeflected light, scattered; see `workbench.optics.beam_plan.BeamPlan`.

    `plan`: makes images of undeflected light in parts of pixels; `scattering`: what the diffuser
    makes of them; `pixels`: of the receiver.
    """

    def __init__(self, plan: BeamImages, scattering: Scattering, pixels: tuple[int, int]) -> None:
        self._plan, self._scattering, self._pixels = plan, scattering, pixels
        self._blurring: dict[tuple[int, int], LightBlurring] = {}

    @property
    def notes(self) -> tuple[str, ...]:
        """See `BeamImages`."""
        x, y = self._scattering.widths
        scattered = Said("the diffuser blurs it over {x:.3g} × {y:.3g} pixels", x=x, y=y)
        return *self._plan.notes, scattered

    def trace(self, heights: Mapping[str, Tensor], margin: tuple[int, int] = (0, 0)) -> Light:
        """See `BeamImages`."""
        parts = self._scattering.parts
        light = self._plan.trace(heights, (parts * margin[0], parts * margin[1]))
        if margin not in self._blurring:
            self._blurring[margin] = self._made(margin, light.flux.device)
        return self._blurring[margin].light(light, self._pixels, margin, parts)

    def _made(self, margin: tuple[int, int], device: torch.device) -> LightBlurring:
        scattering, (n_x, n_y), (m_x, m_y) = self._scattering, self._pixels, margin
        parts = scattering.parts
        factors = scattering.factors_at((parts * n_x, parts * n_y), (parts * m_x, parts * m_y))
        kernels = scattering.kernels[:, None]
        return LightBlurring.of(kernels[0], kernels[1:], factors, device)


def directions_at_receiver(scene: Scene, heights: Mapping[str, Tensor]) -> Directions | None:
    """Mean directions in which light of a lens comes to places of a plane.

    None where no polynomials are needed, or too few rays come to the plane.
    """
    diffuser, screen = scene.diffuser, scene.receiver
    gaussian = diffuser is not None and isinstance(diffuser.scatter, GaussianScatter)
    if not gaussian or not isinstance(screen, Screen):
        return None
    found = {face: each.detach().double().cpu().numpy() for face, each in heights.items()}
    paths = ray_paths(scene, found, _RAYS)
    right, up, normal = screen.sides
    start, end = paths.points[:, -2], paths.points[:, -1]
    ahead = np.abs((end - start) @ normal)
    place = (end - np.array(screen.position)) @ np.stack([right, up], axis=1) / screen.half_width
    near = (paths.weight > 0) & (ahead > 0) & (np.abs(place) < _NEAR).all(axis=1)
    if np.count_nonzero(near) < _FEWEST:
        return None
    place, weight = place[near], np.sqrt(paths.weight[near])
    slopes = (end - start)[near] / ahead[near, None]
    terms = weight * powers(place[:, 0], place[:, 1], _DEGREE)
    factors = np.linalg.lstsq(terms.T, weight[:, None] * slopes)[0]
    low, high = np.quantile(place, _NEARLY_ALL, axis=0)

    def directions(u: Array, v: Array) -> Array:
        lit = np.clip(np.stack([u, v], axis=-1) / screen.half_width, low, high)
        found = powers(lit[:, 0], lit[:, 1], _DEGREE).T @ factors
        return np.asarray(found / np.linalg.norm(found, axis=-1, keepdims=True))

    return directions
