"""Processes with usual values, and where the values come from."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from workbench import units
from workbench.errors import Refused, shown
from workbench.messages import Message
from workbench.scene.making.milling import Milling
from workbench.scene.making.moulding import Moulding
from workbench.scene.making.polishing import Polishing
from workbench.scene.making.printing import Printing
from workbench.scene.making.process import Process
from workbench.scene.making.turning import Turning

_TYPICAL = Message("typical value, no source")
_MISUMI = Message("largest value of MISUMI, Plastic Molding Tutorial #004, table 1, 2009")
_FORM = Message(
    "layers: toglefritz.com, Form 1+ 0.1mm vs. 0.025mm Layer Thickness; pixels: typical value"
)


class Preset(NamedTuple):
    """A process with lengths in mm, its title for users, and the source of its values."""

    title: Message
    process: Process
    source: Message

    def in_unit(self, unit: str) -> Process:
        """Return the process with lengths in a unit."""
        return self.process.scaled(units.ratio("mm", unit))


PRESETS = {
    "mill-3mm": Preset(
        Message("Milling: ball of 3 mm, scallops of 5 µm"),
        Milling(ball_radius=1.5, step_over=0.2447),
        _TYPICAL,
    ),
    "mill-1mm": Preset(
        Message("Milling: ball of 1 mm, scallops of 1 µm"),
        Milling(ball_radius=0.5, step_over=0.0632),
        _TYPICAL,
    ),
    "turn": Preset(
        Message("Diamond turning: nose of 0.5 mm, feed of 5 µm"),
        Turning(nose_radius=0.5, feed=0.005),
        _TYPICAL,
    ),
    "polish": Preset(
        Message("Polishing over a width of 0.1 mm"),
        Polishing(width=0.1),
        _TYPICAL,
    ),
    "mould-pmma": Preset(
        Message("Injection moulding of PMMA: shrinkage of 0.4 %"),
        Moulding(shrinkage=0.004),
        _MISUMI,
    ),
    "mould-ps": Preset(
        Message("Injection moulding of PS: shrinkage of 0.7 %"),
        Moulding(shrinkage=0.007),
        _MISUMI,
    ),
    "print-50um": Preset(
        Message("Resin printing: layers and pixels of 50 µm"),
        Printing(layer_height=0.05, pixel_size=0.05),
        _FORM,
    ),
    "print-25um": Preset(
        Message("Resin printing: layers of 25 µm, pixels of 50 µm"),
        Printing(layer_height=0.025, pixel_size=0.05),
        _FORM,
    ),
}
"""Presets by the names that the command line knows."""


def preset_processes(names: Sequence[str], unit: str) -> list[dict[str, Any]]:
    """Return the processes of presets as a scene file in a unit has them.

    Raises `Refused` if there is no such preset.
    """
    for name in names:
        if name not in PRESETS:
            known = ", ".join(PRESETS)
            raise Refused(
                "preset", Message("{value}; one of {known}", value=shown(name), known=known)
            )
    return [PRESETS[name].in_unit(unit).model_dump(mode="json") for name in names]
