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

_RECEIVERS: Mapping[type, Callable[[Any, Element, float], Receiver]] = {
    Screen: lambda screen, optic, datum: PlaneReceiver(screen, datum, optic.onwards),
    FarField: lambda far_field, optic, datum: FarFieldReceiver(
        far_field, far_field.radius(optic), optic.onwards
    ),
}


def receiver_of(part: AnyReceiver, optic: Element, datum: float) -> Receiver:
    """The element on which light makes an image; lit by an optic; z is counted from a datum."""
    return _RECEIVERS[type(part)](part, optic, datum)
