"""The light's way outside the lens: source, screen and how rays become an image."""

from ui.panels.fields import LENGTH, Changes, ChoiceRow, NumberRow
from ui.panels.panel import Panel


class SourcePanel(Panel):
    """Bound to ``scene.source``."""

    def __init__(self) -> None:
        super().__init__(
            "Source",
            [
                ChoiceRow(
                    "source.kind",
                    "Kind",
                    "Parallel light along the optical axis that fills the entrance face.",
                    [("collimated", "Collimated")],
                ),
                NumberRow(
                    "source.rays",
                    "Rays",
                    "Rays traced along x and y in each iteration. More rays give a smoother "
                    "image and take longer; at least two per pixel and axis are good.",
                    between="×",
                    whole=True,
                ),
            ],
        )


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
