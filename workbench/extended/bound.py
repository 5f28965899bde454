"""Lower bound of the error that any lens can reach with an extended source, and of lost light."""

from collections.abc import Generator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.extended.blur import Blur, one_over_the_lens
from workbench.extended.blurring import Blurring
from workbench.extended.deblur import Deblurred, deblur, deblurring, error_allowed, error_allowing
from workbench.messages import Message
from workbench.scene import Scene
from workbench.scene.faces import PlaneFace

# Parts of the target's peak up to where a pixel is black.
_BLACK = 0.01
# More light than this is all of it.
_ALL = 0.995


@dataclass(frozen=True, eq=False)
class Bound:
    """Lower bounds of a scene and its target (n_y, n_x); each is computed when it is read.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> task = open_design(path("examples", "flame-point.json"))
    >>> Bound(task.scene, task.target).sentences
    ('No size of this source is known that blurs the image: it sets no bound.',)
    """

    scene: Scene
    target: Array

    @cached_property
    def blur(self) -> Blur:
        """The blur of the source on the receiver, pixels."""
        return Blur.of(self.scene)

    @property
    def _seen(self) -> Blur:
        return self.blur.seen_in(self.scene.receiver.pixels)

    @cached_property
    def deblurred(self) -> Deblurred:
        """The light that, blurred, is closest to the target; takes seconds."""
        return deblur(self.target, self._seen)

    def finding(self) -> Generator[None, None, Deblurred]:
        """Compute `deblurred` in short steps, so that it can be cancelled."""
        return deblurring(self.target, self._seen)

    def finding_soon(self) -> Generator[None, None, float]:
        """Compute an error that the blur allows, slightly above that of `deblurred`, in steps.

        256 × 200 pixels blurred over eight take 1.9 s of the processor, and 5 s for `deblurred`.
        """
        return error_allowing(self.target, self._seen)

    @property
    def relative_l2(self) -> float:
        """The certified lower bound: relative L2, images divided by their sums."""
        return self.deblurred.bound

    @cached_property
    def half_as_wide(self) -> float:
        """The error that the blur of a source half as wide allows."""
        return error_allowed(self.target, self._narrower)

    def finding_half_as_wide(self) -> Generator[None, None, float]:
        """Compute `half_as_wide` in short steps, so that it can be cancelled."""
        return error_allowing(self.target, self._narrower)

    @property
    def _narrower(self) -> Blur:
        return self.blur.scaled(0.5).seen_in(self.scene.receiver.pixels)

    @cached_property
    def on_receiver(self) -> float:
        """Upper bound of the part of the flux behind the lens that reaches the receiver."""
        return self._most_light(np.ones_like(self.target))

    @cached_property
    def on_target(self) -> float:
        """Upper bound of the part of that flux on the lit target."""
        return self._most_light((self.target > _BLACK * self.target.max()).astype(np.float64))

    def _most_light(self, region: Array) -> float:
        if self.blur.within_a_pixel:
            return 1.0
        shape = region.shape[0], region.shape[1]
        share = Blurring(self._seen.kernels(), shape).back(region).max()
        return min(float(share) * self.blur.part_in(self._seen), 1.0)

    @property
    def blurred(self) -> bool:
        """Whether the source blurs the only image by more than a pixel."""
        return len(self.scene.images) == 1 and not self.blur.within_a_pixel

    @property
    def certified(self) -> bool:
        """Whether the size of the source sets a bound that holds for all lenses."""
        return self.blurred and self.unknown is None

    @property
    def unknown(self) -> Message | None:
        """Why light that is blurred by one blur is no bound of all lenses; None where it is one.

        With two curved faces a lens can be a beam expander, which narrows angles.
        """
        scene = self.scene
        if scene.is_train:
            return Message("Other elements, or a tilt, change the blur")
        if len(scene.images) > 1:
            return Message("Each of several images may be worse than alone")
        if scene.source.light_files:
            return Message("Rays of a file need not come evenly from one place")
        if not one_over_the_lens(scene):
            return Message(
                "A lamp so near is blurred less by the rim of the lens than by its middle"
            )
        if not isinstance(scene.optic.entrance, PlaneFace):
            return Message("A curved entrance face can make the image of the source smaller")
        return None

    @property
    def short(self) -> str:
        """The bound in a few words."""
        return f"no lens of this size below {percent(self.relative_l2)}"

    @property
    def assumptions(self) -> tuple[str, ...]:
        """Assumptions of the bounds."""
        x, y = self.blur.widths
        if self.blur.within_a_pixel:
            return ("small angles: each part of the lens blurs as a pinhole in it",)
        finest = len(self.blur.offsets(finer=2)[0]), len(self.blur.offsets(finer=2)[1])
        exact = self.blur.points is None and self.blur.shape == "rectangle"
        anywhere = (
            "anywhere" if exact else f"at {finest[0]} x {finest[1]} places in each pixel, or more"
        )
        return (
            "small angles: each part of the lens blurs as a pinhole in it",
            f"one blur over the whole lens, {x:.3g} x {y:.3g} pixels",
            f"light may go {anywhere}, beside the receiver too",
            "the error is relative L2, both images divided by their sums on the receiver",
        )

    @property
    def sentences(self) -> tuple[str, ...]:
        """The bounds as sentences."""
        if len(self.scene.images) > 1 or self.scene.diffuser is not None:
            return (f"{self.unknown}: no bound is known.",)
        if max(self.blur.widths) == 0:
            return ("No size of this source is known that blurs the image: it sets no bound.",)
        if self.blur.within_a_pixel:
            return ("The source blurs the image by less than a pixel: its size sets no bound.",)
        if self.unknown:
            return (
                f"{self.unknown}: no bound is known. The best light found with the blur behind "
                f"the middle of the lens is {percent(self.deblurred.error)} off.",
            )
        found = [
            f"No lens of this size can be below {percent(self.relative_l2)} with this source; "
            f"a source half as wide would allow {percent(self.half_as_wide)}."
        ]
        for most, where in (
            (self.on_receiver, "on the receiver"),
            (self.on_target, "where the target is not black"),
        ):
            if most < _ALL:
                found.append(
                    f"At most {100 * most:.0f} % of the light can land {where}: the image of the "
                    "source alone is larger, and no lens makes it smaller (étendue)."
                )
        return tuple(found)

    def to_data(self) -> dict[str, Any]:
        """All figures, for JSON."""
        return {
            "relative_l2_bound": self.relative_l2 if self.unknown is None else None,
            "relative_l2_reached": self.deblurred.error,
            "relative_l2_half_as_wide": self.half_as_wide,
            "efficiency_bound": self.on_receiver,
            "on_target_bound": self.on_target,
            "blur_pixels": list(self.blur.widths),
            "assumptions": list(self.assumptions),
        }


def percent(error: float) -> str:
    """An error with two or three digits."""
    return f"{100 * error:.{1 if error >= 0.01 else 2}f} %"
