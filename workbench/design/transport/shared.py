"""A first design of several elements that share the deflection.

Rays through cells of the first aperture are followed through the whole train. Transport says where
on the receiver each ray should arrive. Small tilts of each face show how far its slopes move the
ray, and of all changes of slopes that bring the ray there, the smallest ones are taken: the
solution s = W Jᵀ (J W Jᵀ)⁻¹ Δ of J s = Δ with the least sᵀ W⁻¹ s. Least squares find faces of these
slopes. Where light would pass the last element by, the weights W of the other faces are lowered.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import torch

from workbench.arrays import Array
from workbench.design.limits import HeightLimits
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.cells import Pair, between, whence
from workbench.design.transport.faces import SlopeFit
from workbench.design.transport.one_face import wanted_cells
from workbench.design.transport.two_face_light import to_arrays
from workbench.design.transport.view import ReceiverView
from workbench.geometry.faces import NO_FACES
from workbench.geometry.surface import ControlNet, nets_of
from workbench.optics.path import Path
from workbench.optics.sources import emitter_of
from workbench.optics.sources.origins import through_cells
from workbench.progress import check_interruption
from workbench.scene import Scene

# Cells along each axis, each of which is a ray, and how often all faces are fitted to them. After
# four fits rays miss by a tenth of a pixel on average, and by one at the rim.
_LEVELS = (96, 4), (224, 4)
# Weights of all faces but the last that are tried, and the part of the light without a deflection
# that has to arrive for the first of them to be taken.
_WEIGHTS, _ENOUGH = (1.0, 0.5, 0.25, 0.1, 0.0), 0.98
# Slope of the tilts that show how far a face moves rays; and the most that slopes change in a fit.
_TILT, _MOST = 1e-3, 0.3
# Parts of a change that are tried, until this part of the rays that arrived arrives again: at large
# angles a whole change is too much, and lost rays give no information.
_PARTS, _KEPT = (1.0, 0.5, 0.25), 0.99
# Part of the mean square of J that is added to J Jᵀ: rays that no face moves stay where they are.
_REGULAR = 1e-6


class _Light(NamedTuple):
    """Rays of all cells behind the train; arrays of shape (cells, cells), the first along x."""

    places: dict[str, Pair]
    arrival: Array  # (2, cells, cells): column and row in pixels; not finite where a ray is lost
    flux: Array

    @property
    def arrived(self) -> int:
        """How many rays arrive."""
        return int(np.isfinite(self.arrival).all(axis=0).sum())


class _Train:
    """Rays through cells of the first aperture of a scene, followed for many heights."""

    def __init__(self, scene: Scene, cells: int) -> None:
        sharp = scene.model_copy(update={"source": scene.source.sharp})
        self._path = Path.of(sharp, ControlNet.of(scene.optic), torch.float64)
        source, first = sharp.entrance
        rays = through_cells(emitter_of(source, first).origins, first, (cells, cells))
        x, y, z = (part.expand(cells, cells) for part in rays.position)
        self._rays = rays._replace(position=(x, y, z))

    def through(self, heights: Mapping[str, Array]) -> _Light:
        tensors = {face: torch.as_tensor(z) for face, z in heights.items()}
        with torch.no_grad():
            passages, arrival = self._path.passages_of(self._rays, tensors)
        places = {}
        for passage in passages:
            if passage.step.surface.freeform:
                x, y, _ = to_arrays(passage.meeting.position)
                places[passage.step.surface.name] = x, y
        flux = arrival.rays.flux.expand(arrival.column.shape).numpy()
        return _Light(places, np.stack([arrival.column.numpy(), arrival.row.numpy()]), flux)


def shared_start(
    scene: Scene, target: Array, fixed: Mapping[str, Array] = NO_FACES
) -> dict[str, Array] | None:
    """Control heights of all faces of a first design.

    `scene`: the design task; an extended source counts as a point at its centre; `target` (n_y,
    n_x): the wanted image in any scale, row 0 at +y; `fixed` (n_u, n_v): control heights of faces
    that stay as they are, by id, scene units. Returns (n_u, n_v): by the ids of the faces, scene
    units, within their limits. None if no light arrives.
    """
    nets, limits = nets_of(scene), HeightLimits.of_scene(scene)
    undesigned = {face: each.undesigned for face, each in limits.items()} | dict(fixed)
    free = [face for face in nets if face not in fixed]
    rough = _Level(scene, target, *_LEVELS[0])
    light = rough.train.through(undesigned)
    if not light.flux.any():
        return None
    found: list[tuple[float, dict[str, Array], dict[str, float]]] = []
    for weight in _WEIGHTS if len(free) > 1 else (1.0,):
        weights = dict.fromkeys(free, weight) | {free[-1]: 1.0}
        heights, behind = rough.fitted(undesigned, light, weights, limits)
        arrived = float(behind.flux.sum() / light.flux.sum())
        found.append((arrived, heights, weights))
        if arrived >= _ENOUGH or arrived < found[0][0]:
            break
    arrived, heights, weights = max(found, key=lambda each: each[0])
    if not arrived:
        return heights
    cells, fits = _LEVELS[1]
    finest = max(max(net.shape) for net in nets.values())
    fine = _Level(scene, target, max(min(cells, finest), _LEVELS[0][0]), fits)
    return fine.fitted(heights, fine.train.through(heights), weights, limits)[0]


class _Level:
    """Fits of all faces to rays through as many cells along each axis."""

    def __init__(self, scene: Scene, target: Array, cells: int, fits: int) -> None:
        self.train, self._nets = _Train(scene, cells), nets_of(scene)
        self._scene, self._fits = scene, fits
        self._wanted = wanted_cells(scene, target, cells)
        self._fit_of = {
            face: SlopeFit(net, max(cells, 2 * max(net.shape))) for face, net in self._nets.items()
        }

    def fitted(
        self,
        heights: Mapping[str, Array],
        light: _Light,
        weights: Mapping[str, float],
        limits: Mapping[str, HeightLimits],
    ) -> tuple[dict[str, Array], _Light]:
        """Heights of faces that send light where it is wanted, and that light.

        Begins with other heights and their light.
        """
        heights = dict(heights)
        transport = Transport(light.flux / light.flux.sum(), *self._wanted)
        receiver, view = self._scene.receiver, ReceiverView.of(self._scene)
        to = np.stack(receiver.to_pixels(*view.places(transport)))
        whole_steps = 0
        while whole_steps < self._fits:
            check_interruption()
            changes = _changes(self.train, self._nets, heights, light, to, weights)
            for part in _PARTS:
                changed = self._changed(heights, light, changes, part, limits)
                behind = self.train.through(changed)
                if behind.arrived >= _KEPT * light.arrived:
                    break
            whole_steps += part in (_PARTS[0], _PARTS[-1])
            heights, light = changed, behind
        return heights, light

    def _changed(
        self,
        heights: Mapping[str, Array],
        light: _Light,
        changes: Mapping[str, Pair],
        part: float,
        limits: Mapping[str, HeightLimits],
    ) -> dict[str, Array]:
        """Heights of faces after a part of changes of their slopes."""
        changed = dict(heights)
        for face, change in changes.items():
            fit = self._fit_of[face]
            slopes = fit.slopes(heights[face])
            even = _evenly(change, light.places[face], self._nets[face], len(slopes[0]))
            x, y = (a + part * b for a, b in zip(slopes, even, strict=True))
            changed[face] = limits[face].nearest(limits[face].placed(fit.heights(x, y)))
        return changed


def _changes(
    train: _Train,
    nets: Mapping[str, ControlNet],
    heights: Mapping[str, Array],
    light: _Light,
    to: Array,
    weights: Mapping[str, float],
) -> dict[str, Pair]:
    """Smallest changes of slopes along x and y of faces with weights that send rays to pixels."""
    moved, roots = [], {face: weight**0.5 for face, weight in weights.items() if weight}
    for face, root in roots.items():
        x, y = nets[face].positions
        for tilt in (np.add.outer(x, 0 * y), np.add.outer(0 * x, y)):
            tilted = train.through({**heights, face: heights[face] + _TILT * tilt})
            moved.append(root * _difference(tilted.arrival, light.arrival) / _TILT)
    jacobian = np.moveaxis(np.stack(moved), (0, 1), (-1, -2))
    missed = np.moveaxis(_difference(to, light.arrival), 0, -1)
    square = jacobian @ np.swapaxes(jacobian, -1, -2)
    ridge = _REGULAR * np.trace(square, axis1=-2, axis2=-1).mean()
    solved = np.linalg.solve(square + ridge * np.eye(2), missed[..., None])
    slopes = (np.swapaxes(jacobian, -1, -2) @ solved)[..., 0].clip(-_MOST, _MOST)
    return {
        face: (root * slopes[..., 2 * k], root * slopes[..., 2 * k + 1])
        for k, (face, root) in enumerate(roots.items())
    }


def _difference(arrival: Array, other: Array) -> Array:
    """Difference of places in pixels; 0 where one of them is infinite."""
    there = np.isfinite(arrival) & np.isfinite(other)
    return np.subtract(arrival, other, out=np.zeros_like(arrival), where=there)


def _evenly(values: Pair, place: Pair, net: ControlNet, cells: int) -> Pair:
    """Values of rays, which meet a face at places, at the middles of even cells of the face."""
    rays = len(values[0])
    x, y = (
        (at / (2 * half) + 0.5) * rays - 0.5 for at, half in zip(place, net.half_width, strict=True)
    )
    u, v = ((each + 0.5) * rays / cells - 0.5 for each in ReceiverView.grid(cells))
    cell = whence((x, y), (u, v), (u, v))
    along_x, along_y = (between(each, cell) for each in values)
    return along_x, along_y
