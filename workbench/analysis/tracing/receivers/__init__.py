"""Where light is counted: one file a kind.

A new kind of receiver is a file here and a row in ``_DETECTORS``.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from workbench.analysis.tracing.elements import Detector
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.receivers.far_field import FarFieldDetector
from workbench.analysis.tracing.receivers.plane import PlaneDetector
from workbench.scene import AnyReceiver, FarField, Screen

__all__ = ["FarFieldDetector", "PlaneDetector", "detector_of"]

_DETECTORS: Mapping[type, Callable[[Any, float, int, Pose], Detector]] = {
    Screen: PlaneDetector,
    FarField: FarFieldDetector,
}


def detector_of(
    receivers: Sequence[AnyReceiver], front_z: float, onwards: int, pose: Pose
) -> Detector:
    """The detector of some receivers of one kind, at least one, which do not hide each other.

    `receivers`: the receivers; `front_z`: the z of the scene from which rays count z; `onwards`: 1
    if light comes to them towards +z, -1 if towards -z; `pose`: how the lens stands.
    """
    return _DETECTORS[type(receivers[0])](receivers, front_z, onwards, pose)
