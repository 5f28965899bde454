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
    """What a photo is asked of.

    Attributes
    ----------
    frame : Frame
        The lens.
    image : int
        Which of the design's images; 0 is the first.
    light : str
        What lights the lens, one of `LIGHTS`; empty for what its source is likely to be.
    """

    frame: "Frame"
    image: int
    light: str

    def same(self, other: "PhotoRequest") -> bool:
        """Whether both ask for the same photo."""
        asked = (self.image, self.light) == (other.image, other.light)
        return asked and same_light(self.frame, other.frame)


def take_photo(request: PhotoRequest, task: Task) -> "Photo | None":
    """The photo of a request, None if nobody wants it any more; meant for a thread.

    Reports the part that is done.
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
