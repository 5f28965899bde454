"""The light of one lens after the other, for people who shape them by hand."""

import torch

from workbench.arrays import Array
from workbench.design.methods import method_of
from workbench.design.snapshot import Result, Snapshot
from workbench.geometry.faces import ControlHeights
from workbench.optics.plan import tensors_of
from workbench.scene import Scene


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
