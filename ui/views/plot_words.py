"""Words in pictures of the engine, in the language of the window."""

import re
from collections.abc import Iterable
from typing import cast

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text

from ui.words import later, tr

LABELS = later(
    (
        later("iteration"),
        later("time"),
        later("distance"),
        later("loss"),
        later("this run"),
        later("verified"),
        later("target"),
        later("irradiance"),
        later("intensity"),
        later("error"),
        "as designed",
        "relative L2 error",
        "lenses up to there",
        "z of the screen",
    )
)
"""What stands at axes and in legends, as far as it is no unit and no number.

Words in small letters alone could be names of fields; each is marked by itself.
"""

_WITH_UNIT = re.compile(r"(.*\w) (\(.*\))")
_AT = re.compile(r"(.* \(.*\)) at (.*)")
_FLUX = re.compile(r"(10\S+ )?flux / (.*)")


def translate(figure: Figure) -> None:
    """Say labels and legends of a picture that has just begun in the language that is spoken.

    Lines are named in it, too, since a legend may be made of them later.
    """
    _say(cast("list[Text]", figure.findobj(Text)))
    for line in cast("list[Line2D]", figure.findobj(Line2D)):
        line.set_label(_said(str(line.get_label())))


def translate_axes(figure: Figure) -> None:
    """Say labels of axes that have changed with what is shown in the language that is spoken."""
    _say([axis.label for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)])


def _say(texts: Iterable[Text]) -> None:
    for text in texts:
        english = text.get_text()
        said = _said(english)
        if said != english:
            text.set_text(said)


def _said(english: str) -> str:
    if flux := _FLUX.fullmatch(english):
        return (flux[1] or "") + tr("flux / {unit}").format(unit=flux[2])
    if at := _AT.fullmatch(english):
        return tr("{axis} at {place}").format(axis=_said(at[1]), place=at[2])
    parts = _WITH_UNIT.fullmatch(english)
    return f"{tr(parts[1])} {parts[2]}" if parts else tr(english)
