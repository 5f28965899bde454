"""The target on the screen."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtWidgets import QWidget

from ui.shown.frame import same_task
from ui.views.image_link import ImageLink
from ui.views.light_image_view import LightContent, LightImageView
from workbench.pictures.images import target_irradiance

if TYPE_CHECKING:
    from ui.shown.frame import Frame


class TargetView(LightImageView):
    """The target as irradiance or intensity with a total flux of 1."""

    def __init__(self, link: ImageLink | None = None, parent: QWidget | None = None) -> None:
        super().__init__(LightContent(_target, "target"), link, parent)

    def show_frame(self, frame: "Frame") -> None:
        """Take note of another target; frames of a run have the same one."""
        before, self._frame = self._frame, frame
        self._untraced = False
        if before is None or not same_task(before.session, frame.session):
            self._ask()


def _target(frame: "Frame") -> npt.NDArray[np.float64]:
    return target_irradiance(frame.session.scene, frame.session.target)
