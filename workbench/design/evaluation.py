"""The light of one lens after the other, for people who shape them by hand."""

from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.design.lens_state import LensState
from workbench.design.levels import FINE, image_of, reach_of
from workbench.design.limits import HeightLimits
from workbench.design.loss import check_finite, check_light, measure_of, paper_loss, share
from workbench.design.snapshot import Result, Snapshot
from workbench.design.step import Step
from workbench.geometry.faces import NO_LOCKS, ControlHeights, FaceArrays, Locks
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan, device_of
from workbench.scene import Lens, PaperRun, Scene

Array = npt.NDArray[np.float64]


class Evaluator:
    """Judges lenses as a run of the scene would: by the same rays, filter and loss.

    All that does not depend on the lens is computed once, here.

    Parameters
    ----------
    scene : Scene
        The design task.
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, row 0 at +y.
    heights : ControlHeights
        Control heights of a lens like those to come, scene units; says how far their light falls.
    locked : Locks
        Control points whose heights are the same in all lenses to come; see `suits`.

    Raises
    ------
    Refused
        If the scene asks for a device that is not there.
    """

    def __init__(
        self, scene: Scene, target: Array, heights: ControlHeights, locked: Locks = NO_LOCKS
    ) -> None:
        self._scene, self._locked = scene, locked
        self._kept = heights
        self._device = device_of(scene)
        if isinstance(scene.run, PaperRun):
            self._plan = Plan(scene, locked=locked.get("exit"))
            self._wanted = torch.as_tensor(share(target), dtype=torch.float32, device=self._device)
            self._step = self._step_of_paper
        else:
            reach = reach_of(scene, self._tensors(heights))
            image = image_of(FINE, scene, target, reach)
            self._step = lambda heights: image.compare(heights)[1]

    def suits(self, scene: Scene, heights: ControlHeights, locked: Locks = NO_LOCKS) -> bool:
        """Whether it can judge a lens of this scene, with these locked control points."""
        if scene is not self._scene or locked != self._locked:
            return False
        return all(
            np.array_equal(heights[face][mask], self._kept[face][mask])
            for face, mask in locked.items()
        )

    def snapshot(self, heights: ControlHeights, earlier: Result | None = None) -> Snapshot:
        """A lens and its light, as the last of its run.

        Parameters
        ----------
        heights : ControlHeights
            Control heights of each freeform face by its name, scene units.
        earlier : Result, optional
            Where the lens comes from; its iterations and seconds are counted in.

        Raises
        ------
        RunFailed
            If no light reaches the screen.
        """
        with torch.no_grad():
            step = self._step(self._tensors(heights))
        scene, count = self._scene, earlier.iterations if earlier else 0
        return Snapshot(
            step.state,
            iteration=count,
            iterations=max(scene.run.iterations, count),
            seconds=earlier.seconds if earlier else 0.0,
            best=True,
            stage=len(scene.run.stages),
            stages=1 + len(scene.run.stages),
            notes=step.notes,
        )

    def _step_of_paper(self, heights: Mapping[str, Tensor]) -> Step:
        traced = self._plan.trace(heights)
        check_light(traced.flux, traced.account)
        loss = paper_loss(traced.flux, self._wanted, measure_of(self._scene.receiver, self._device))
        check_finite(loss, traced.account)
        measure = self._scene.receiver.pixel_measure
        state = LensState.traced(heights, traced.flux, measure, loss, traced.account)
        return Step(state, self._plan.notes)

    def _tensors(self, heights: ControlHeights) -> dict[str, Tensor]:
        return {face: torch.tensor(each, device=self._device) for face, each in heights.items()}


def undesigned(lens: Lens) -> ControlHeights:
    """Control heights of a lens before any design, scene units."""
    return FaceArrays({"exit": HeightLimits.of(lens, ControlNet.of(lens)).undesigned})
