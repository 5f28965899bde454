"""The methods of design by their names in scenes, and the evaluation of single lenses."""

from collections.abc import Callable, Generator, Mapping
from typing import NamedTuple, Protocol

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.auto import auto_judged, auto_steps
from workbench.design.bounds import Bounds
from workbench.design.lens_state import Step
from workbench.design.levels import finest_image
from workbench.design.memory import check_auto, memory_notes
from workbench.design.paper import FilteredImage, check_paper, paper_steps
from workbench.design.snapshot import Result, Snapshot
from workbench.geometry.faces import ControlHeights
from workbench.optics.plan import tensors_of
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

    # Evaluates lens after lens within bounds and returns why it ended.
    steps: Callable[[Bounds], Generator[Step, None, str]]
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


class Evaluator:
    """Judges lenses as a run of the scene would: by the same rays, filter and loss.

    All that does not depend on the lens is computed once, here.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `heights`: control heights of a
    lens like those to come, scene units; says how far their light falls. Raises `Refused` if the
    scene asks for a device that is not there.
    """

    def __init__(self, scene: Scene, target: Array, heights: ControlHeights) -> None:
        self._scene, self._target = scene, target
        self._image = method_of(scene).image(scene, target, tensors_of(heights, scene))

    def suits(self, scene: Scene, target: Array) -> bool:
        """Whether it can judge lenses of this scene and target."""
        return scene is self._scene and target is self._target

    def snapshot(self, heights: ControlHeights, earlier: Result | None = None) -> Snapshot:
        """A lens and its light, as the last of its run.

        `earlier`: where the lens comes from; its iterations and seconds are counted in. Raises
        `RunFailed` if no light reaches the screen.
        """
        with torch.no_grad():
            _, step = self._image.compare(tensors_of(heights, self._scene))
        scene, count = self._scene, earlier.iterations if earlier else 0
        return Snapshot(
            step.state,
            iteration=count,
            iterations=max(scene.run.iterations, count),
            seconds=earlier.seconds if earlier else 0.0,
            merit=step.state.loss if step.merit is None else step.merit,
            best=True,
            stage=len(scene.run.stages),
            stages=1 + len(scene.run.stages),
            notes=step.notes,
        )
