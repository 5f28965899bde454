"""What jobs with a lens have in common, whatever the light and its receiver are."""

from typing import TYPE_CHECKING, Any

from workbench.jobs.job import Job
from workbench.jobs.parts import GREEN_UM, lens, written
from workbench.jobs.proposals import proposed
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.jobs.fields import Material, Picture, Size, Thickness


class LensJob(Job):
    """A lens of some size and material brings light into a picture."""

    if TYPE_CHECKING:  # each job asks for these, at their places in the form
        target: Picture
        size: Size
        material: Material
        thickness: Thickness

    def through_lens(
        self, source: dict[str, Any], receiver: dict[str, Any], wavelength_um: float = GREEN_UM
    ) -> Scene:
        """Return the proposed scene with a source and a receiver, both as plain data.

        Raises `Refused` if this is no possible scene.
        """
        return proposed(
            {
                "source": source | {"wavelength_um": wavelength_um},
                "elements": [lens(self.size, self.material)],
                "images": [{"receiver": receiver, "target": written(self.target)}],
            },
            self.thickness,
        )
