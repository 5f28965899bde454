"""Behind the lens: the screen, and how rays become an image on it."""

from ui.panels.fields import LENGTH, Changes, ChoiceRow, NumberRow
from ui.panels.panel import Panel


class ScreenPanel(Panel):
    """Bound to ``scene.screen``."""

    def __init__(self) -> None:
        super().__init__(
            "Screen",
            [
                NumberRow(
                    "screen.z",
                    "At z",
                    "Where the screen stands on the optical axis; beyond the lens.",
                    LENGTH,
                ),
                NumberRow(
                    "screen.half_width",
                    "Half width",
                    "Half of the screen's extent along x and y. The target fills it.",
                    LENGTH,
                    between="×",
                ),
                NumberRow(
                    "screen.pixels",
                    "Pixels",
                    "Pixels along x and y in which the light is counted and compared "
                    "with the target.",
                    between="×",
                    whole=True,
                ),
            ],
        )


class FilterPanel(Panel):
    """Bound to ``scene.filter``."""

    def __init__(self) -> None:
        super().__init__(
            "Image filter",
            [
                ChoiceRow(
                    "filter.kind",
                    "Kind",
                    "How a ray's light is shared among pixels. A Gaussian lets the design feel "
                    "where in a pixel a ray lands; a box counts rays.",
                    [("gaussian", "Gaussian"), ("box", "Box")],
                    changes=self._change_kind,
                ),
                NumberRow(
                    "filter.size",
                    "Size",
                    "Pixels along x and y that one ray reaches; odd numbers.",
                    "px",
                    between="×",
                    whole=True,
                ),
                NumberRow(
                    "filter.alpha",
                    "Alpha",
                    "How fast the Gaussian falls: exp(−alpha · distance²). Small is wide.",
                    "px⁻²",
                ),
            ],
        )

    def _change_kind(self, choice: str) -> Changes:
        return {"filter": {"kind": choice}}
