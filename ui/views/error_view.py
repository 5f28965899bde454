"""Images of light: irradiance, target and signed error."""

from typing import TYPE_CHECKING

from ui.views.image_link import ImageLink
from ui.views.screen_image_view import OnScreen, ScreenImageView
from workbench.arrays import Array
from workbench.pictures.images import ErrorImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class ErrorContent(OnScreen):
    """Irradiance minus target as shown: red is too much light, blue too little."""

    image: ErrorImage

    def begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Begin an empty image."""
        self.image = ErrorImage(axes, session.scene, session.target)
        return self.image.artists

    def change(self, frame: "Frame") -> bool:
        """Show the error of a frame."""
        return self.image.update(frame.state.irradiance)

    def values(self, frame: "Frame") -> Array:
        """Values of the image, signed."""
        return self.image.values


class ErrorView(ScreenImageView):
    """View of the signed error."""

    def __init__(self, link: ImageLink | None = None) -> None:
        super().__init__(ErrorContent(), link)
