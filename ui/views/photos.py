"""Predicted photos as views ask for them, in a thread beside the window."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ui.shown.frame import same_light
from ui.threads.background import Task
from ui.threads.cores import other_cores

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.analysis.photo.photo import Photo


@dataclass(frozen=True, eq=False)
class PhotoRequest:
    """Request for a photo."""

    frame: "Frame"
    image: int
    light: str

    def same(self, other: "PhotoRequest") -> bool:
        """Whether both requests are for the same photo."""
        asked = (self.image, self.light) == (other.image, other.light)
        return asked and same_light(self.frame, other.frame)


def take_photo(request: PhotoRequest, task: Task) -> "Photo | None":
    """Return the photo of a request, None if cancelled; called in a thread.

    Reports the finished fraction.
    """
    # Late: what it stands on is slow to import.
    from workbench.analysis.photo.light import LIGHTS
    from workbench.analysis.photo.photo import photographing

    session = request.frame.session.of_image(request.image)
    steps = photographing(
        session.scene,
        session.target,
        request.frame.state.heights,
        LIGHTS.get(request.light),
        threads=other_cores(),
    )
    return task.follow(steps, task.report)
