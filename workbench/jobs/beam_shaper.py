"""A laser beam made even."""

from typing import Annotated, ClassVar

from pydantic import ConfigDict

from workbench.jobs.fields import (
    WAVELENGTH_NM,
    Distance,
    ImageSize,
    Material,
    Picture,
    Size,
    Thickness,
)
from workbench.jobs.lens_job import LensJob
from workbench.jobs.parts import screen
from workbench.scene import Positive, Scene, TopHatTarget
from workbench.scene.fields import LENGTH, about


class BeamShaper(LensJob):
    """A Gaussian laser beam becomes an even disc, a rectangle or any other shape."""

    model_config = ConfigDict(title="Laser beam shaper")
    asked_by: ClassVar[dict[str, str]] = {
        "source.wavelength_um": "wavelength",
        "source": "beam_diameter",
    }

    target: Picture = TopHatTarget()
    beam_diameter: Annotated[
        Positive,
        LENGTH,
        about(
            "Beam diameter",
            "Where the irradiance has fallen to 1/e² (13.5 %) of that in the middle, across the "
            "beam.",
        ),
    ] = 6.0
    wavelength: Annotated[
        Positive,
        WAVELENGTH_NM,
        about("Wavelength", "Of the laser. It decides the index, and how far light spreads."),
    ] = 633.0
    size: Size = (16.0, 16.0)
    material: Material = "fused silica"
    thickness: Thickness = None
    distance: Distance = 200.0
    image_size: ImageSize = (20.0, 20.0)

    def scene(self) -> Scene:
        """A straight beam about the axis."""
        profile = {"kind": "gaussian", "radius": self.beam_diameter / 2}
        return self.through_lens(
            {"kind": "collimated", "profile": profile},
            screen(self.distance, self.image_size),
            wavelength_um=self.wavelength / 1000,
        )
