"""The way of the light: the sequence of elements that a scene makes, and the walk along it.

The walk is plain torch, in any float type, on any device, differentiable forward and backward. It
follows the rays that are drawn and written to files, and tests hold all other tracers to it.
"""

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.arrival import Arrival
from workbench.optics.interfaces import Interface, Refraction
from workbench.optics.rays import RayBundle, Vector
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.sources import Emitter, emitter_of
from workbench.optics.surfaces import BSplineSurface, Plane, Surface
from workbench.scene import MeshMethod, Scene


class Step(NamedTuple):
    """A face on the way of the light.

    Attributes
    ----------
    surface : Surface
        Where rays meet it.
    interface : Interface
        What it does to them.
    missed : str
        Name in the light account of light that does not meet it.
    """

    surface: Surface
    interface: Interface
    missed: str


class Path:
    """Source, faces and receiver of a scene, with everything that heights do not change.

    Parameters
    ----------
    emitter : Emitter
        The source.
    steps : sequence of Step
        Faces in the order in which light meets them.
    receiver : PlaneReceiver
        Where the light is wanted.
    datum : float
        z of the scene from which the elements count z: near the face, so that float32 keeps the
        digits that make its shape.
    seed : int
        Of the source's rays.
    dtype, device
        Float type and device of the walk.

    Attributes
    ----------
    emitter, steps, receiver, datum
        As they were given.
    """

    def __init__(
        self,
        emitter: Emitter,
        steps: Sequence[Step],
        receiver: PlaneReceiver,
        datum: float,
        seed: int,
        dtype: torch.dtype = torch.float32,
        device: torch.device | str = "cpu",
    ) -> None:
        self.emitter, self.steps, self.receiver, self.datum = emitter, tuple(steps), receiver, datum
        self._seed, self._dtype, self._device = seed, dtype, device
        fixed = next((i for i, step in enumerate(steps) if step.surface.freeform), len(steps))
        self._fixed, self._shaped = self.steps[:fixed], self.steps[fixed:]

    @classmethod
    def of(
        cls,
        scene: Scene,
        net: ControlNet,
        dtype: torch.dtype = torch.float32,
        device: torch.device | str = "cpu",
    ) -> "Path":
        """The path of a scene, with control heights on a net."""
        lens, n = scene.lens, scene.lens.index
        emitter, how = emitter_of(scene.source, lens), scene.source.intersection
        datum = lens.base.height if emitter.along_axis else lens.entrance_z
        subdivisions = how.subdivisions if isinstance(how, MeshMethod) else None
        entrance = Plane("entrance", lens.entrance_z - datum, lens.half_width)
        exit_face = BSplineSurface("exit", net, datum, dtype, device, subdivisions)
        steps = (
            Step(entrance, Refraction(1.0, n, "fresnel_entrance"), "missed_lens"),
            Step(exit_face, Refraction(n, 1.0, "fresnel_exit"), "left_side"),
        )
        receiver = PlaneReceiver(scene.screen.z - datum)
        return cls(emitter, steps, receiver, datum, scene.run.seed, dtype, device)

    @property
    def rays(self) -> RayBundle:
        """The source's rays before the first freeform face, those that get there."""
        return self._known.rays

    @property
    def lost(self) -> dict[str, Tensor]:
        """Flux lost before the first freeform face, by name; see `Arrival.lost`."""
        return dict(self._known.lost)

    def walk(self, heights: Mapping[str, Tensor]) -> Arrival:
        """Follow the source's rays to the receiver.

        Parameters
        ----------
        heights : mapping of str to Tensor
            Control heights (n_u, n_v) of each freeform surface by name, scene units.
        """
        rays, lost, _ = _through(self._shaped, self.rays, heights)
        return Arrival(*self.receiver.places(rays), rays, _added(self.lost, lost))

    def follow(
        self, rays: RayBundle, heights: Mapping[str, Tensor]
    ) -> tuple[list[Vector], Arrival]:
        """Follow other rays all the way, and tell where they meet each face.

        Parameters
        ----------
        rays : RayBundle
            Rays before the first face in the path's float type, z as in the scene.
        heights : mapping of str to Tensor
            See `walk`.

        Returns
        -------
        tuple of list of Vector, and Arrival
            Places on each face with z as in the scene; of rays that do not meet it, where they
            end. Then the arrival at the receiver.
        """
        rays = rays._replace(position=_lifted(rays.position, -self.datum))
        rays, lost, places = _through(self.steps, rays, heights)
        on_faces = [_lifted(place, self.datum) for place in places]
        return on_faces, Arrival(*self.receiver.places(rays), rays, lost)

    @cached_property
    def _known(self) -> "_Known":
        rays = self.emitter.rays(self._seed)
        rays = rays._replace(position=_lifted(rays.position, -self.datum))
        rays, lost, _ = _through(self._fixed, rays, {})
        on_device = {name: flux.to(self._device) for name, flux in lost.items()}
        return _Known(_cast(_living(rays), self._dtype, self._device), on_device)


class _Known(NamedTuple):
    """The source's rays behind the faces that do not change, and light lost up to there."""

    rays: RayBundle
    lost: dict[str, Tensor]


def _through(
    steps: Sequence[Step], rays: RayBundle, heights: Mapping[str, Tensor]
) -> tuple[RayBundle, dict[str, Tensor], list[Vector]]:
    """Rays behind some faces, light lost there by name, and the places on each face."""
    account: dict[str, Tensor] = {}
    places = []
    for surface, interface, missed in steps:
        meeting = surface.meet(rays, heights)
        passed = interface.turn(rays, meeting)
        with torch.no_grad():
            lost = {missed: torch.where(meeting.met, 0.0, rays.flux), **passed.lost}
            sums = {name: flux.sum(dtype=torch.float64) for name, flux in lost.items()}
        account = _added(account, sums)
        places.append(meeting.position)
        rays = passed.rays
    return rays, account, places


def _added(account: Mapping[str, Tensor], more: Mapping[str, Tensor]) -> dict[str, Tensor]:
    return dict(account) | {name: account.get(name, 0.0) + flux for name, flux in more.items()}


def _lifted(place: Vector, by: float) -> Vector:
    x, y, z = place
    return x, y, z + by


def _cast(rays: RayBundle, dtype: torch.dtype, device: torch.device | str) -> RayBundle:
    def vector(parts: Vector) -> Vector:
        x, y, z = (part.to(device, dtype) for part in parts)
        return x, y, z

    flux, alive = rays.flux.to(device, dtype), rays.alive.to(device)
    return RayBundle(vector(rays.position), vector(rays.direction), flux, alive)


def _living(rays: RayBundle) -> RayBundle:
    """The bundle without rays that are lost whatever the heights: left out once, not in a walk."""
    if rays.alive.all():
        return rays
    alive = rays.alive

    def some(part: Tensor) -> Tensor:
        return part.expand(alive.shape)[alive]

    def vector(parts: Vector) -> Vector:
        x, y, z = map(some, parts)
        return x, y, z

    return RayBundle(vector(rays.position), vector(rays.direction), some(rays.flux), some(alive))
