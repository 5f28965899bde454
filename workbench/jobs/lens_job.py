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
        self, source: dict[str, Any], *, wavelength_um: float = GREEN_UM, **receiver: Any
    ) -> Scene:
        """The proposed scene with a source and a receiver, ``screen`` or ``far_field``.

        Raises
        ------
        Refused
            If this is no possible scene.
        """
        task = {"lens": lens(self.size, self.material, wavelength_um), "source": source}
        return proposed(task | receiver | {"target": written(self.target)}, self.thickness)
