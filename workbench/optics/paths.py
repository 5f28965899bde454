"""Paths of rays for drawings, and where rays are totally reflected."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import torch

from workbench.arrays import Array, Mask
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet
from workbench.messages import Message
from workbench.optics.account import loss_of
from workbench.optics.path import Path
from workbench.optics.rays import Vector
from workbench.powers import written
from workbench.scene import Element, Scene
from workbench.scene.losses import Loss, kind_and_element


class RayPaths(NamedTuple):
    """Paths of n rays."""

    # (n, k, 3), start, places on each face, screen plane; scene units. A ray that does not get to
    # the screen plane ends on the last face or the side: its last two points are the same.
    points: Array
    weight: Array  # (n,), part of the ray's light that arrives, 0 under total reflection
    on_screen: Mask  # (n,), whether it hits the screen


def ray_paths(scene: Scene, heights: Mapping[str, Array], count: tuple[int, int]) -> RayPaths:
    """Follow a grid of rays from before the lens to the screen.

    `heights` (n_u, n_v); `count`: numbers of rays along x and y, spread over the lens.
    """
    x, y = (torch.as_tensor(c) for c in _grid(scene.first, count))
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    rays = path.emitter.towards(x, y)
    tensors = {face: torch.tensor(each) for face, each in heights.items()}
    places, arrival = path.follow(rays, tensors)
    hits = arrival.column.isfinite() & arrival.row.isfinite() & (arrival.rays.flux > 0)
    ends = _rows(path.ends(arrival.rays), len(x))
    before = [_rows(place, len(x)) for place in places]
    last = np.where(hits.numpy()[:, None], ends, before[-1])
    points = np.stack([*before, last], axis=1)
    share = (arrival.rays.flux / rays.flux).expand(len(x)).numpy()
    inside = scene.receiver.covers(arrival.column, arrival.row) & hits
    return RayPaths(points, share, inside.expand(len(x)).numpy())


def _rows(place: Vector, count: int) -> Array:
    """Places as rows, shape (count, 3)."""
    return np.stack([c.expand(count).numpy() for c in place], axis=-1)


def _grid(optic: Element, count: tuple[int, int]) -> tuple[Array, Array]:
    """Places (x, y) spread over the lens in rows, each of shape (n,); middles of its rectangles."""
    u, v = ((np.arange(m) + 0.5) / m * 2 - 1 for m in count)
    x, y = outline_of(optic).from_square(u[:, None], v)
    return x.ravel(), y.ravel()


_CELLS = 16  # along each axis, of which the brightest is named


@dataclass(frozen=True, eq=False)
class TotalReflection:
    """Light that cannot leave through a face."""

    places: Array  # (n, 3), where each of its rays meets the face, scene units
    flux: Array  # (n,), what each of them carries, as a part of the light of the source
    loss: Loss  # what the light account calls it

    @property
    def share(self) -> float:
        """How much of the light of the source it is."""
        return float(self.flux.sum())

    @property
    def middle(self) -> tuple[float, float]:
        """The x and y about which there is most of it.

        That of all of it would be in the middle of the lens where the whole rim reflects.
        """
        x, y = self.places[:, 0], self.places[:, 1]
        low, width = self.places.min(axis=0), np.ptp(self.places, axis=0)
        cell = ((self.places - low) / np.where(width > 0, width, 1.0) * _CELLS).astype(int)
        number = cell[:, 0].clip(0, _CELLS - 1) * _CELLS + cell[:, 1].clip(0, _CELLS - 1)
        here = number == np.bincount(number, self.flux).argmax()
        return (
            float(np.average(x[here], weights=self.flux[here])),
            float(np.average(y[here], weights=self.flux[here])),
        )

    def sentence(self, scene: Scene) -> Message:
        """How much it is, and where there is most of it."""
        x, y = self.middle
        face, name = Message(scene.optic.face_called), self.loss.element
        if name:
            element = next(each for each in scene.elements if each.name == name)
            face = Message("{face} of {element}", face=Message(element.face_called), element=name)
        return Message(
            "{part} % of the light is totally reflected at the {face}, most of it around "
            "x = {x}, y = {y}",
            part=written(100 * self.share, digits=2),
            face=face,
            x=written(x, scene.unit, 3),
            y=written(y, scene.unit, 3),
        )


def total_reflection(scene: Scene, heights: Mapping[str, Array]) -> TotalReflection | None:
    """Where most light is totally reflected, of all faces; None if none is.

    `scene`: the scene, whose source gives the rays; `heights` (n_u, n_v).
    """
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    tensors = {face: torch.tensor(each) for face, each in heights.items()}
    found = []
    with torch.no_grad():
        for passage in path.passages(tensors):
            for key, flux in passage.passed.lost.items():
                here = flux > 0
                if kind_and_element(key)[0] == "total_reflection" and here.any():
                    place = (c.expand(here.shape)[here] for c in path.places_at(passage))
                    places = torch.stack([*place], -1).numpy()
                    found.append(TotalReflection(places, flux[here].numpy(), loss_of(key)))
    return max(found, key=lambda each: each.share, default=None)
