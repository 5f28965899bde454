"""A plain start for tasks that no job asks for."""

from pydantic import ConfigDict

from workbench.jobs.job import Job
from workbench.jobs.parts import GREEN_UM, lens, screen
from workbench.jobs.proposals import proposed
from workbench.scene import Scene


class Empty(Job):
    """A square lens in collimated light and a screen behind it; all fields are yours to change."""

    model_config = ConfigDict(title="Empty")

    def scene(self) -> Scene:
        """A lens of 20 mm, and a disc as wide on a screen."""
        return proposed(
            {
                "source": {"kind": "collimated", "wavelength_um": GREEN_UM},
                "elements": [lens((20.0, 20.0), "PMMA")],
                "images": [
                    {"receiver": screen(100.0, (20.0, 20.0)), "target": {"builtin": "tophat"}}
                ],
            }
        )
