"""What the images of scenes are called, where there are several."""

from typing import TYPE_CHECKING

from ui.words import tr
from workbench.powers import written

if TYPE_CHECKING:
    from workbench.scene import AnyReceiver, Scene


def image_titles(*scenes: "Scene") -> list[str]:
    """Return number and position of each image of the scenes.

    A scene with fewer images repeats its last one. Positions that differ between scenes are joined
    by an arrow.
    """
    most = max(len(scene.receivers) for scene in scenes)
    titles = []
    for number in range(most):
        places = [_place(scene.receivers[: number + 1][-1], scene.unit) for scene in scenes]
        place = " → ".join(dict.fromkeys(places))
        titles.append(tr("Image {number}, {place}").format(number=number + 1, place=place))
    return titles


def _place(receiver: "AnyReceiver", unit: str) -> str:
    if receiver.at_distance:
        return f"z = {written(receiver.plane_z, unit)}"
    return tr(receiver.called)
