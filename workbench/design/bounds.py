"""Bounds of the control heights of a run, and whether the task fits within them."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array, Mask
from workbench.design.limits import CLOSEST, Cause, HeightLimits, Shortfall, bounded
from workbench.design.transport import First, behind_flat_entrance, first_design
from workbench.geometry.faces import NO_LOCKS
from workbench.geometry.surface import ControlNet
from workbench.messages import Message
from workbench.process import release_freed_memory
from workbench.scene import Element, Scene
from workbench.targets.raster import averaged

_AT_END = 2.0  # parameters beyond it move heights by less than a tenth of what they do at 0


@dataclass(frozen=True)
class HeightRange:
    """Interval of each control height of a face; a locked one has both ends at its height.

    By the convex-hull property the whole face then keeps within the limits, and both faces apart by
    the minimal thickness. The paper's method enters the open interval through tanh: de Koning et
    al. (2023), eqs. 10 and 28. All arrays have the shape (n_u, n_v), in scene units.
    """

    lower: Tensor
    upper: Tensor
    rest: Tensor  # parameters of the undesigned lens: base plus the middle of the height range

    @classmethod
    def within(
        cls,
        limits: HeightLimits,
        device: torch.device | str = "cpu",
        locked: Mask | None = None,
        start: Array | None = None,
    ) -> "HeightRange":
        """The range between the limits of a face; locked points keep their heights exactly.

        `locked`: which, none by default; `start`: their heights, in the range or not; those of the
        undesigned lens by default. Raises `ValueError` if the lens leaves its range to the run; see
        `Bounds`.
        """
        if not np.isfinite(limits.upper).all():
            raise ValueError("the lens has neither a height range nor a maximal thickness")
        lower, upper = limits.lower, limits.upper
        if locked is not None:
            kept = limits.undesigned if start is None else start
            lower, upper = np.where(locked, kept, lower), np.where(locked, kept, upper)
        parts = lower, upper, _inside(limits.undesigned, lower, upper)
        return cls(*(torch.as_tensor(part, device=device) for part in parts))

    def heights(self, parameters: Tensor) -> Tensor:
        """Control heights of parameters."""
        return self.lower + (self.upper - self.lower) * (0.5 * torch.tanh(parameters) + 0.5)

    def parameters(self, heights: Array) -> Tensor:
        """Parameters of control heights; heights at or beyond an end go just inside it."""
        lower, upper = self.lower.cpu().numpy(), self.upper.cpu().numpy()
        return torch.as_tensor(_inside(heights, lower, upper), device=self.lower.device)


class FreeHeights(dict[str, HeightRange]):
    """The ranges of all freeform faces by their names, in the order in which light meets them."""

    @property
    def apart(self) -> dict[str, Tensor]:
        """Parameters of the undesigned lens, or the middle for faces at an end of their range.

        An entrance face with an automatic range begins at the lower end of it, for instance. There
        the tanh passes next to no gradient.
        """
        rest = {face: each.rest for face, each in self.items()}
        return {
            face: torch.where((z.abs() > _AT_END).all(), torch.zeros_like(z), z)
            for face, z in rest.items()
        }

    def heights(self, parameters: Mapping[str, Tensor]) -> dict[str, Tensor]:
        """Control heights of parameters."""
        return {face: each.heights(parameters[face]) for face, each in self.items()}

    def parameters(self, heights: Mapping[str, Array]) -> dict[str, Tensor]:
        """Parameters of control heights; see `HeightRange.parameters`."""
        return {face: each.parameters(heights[face]) for face, each in self.items()}

    @property
    def ends(self) -> tuple[dict[str, Tensor], dict[str, Tensor]]:
        """Least and largest control heights."""
        lower = {face: each.lower for face, each in self.items()}
        return lower, {face: each.upper for face, each in self.items()}

    def nearest(self, heights: Mapping[str, Array]) -> dict[str, Tensor]:
        """Control heights cut off at the ends of their intervals."""
        return {
            face: torch.as_tensor(heights[face], device=each.lower.device).clamp(
                each.lower, each.upper
            )
            for face, each in self.items()
        }


def _inside(heights: Array, lower: Array, upper: Array) -> Array:
    # At the very ends the parameter would be infinite and its gradient 0 for ever.
    width = np.where(upper > lower, upper - lower, 1.0)
    return np.arctanh(np.clip(2 * (heights - lower) / width - 1, -0.999, 0.999))


# An automatic range is that many times what the lenses that it has to hold take of it, and at
# least this part of what bends the light at the rim by half of the screen's width; the larger part
# where a run goes on from a lens that may be far from the one that is wanted.
_TIMES, _LEAST, _USUAL = 3.0, 0.1, 1.0
# Heights within this part of their interval from its end are at the end; so many are no accident.
_END, _MANY = 0.003, 0.02
# An entrance face that fills so much of its range was flattened to fit it.
_FULL = 0.85
# An automatic thickness is as large as the first design needs, and larger by this part of its
# extent. A lens for a lamp far off the axis needs 3.4 cm: with 3.1 cm it is 34 % off, with 3.45 cm
# 20 %, with 4.8 cm 28 %, and thicker glass loses light.
_MARGIN = 0.02
# What the first design may lack, as a part of its extent along z, without being any worse.
_TOLERABLE = 0.02
# Control points along an axis of a coarser task, at least.
_FEWEST_POINTS = 16
# Control points for each of its pixels, at most. In 0.2 and 0.35 of the range that it needs, a
# photograph ends at 12.8 and 7.4 % with 1.5 of them, at 11.5 and 8.7 % in twice the time with 3.
_PER_PIXEL = 1.5


class Bounds:
    """Where the control heights of a run may be, by what its lens allows and its task needs.

    The first design by transport shows the need. That takes a second, and is done when it is
    asked for.

    `scene`: the design task, without stages; `target` (n_y, n_x): the wanted image in any scale,
    row 0 at +y; `start` (n_u, n_v): control heights of each freeform face to go on from; an
    automatic range holds them; `locked` (n_u, n_v): control points that keep the heights that they
    begin with. `limits`: what the lens allows at each freeform face; an automatic thickness is
    settled when the first design is found.
    """

    def __init__(
        self,
        scene: Scene,
        target: Array,
        start: Mapping[str, Array] | None = None,
        locked: Mapping[str, Mask] = NO_LOCKS,
    ) -> None:
        self.scene, self.target, self.start, self.locked = scene, target, start, locked
        self._net = ControlNet.of(scene.optic)
        self._lens, self._face = bounded(scene), scene.optic.designed_face
        self._found: tuple[First | None] | None = None  # once it was looked for
        self._goes_on = False  # from the start: no first design has to be within the range
        self._others = tuple(
            bounded(other) for other in scene.focused if other.optic.name != scene.optic.name
        )
        self.limits = self._limits_with(self._lens)
        if start is not None:
            self._raised(float(start[self._face].max()))

    @property
    def first(self) -> Mapping[str, Array] | None:
        """Control heights of the first design, beyond the limits where these are too narrow."""
        if self._found is None:
            fixed = {face: self.begin[face] for face, mask in self.locked.items() if mask.all()}
            found = first_design(self.scene, self.target, fixed)
            if self._thickened(found):
                thicker = self.scene.with_optic(self._lens)
                found = first_design(thicker, self.target, fixed)
            self._found = (found,)
            release_freed_memory()
        found = self._found[0]
        return None if found is None else found.heights

    def _thickened(self, found: First | None) -> bool:
        """Make an automatic thickness as large as a first design needs; whether that is more."""
        if found is None:
            return False
        lacks = self.limits[self._face].lacks(found.heights[self._face])
        thickest, extent = self._lens.z_max, self._lens.z_max - self._lens.z_min
        return lacks > 0 and self._raised(thickest + lacks + _MARGIN * (extent + lacks))

    def _raised(self, ceiling: float) -> bool:
        """Raise the ceiling of an automatic thickness, as far as the receiver allows."""
        lens, most = self._lens, bounded(self.scene, CLOSEST).z_max
        if self.scene.optic.held_by != "screen" or min(ceiling, most) <= lens.z_max:
            return False
        thickness = min(ceiling, most) - lens.front_z
        self._lens = lens.model_copy(update={"max_thickness": thickness})
        self.limits = self._limits_with(self._lens)
        return True

    def _limits_with(self, lens: Element, ranged: bool = False) -> dict[str, HeightLimits]:
        """Limits of all faces, in the order of the light, from those of the last element."""
        others = [self._with_range(other) if ranged else other for other in self._others]
        return {
            face: limits
            for element in (*others, lens)
            for face, limits in HeightLimits.of_faces(element).items()
        }

    @property
    def too_narrow(self) -> bool:
        """Whether the first design of a single image, with no locks, does not fit within them."""
        several = len(self.scene.images) > 1 or bool(self._others or self.locked)
        return not several and bool(self._lacking)

    @cached_property
    def _lacking(self) -> dict[str, float]:
        """What a first design may lack without harm, for each face that lacks more than that."""
        first = self.first or {}  # settles the limits
        tolerable = {
            face: _TOLERABLE * float(np.ptp(z - self.limits[face].undesigned))
            for face, z in first.items()
        }
        return {
            face: most
            for face, most in tolerable.items()
            if self.limits[face].lacks(first[face]) > most
        }

    def coarser(self, times: int) -> "Bounds":
        """Bounds of the task with pixels and control points of each axis divided by ``times``.

        With fewer control points where the net has many for each pixel.
        """
        receiver, optic = self.scene.receiver, self._ranged
        n_x, n_y = (count // times for count in receiver.pixels)
        n_u, n_v = (
            max(min(count // times, round(_PER_PIXEL * pixels)), _FEWEST_POINTS, degree + 1)
            for count, pixels, degree in zip(optic.net_shape, (n_x, n_y), optic.degree, strict=True)
        )
        scene = self.scene.with_optic(optic.shaped(control_points=(n_u, n_v)))
        scene = scene.with_receiver(receiver.model_copy(update={"pixels": (n_x, n_y)}))
        return Bounds(scene, averaged(self.target, (n_y, n_x)))

    def alone(self) -> "Bounds":
        """Bounds of the exit face alone behind a flat entrance face.

        A first design of both faces was compared with one of it, which is not looked for again.
        """
        bounds = Bounds(behind_flat_entrance(self.scene), self.target)
        found = None if self._found is None else self._found[0]
        if found is not None and found.alone is not None:
            bounds._raised(self._lens.z_max)
            bounds._found = (First({self._face: found.alone}),)
        return bounds

    @property
    def begin(self) -> dict[str, Array]:
        """Control heights that the run begins with; those that are not locked within the limits."""
        if self.start is None:
            return {face: each.undesigned for face, each in self.limits.items()}
        return {
            face: each.kept(self.start[face], self.locked.get(face))
            for face, each in self.limits.items()
        }

    def height_range(
        self, device: torch.device | str = "cpu", goes_on: bool = False
    ) -> FreeHeights:
        """The ranges of a run that optimises: finite, locked control points left out.

        `goes_on`: whether the run goes on from the start, so that an automatic range need not hold
        a first design, which would take seconds.
        """
        self._goes_on = goes_on
        start, locked = self.start or {}, self.locked
        return FreeHeights(
            (face, HeightRange.within(limits, device, locked.get(face), start.get(face)))
            for face, limits in self._limits_with(self._ranged, ranged=True).items()
        )

    @property
    def notes(self) -> tuple[str, ...]:
        """What was chosen for the run, once it is."""
        if self._found is None and not self._goes_on:
            return ()
        found = () if self._found is None or self._found[0] is None else self._found[0].notes
        if self._lens.height_range is not None:
            return found
        assert self._ranged.height_range is not None
        most = self._ranged.height_range[1]
        within = Message(
            "heights within {most:.3g} {unit} of the base", most=most, unit=self.scene.unit
        )
        return (*found, within)

    def shortfall(self, lens: Mapping[str, Array]) -> Shortfall | None:
        """What the task needs beyond the limits; None where they do not seem to hinder it.

        `lens` (n_u, n_v): control heights of the faces of a lens of the run, scene units.
        """
        return self._at_shaped_face(lens[self._face]) or self._at_entrance(lens)

    def _at_entrance(self, lens: Mapping[str, Array]) -> Shortfall | None:
        """What a freeform entrance face lacks: a first design flattens it to fit its own range.

        An automatic range counts as well: what thickness and source leave may be too little.
        """
        front, allowed = self._lens.designed_front, self._lens.entrance_offsets
        if front is None:
            return None
        shaping = self.limits[front].shaping
        free = shaping & ~self.locked.get(front, np.zeros_like(shaping))
        heights = lens[front][free]
        share = float(np.ptp(heights)) / (allowed[1] - allowed[0]) if heights.size else 0.0
        return Shortfall("entrance_range", None, allowed, share) if share >= _FULL else None

    def _at_shaped_face(self, heights: Array) -> Shortfall | None:
        looked = self._found is not None
        if not looked and not self._goes_on and self._lens.height_range is None:
            return None  # nothing has been chosen yet that heights could be at an end of
        low, high = self._ranged_limits.ends(heights, _END)
        if (locked := self.locked.get(self._face)) is not None:
            low, high = low & ~locked, high & ~locked
        share = float((low | high).mean())
        if not looked and share < _MANY:
            return None
        return self._need(share) or (self._held(low, high, share) if share >= _MANY else None)

    def _need(self, share: float) -> Shortfall | None:
        if self.first is None or self._face not in self._lacking:
            return None
        first, tolerable = self.first[self._face], self._lacking[self._face]
        optic = self.scene.optic.shaped(height_range=None)
        optic = bounded(self.scene.with_optic(optic), CLOSEST)
        limits = HeightLimits.of(optic, self._net)
        lacks = limits.lacks(first)
        beyond = lacks > tolerable or self._lens.height_range is None
        held_by = self.scene.optic.held_by
        if beyond and held_by != "height_range":
            thickest = optic.z_max - optic.front_z
            needed, allowed = (
                (optic.least_thickness, thickness) for thickness in (thickest + lacks, thickest)
            )
            return Shortfall(held_by, needed, allowed, share)
        off = limits.placed(first) - self._base
        needed = float(off.min()), float(off.max())
        most = limits.lower - self._base, limits.upper - self._base
        allowed = self._lens.height_range or (float(most[0].min()), float(most[1].max()))
        return Shortfall("height_range", needed, allowed, share)

    def _held(self, low: Mask, high: Mask, share: float) -> Shortfall:
        optic, limits = self._ranged, self._ranged_limits
        assert optic.height_range is not None
        thin, thick = low & (limits.lower == optic.z_min), high & (limits.upper == optic.z_max)
        held: dict[Cause, int] = {
            self.scene.optic.held_by: int(thick.sum()),
            "min_thickness": int(thin.sum()),
            "height_range": int(((low & ~thin) | (high & ~thick)).sum()),
        }
        cause = max(held, key=lambda each: held[each])
        thickness = optic.least_thickness, optic.z_max - optic.front_z
        allowed = optic.height_range if cause == "height_range" else thickness
        return Shortfall(cause, None, allowed, share)

    @property
    def _base(self) -> Array:
        x, y = self._net.positions
        return self._lens.base.height_at(x[:, None], y[None, :])

    @cached_property
    def _ranged(self) -> Element:
        return self._with_range(self._lens)

    def _with_range(self, lens: Element) -> Element:
        if lens.height_range is not None:
            return lens
        face = lens.designed_face
        held = (None if self._goes_on else self.first), self.start
        faces = [self.limits[face].undesigned, *(each[face] for each in held if each is not None)]
        x, y = ControlNet.of(lens).positions
        base = lens.base.height_at(x[:, None], y[None, :])
        most = max(float(np.abs(z - base).max()) for z in faces)
        least = _USUAL if self._goes_on else _LEAST
        half = max(_TIMES * most, least * _natural(self.scene))
        return lens.ranged(-half, half)

    @cached_property
    def _ranged_limits(self) -> HeightLimits:
        return HeightLimits.of(self._ranged, self._net)


def _natural(scene: Scene) -> float:
    """Rise of a face that bends the light at the rim by half of the screen's width, about."""
    optic, receiver = scene.optic, scene.receiver
    wide = zip(receiver.half_extent, receiver.per_radian(optic.leaving_z), strict=True)
    slope = max(r / (far * optic.deflection) for r, far in wide)
    return max(optic.half_width) * min(slope, 1.0)
