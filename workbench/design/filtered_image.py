"""The image of rays through a filter, against the target: how the paper compares lenses."""

from collections.abc import Mapping

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.lens_state import LensState
from workbench.design.loss import check_finite, check_light, measure_of, paper_loss, share
from workbench.design.step import Step
from workbench.optics.plan import Plan, device_of
from workbench.scene import Scene


class FilteredImage:
    """Compares lenses with the target by the light that lands on the screen.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y. Raises `Refused` if the scene
    asks for a device that is not there, or for several images.
    """

    def __init__(self, scene: Scene, target: Array) -> None:
        scene.check_one_image("the paper's method")
        device = device_of(scene)
        self._scene, self._plan = scene, Plan(scene)
        self._wanted = torch.as_tensor(share(target), dtype=torch.float32, device=device)
        self._relative = measure_of(scene.receiver, device)
        self._pixel_measure = scene.receiver.pixel_measure

    def compare(self, heights: Mapping[str, Tensor]) -> tuple[Tensor, Step]:
        """The loss, and the step to report.

        Raises `RunFailed` if no light reaches the screen, or the loss is not finite.
        """
        traced = self._plan.trace(heights)
        check_light(traced.flux.detach(), traced.account, self._scene)
        loss = paper_loss(traced.flux, self._wanted, self._relative)
        check_finite(loss, traced.account)
        state = LensState.traced(heights, traced.flux, self._pixel_measure, loss, traced.account)
        return loss, Step(state, self._plan.notes)

    def next_iteration(self) -> None:
        """Take new rays, if the source is to have fresh ones for each iteration."""
        self._plan.next_iteration()
