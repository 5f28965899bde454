"""The irradiance on the screen."""

from PySide6.QtWidgets import QWidget

from ui.views.image_link import ImageLink
from ui.views.light_image_view import LightContent, LightImageView


class IrradianceView(LightImageView):
    """Flux per area as the optimiser sees it."""

    def __init__(self, link: ImageLink | None = None, parent: QWidget | None = None) -> None:
        content = LightContent(lambda frame: frame.state.irradiance)
        super().__init__(content, link, parent)
