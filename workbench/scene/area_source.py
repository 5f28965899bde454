"""A flat emitter that faces the lens, as the chip of an LED."""

from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from pydantic import ConfigDict

from workbench.arrays import Array
from workbench.scene.element import Element, Place
from workbench.scene.emission import Emission
from workbench.scene.fields import LENGTH, PLACE, Measure, about
from workbench.scene.part import Positive
from workbench.scene.points import MOST_RAYS, check_place, disc, in_front
from workbench.scene.wide_source import WideSource

if TYPE_CHECKING:
    from workbench.scene.task import Scene


class AreaSource(WideSource):
    """A flat emitter that faces the lens; it shines into the whole half-space before it.

    What misses the entrance face misses the lens.
    """

    model_config = ConfigDict(title="Area emitter")
    kind: Literal["area"]
    position: Annotated[
        Place,
        LENGTH,
        PLACE,
        about("Position", "The middle of the emitter: x, y and z, before the entrance face."),
    ]
    half_width: Annotated[
        tuple[Positive, Positive],
        LENGTH,
        about("Half width", "Half of the emitter's extent along x and y."),
    ]
    outline: Annotated[
        Literal["rectangle", "ellipse"],
        about("Outline", "The shape of its face; of an ellipse the half-widths are semi-axes."),
    ] = "rectangle"
    emission: Emission = "lambertian"
    flux: Annotated[
        Positive | None,
        Measure("lm", "lumen"),
        about(
            "Luminous flux",
            "All light that the emitter gives. With it, light on a screen is given in lux and "
            "lumen; left empty, in parts of all light. The lens does not depend on it.",
            le=1e9,
        ),
    ] = None
    rays: Annotated[
        int,
        about(
            "Rays",
            "Rays in each iteration of the paper's method, and for derivative maps. Automatic "
            "chooses its own.",
            ge=1,
            le=MOST_RAYS,
        ),
    ] = 500_000

    @property
    def lumens(self) -> float | None:
        """As it says."""
        return self.flux

    @property
    def of_any_flux(self) -> Self:
        """The same emitter, whatever flux it has."""
        return self if self.flux is None else self.model_copy(update={"flux": None})

    @classmethod
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """Where the scene's source is, a tenth as wide as the lens."""
        x, y = scene.optic.half_width
        place = scene.source.place or in_front(scene.optic)
        return {"position": place, "half_width": (x / 10, y / 10)}

    @property
    def continuous(self) -> bool:
        """Always."""
        return True

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return self.rays

    @property
    def blur_shape(self) -> Literal["rectangle", "ellipse"]:
        """Its outline."""
        return self.outline

    def check_before(self, optic: Element) -> None:
        """Refuse an optic that is not behind it, or too near, too far or too small beside it."""
        check_place("source.position", (*self.position[:2], self.nearest_z), optic)
        super().check_before(optic)

    def seen(self, most: tuple[int, int]) -> Array:
        """Points over its face; see `AnySource.seen`."""
        x, y = (np.linspace(-r, r, count) for r, count in zip(self.half_width, most, strict=True))
        places = self.places(x[:, None], y)
        if self.outline == "ellipse" and min(most) > 2:
            r_x, r_y = self.half_width
            return np.asarray(places[(x[:, None] / r_x) ** 2 + (y / r_y) ** 2 <= 1 + 1e-9])
        return places.reshape(-1, 3)

    def face(self, optic: Element, z: float) -> Array:
        """Its own; see `AnySource.face`."""
        if self.outline == "rectangle":
            return self.corners.reshape(2, 2, 3)
        return np.asarray(self.position + disc() * (*self.half_width, 0.0))

    @property
    def corners(self) -> Array:
        """Corners of the rectangle around it, shape (4, 3)."""
        return self.seen((2, 2))

    def widened(self, corner: Array, digits: int) -> Self:
        """An emitter about the same middle with a corner at a place; see `AnySource.widened`."""
        wide = np.round(np.abs(corner - self.position), digits).tolist()
        new = tuple(a or b for a, b in zip(wide, self.half_width, strict=False))
        return self.model_copy(update={"half_width": new})
