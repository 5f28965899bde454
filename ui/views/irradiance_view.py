"""The irradiance on the screen."""

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ui.views.light_image_view import LightImageView

if TYPE_CHECKING:
    from ui.shown.frame import Frame


class IrradianceView(LightImageView):
    """Flux per area as the optimiser sees it."""

    _NAME = "irradiance"

    def _shown_values(self, frame: "Frame") -> npt.NDArray[np.float64]:
        return frame.snapshot.irradiance
