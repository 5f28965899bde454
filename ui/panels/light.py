"""Behind the lens: the screen, and how rays become an image on it."""

from ui.panels.fields import LENGTH, NumberRow, Row
from ui.panels.optional import KindRow
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
        super().__init__("Image filter", filter_rows("filter"))


def filter_rows(path: str, label: str = "Kind", otherwise: str = "") -> list[Row]:
    """Rows of an image filter.

    Parameters
    ----------
    path : str
        Where it is in the scene.
    label : str
        What stands before its kind.
    otherwise : str
        What a person reads for there being none, where one may be left out.
    """
    return [
        KindRow(
            path,
            label,
            "How a ray's light is shared among pixels. A Gaussian lets the design feel "
            "where in a pixel a ray lands; a box counts rays.",
            [("gaussian", "Gaussian"), ("box", "Box")],
            lambda kind: {"kind": kind},
            otherwise,
        ),
        NumberRow(
            f"{path}.size",
            "Size",
            "Pixels along x and y that one ray reaches; odd numbers.",
            "px",
            between="×",
            whole=True,
        ),
        NumberRow(
            f"{path}.alpha",
            "Alpha",
            "How fast the Gaussian falls: exp(−alpha · distance²). Small is wide.",
            "px⁻²",
        ),
    ]
