"""An image of light, in an even or a logarithmic scale."""

from typing import TYPE_CHECKING

from ui.views.image_link import ImageLink
from ui.views.screen_image_view import OnScreen, ScreenImageView
from ui.words import tr
from workbench.arrays import Array
from workbench.pictures.images import IrradianceImage

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class LightContent(OnScreen):
    """Irradiance or intensity, on a scale that follows the target."""

    image: IrradianceImage

    def __init__(self, values: "Callable[[Frame], Array]", name: str = "") -> None:
        self._name, self._light = name, values
        self._look = (False, "")  # logarithmic, colours

    def begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Begin an empty image with the current scale and colours."""
        self.image = IrradianceImage(axes, session.scene, session.target, self._name)
        self._look = (False, "")
        return self.image.artists

    def change(self, frame: "Frame") -> bool:
        """Show the flux of a frame."""
        return self.image.update(self._light(frame))

    def values(self, frame: "Frame") -> Array:
        """Values of the image, in the scene's unit."""
        return self.image.values

    def set_look(self, logarithmic: bool, colours: str) -> bool:
        """Set scale and colours; return whether they changed."""
        if (logarithmic, colours) == self._look:
            return False
        self._look = (logarithmic, colours)
        self.image.set_logarithmic(logarithmic)
        self.image.set_colours(colours)
        return True


class LightImageView(ScreenImageView):
    """View of light with shared scale and colours."""

    _content: LightContent

    def __init__(self, content: LightContent, link: ImageLink | None = None) -> None:
        super().__init__(content, link)
        self._logarithmic = self._add_tool(
            "logarithmic",
            tr("Logarithmic colours"),
            tr("Logarithmic colours, over three decades: stray light is seen"),
        )
        self._logarithmic.toggled.connect(self._link.set_logarithmic)

    def _adapt(self) -> bool:
        everything, link = super()._adapt(), self._link
        self._logarithmic.setChecked(link.logarithmic)
        return self._content.set_look(link.logarithmic, link.colours) or everything
