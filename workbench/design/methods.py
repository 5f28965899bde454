"""The methods of design, by the names that scenes have for them."""

from collections.abc import Callable, Generator, Mapping
from typing import NamedTuple, Protocol

from torch import Tensor

from workbench.arrays import Array
from workbench.design.auto import auto_judged, auto_steps
from workbench.design.filtered_image import FilteredImage
from workbench.design.levels import finest_image
from workbench.design.memory import check_auto, memory_notes
from workbench.design.paper import check_paper, paper_steps
from workbench.design.room import Room
from workbench.design.step import Step
from workbench.geometry.faces import ControlHeights
from workbench.scene import Scene

Heights = Mapping[str, Tensor]


class Image(Protocol):
    """The light by which a method compares lenses."""

    def compare(self, heights: Heights) -> tuple[Tensor, Step]:
        """What is wrong with the light of a lens, and the step to report.

        Raises
        ------
        RunFailed
            If there is no light, or what is wrong with it is not finite.
        """


class Method(NamedTuple):
    """A way to search for a lens."""

    # Evaluates lens after lens in a room and returns why it ended.
    steps: Callable[[Room], Generator[Step, None, str]]
    # What it judges lenses by: for a scene, a target and the heights of a lens like those to come.
    image: Callable[[Scene, Array, Heights], Image]
    check: Callable[[Scene], None]  # refuses a scene that it cannot design
    # What a run of a scene says of itself from the beginning.
    notes: Callable[[Scene], tuple[str, ...]]
    # The best lens of a run in light that it was not fitted to, of a scene, a target and the
    # control heights; None where the run has seen it so.
    judged: Callable[[Scene, Array, ControlHeights], Step | None]


def method_of(scene: Scene) -> Method:
    """The method that a scene asks for."""
    return _METHODS[scene.run.method]


_METHODS = {
    "auto": Method(auto_steps, finest_image, check_auto, memory_notes, auto_judged),
    "paper": Method(
        paper_steps,
        lambda scene, target, heights: FilteredImage(scene, target),
        check_paper,
        notes=lambda scene: (),
        judged=lambda scene, target, heights: None,
    ),
}
