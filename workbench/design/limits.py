"""Where the control heights of a lens may be."""

from dataclasses import dataclass

import numpy as np

from workbench.arrays import Array, Mask
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.scene import Element, PlacedFace, Scene, SplineFace

# A surface keeps this part of its own extent along z away from an end, where there is room for it:
# heights that begin at an end can hardly be moved.
_APART = 0.25
# Places along z that are tried where a surface does not fit anywhere.
_SHIFTS = 65
# The undesigned lens keeps this part of each interval away from its ends.
_INSIDE = 0.0005
# Part of the distance to the receiver that an automatic thickness takes where that is enough.
_USUAL = 0.5
# Rounding, as a part of the largest height.
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class HeightLimits:
    """The interval of each control height, and the lens before any design."""

    # (n_u, n_v), ends of the intervals, scene units; the upper one may be infinite.
    lower: Array
    upper: Array
    undesigned: Array  # (n_u, n_v), base plus the middle of the height range, within the limits
    shaping: Mask  # (n_u, n_v), which of them bear on the lens: only these have to fit

    @classmethod
    def of_scene(cls, scene: Scene, part: float = _USUAL) -> dict[str, "HeightLimits"]:
        """The limits of all freeform faces of a scene, by id; ``part`` as for `bounded`."""
        return {
            face: limits
            for focused in scene.focused
            for face, limits in cls.of_faces(bounded(focused, part)).items()
        }

    @classmethod
    def of_faces(cls, optic: Element) -> dict[str, "HeightLimits"]:
        """The limits of each freeform face of an optic, by its name, on its own net.

        By the convex-hull property each face stays between its limits everywhere, and all of the
        entrance face's are below those of the exit face by the minimal thickness.
        """
        laws = {optic.designed_front: cls.at_entrance, optic.designed_face: cls.of}
        fixed = {placed.name: (placed, face) for placed, face in optic.fixed_faces}
        return {
            face: cls.at(optic, *fixed[face], net) if face in fixed else laws[face](optic, net)
            for face, net in freeform_nets(optic).items()
        }

    @classmethod
    def at(
        cls, optic: Element, placed: PlacedFace, face: SplineFace, net: ControlNet
    ) -> "HeightLimits":
        """The limits of a fixed face: about its own heights, or its base, where a run keeps it."""
        x, y = net.positions
        heights = face.base.sag(x[:, None], y) + placed.z
        if face.carried_heights is not None:
            heights = face.carried_heights + optic.position[2]
        reach = max(optic.half_width)
        return cls(heights - reach, heights + reach, heights, net.shaping(outline_of(optic)))

    @classmethod
    def at_entrance(cls, optic: Element, net: ControlNet) -> "HeightLimits":
        """The limits of the entrance face; undesigned it is where the lens says, or close to it."""
        low, high = optic.entrance_range
        middle = (
            optic.entrance_range[0]
            - optic.entrance_offsets[0]
            + sum(optic.entrance.height_range or (0.0, 0.0)) / 2
        )
        inside = _INSIDE * (high - low)
        lower, upper, undesigned = (
            np.full(net.shape, z)
            for z in (low, high, min(max(middle, low + inside), high - inside))
        )
        return cls(lower, upper, undesigned, net.shaping(outline_of(optic)))

    @classmethod
    def of(cls, optic: Element, net: ControlNet) -> "HeightLimits":
        """The limits that an optic sets on a control net of the face that the task shapes."""
        x, y = net.positions
        lower, upper = optic.limits_at(x[:, None], y[None, :])
        middle = optic.base.height_at(x[:, None], y[None, :])
        if optic.height_range is not None:
            middle = middle + sum(optic.height_range) / 2
        inside = np.where(np.isfinite(upper), _INSIDE * (upper - lower), 0.0)
        shaping = net.shaping(outline_of(optic))
        return cls(lower, upper, middle.clip(lower + inside, upper - inside), shaping)

    def lacks(self, heights: Array) -> float:
        """How much more room along z a surface needs, scene units; at most 0 where it fits.

        It may be moved along z.
        """
        least, most = self._room(heights)
        return least - most

    def ends(self, heights: Array, fraction: float) -> tuple[Mask, Mask]:
        """Which heights are at their lower and at their upper end, within a part of the interval.

        All ends have to be finite.
        """
        near = fraction * (self.upper - self.lower)
        low, high = heights <= self.lower + near, heights >= self.upper - near
        return low & self.shaping, high & self.shaping

    def hold(self, heights: Array) -> bool:
        """Whether heights are within the limits as they are."""
        slack = _ROUNDING * np.abs(heights).max()
        fits = (heights >= self.lower - slack) & (heights <= self.upper + slack)
        return bool((fits | ~self.shaping).all())

    def kept(self, heights: Array, locked: Mask | None) -> Array:
        """Heights cut off at the limits, but for locked ones, which stay as they are."""
        inside = heights.clip(self.lower, self.upper)
        return inside if locked is None else np.where(locked, heights, inside)

    def placed(self, heights: Array, rise: float = 0.0) -> Array:
        """A surface moved along z to a rise above the undesigned lens, as far as the limits allow.

        One that does not fit anywhere is beyond the limits by as much above as below.
        """
        least, most = self._room(heights)
        if least > most:
            return np.asarray(heights + (least + most) / 2)
        off = (heights - self.undesigned)[self.shaping]
        apart = min(_APART * (off.max() - off.min()), (most - least) / 2)
        shift = np.clip(rise - (off.max() + off.min()) / 2, least + apart, most - apart)
        return np.asarray(heights + shift)

    def nearest(self, heights: Array) -> Array:
        """A surface within the limits.

        It is moved along z where that is enough; else as little as possible of it is cut off.
        """
        if self.hold(heights):
            return heights
        least, most = self._room(heights)
        if least <= most:
            return self.placed(heights)
        shifts = np.linspace(most, least, _SHIFTS)
        outside = ((heights + c < self.lower) | (heights + c > self.upper) for c in shifts)
        beyond = [(each & self.shaping).sum() for each in outside]
        moved: Array = heights + shifts[np.argmin(beyond)]
        return moved.clip(self.lower, self.upper)

    def _room(self, heights: Array) -> tuple[float, float]:
        """How far a surface may move along z at least and at most; the former is larger if none."""
        low, high = (self.lower - heights)[self.shaping], (self.upper - heights)[self.shaping]
        return float(low.max()), float(high.min())


def undesigned(optic: Element) -> ControlHeights:
    """Control heights of an optic before any design, scene units."""
    limits = HeightLimits.of_faces(optic)
    return FaceArrays({face: each.undesigned for face, each in limits.items()})


CLOSEST = 0.95
"""Part of the distance to the receiver that an automatic thickness takes at most."""


def bounded(scene: Scene, part: float = _USUAL) -> Element:
    """Return the optic of a scene with all that limits its heights; see `Element.bounded`."""
    alone = scene.alone
    optic = alone.optic
    ends = [receiver.nearest_to(optic) for receiver in alone.receivers]
    ends += (behind.nearest_to(scene.optic) for behind in scene.behind[:1])
    nearest = min(ends, key=lambda z: optic.onwards * z)
    return optic.bounded(alone.source.nearest_z, nearest, len(scene.images) > 1, part)
