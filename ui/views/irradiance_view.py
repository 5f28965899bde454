"""The irradiance on the screen."""

from typing import TYPE_CHECKING

from ui.views.image_link import ImageLink
from ui.views.light_image_view import LightContent, LightImageView

if TYPE_CHECKING:
    from ui.shown.frame import Frame


class IrradianceView(LightImageView):
    """View of the irradiance as computed by the optimiser."""

    def __init__(self, link: ImageLink | None = None) -> None:
        content = LightContent(lambda frame: frame.state.irradiance)
        super().__init__(content, link)

    def _change(self, frame: "Frame") -> bool:
        assert self._regions is not None  # since there is a picture
        self._regions.show_light(frame.state.irradiance)
        return super()._change(frame)
