"""Words in pictures of the engine, in the language of the window."""

import re
from typing import cast

from matplotlib.figure import Figure
from matplotlib.text import Text

from ui.words import later, tr

LABELS = later(
    (
        later("iteration"),
        later("seconds"),
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
_FLUX = "flux / "


def translate(figure: Figure) -> None:
    """Say labels and legends of a picture that has just begun in the language that is spoken."""
    for text in cast("list[Text]", figure.findobj(Text)):
        english = text.get_text()
        said = _said(english)
        if said != english:
            text.set_text(said)


def _said(english: str) -> str:
    if english.startswith(_FLUX):
        return tr("flux / {unit}").format(unit=english.removeprefix(_FLUX))
    parts = _WITH_UNIT.fullmatch(english)
    return f"{tr(parts[1])} {parts[2]}" if parts else tr(english)
