"""The target on the screen."""

from typing import TYPE_CHECKING

from ui.shown.frame import same_task
from ui.views.image_link import ImageLink
from ui.views.light_image_view import LightContent, LightImageView
from ui.words import later, tr
from workbench.arrays import Array
from workbench.pictures.images import target_irradiance

if TYPE_CHECKING:
    from ui.shown.frame import Frame

_TIP = later(
    "The target with as much light as arrives: where the irradiance is "
    "right, both have the same colour, however much light is lost on the "
    "way. The light account tells where that goes."
)


_SAME = 1e-3  # parts by which no eye can tell light from light


class TargetView(LightImageView):
    """The target as irradiance or intensity, with the flux that arrives."""

    def __init__(self, link: ImageLink | None = None) -> None:
        super().__init__(LightContent(_target, "target"), link)
        self._light = 0.0  # all of it, as drawn
        self.setToolTip(tr(_TIP))

    def show_frame(self, frame: "Frame") -> None:
        """Store another target or flux."""
        before, self._frame = self._frame, frame
        self._untraced = False
        light = _light(frame)
        same = before is not None and same_task(before.session, frame.session)
        if not same or abs(light - self._light) > _SAME * light:
            self._light = light
            self._ask()


def _light(frame: "Frame") -> float:
    return frame.session.scene.receiver.total(frame.state.irradiance) or 1.0


def _target(frame: "Frame") -> Array:
    session = frame.session
    return target_irradiance(session.scene, session.target, _light(frame))
