"""Where light is wanted: one file a kind.

A new kind of receiver is a file here, its fields in `workbench.scene`, and a row in ``_RECEIVERS``.
"""

from collections.abc import Callable, Mapping
from typing import Any

from workbench.optics.receivers.far_field import FarFieldReceiver
from workbench.optics.receivers.plane import PlaneReceiver
from workbench.optics.receivers.receiver import Receiver, ReceiverNumbers
from workbench.scene import AnyReceiver, Element, FarField, Screen

__all__ = ["FarFieldReceiver", "PlaneReceiver", "Receiver", "ReceiverNumbers", "receiver_of"]

_RECEIVERS: Mapping[type, Callable[[Any, Element, float, int], Receiver]] = {
    Screen: lambda screen, _, datum, onwards: PlaneReceiver(screen, datum, onwards),
    FarField: lambda far_field, optic, _, onwards: FarFieldReceiver(
        far_field, far_field.radius(optic), onwards
    ),
}


def receiver_of(part: AnyReceiver, optic: Element, datum: float, onwards: int) -> Receiver:
    """The element on which light makes an image; lit by an optic; z is counted from a datum.

    ``onwards`` is 1 for light that comes along +z of the receiver's own coordinates, −1 for light
    that comes against it.
    """
    return _RECEIVERS[type(part)](part, optic, datum, onwards)
