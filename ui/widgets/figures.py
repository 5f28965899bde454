"""Figures of matplotlib in dialogs, and translation of their texts."""

import re
from collections.abc import Collection, Iterable
from typing import cast

from matplotlib import rcParams
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import fontManager
from matplotlib.lines import Line2D
from matplotlib.text import Text
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QSizePolicy, QWidget

import resources
from ui.words import tr
from workbench.pictures.axes import paint

fontManager.addfont(resources.path("fonts", "Inter-Regular.otf"))
rcParams["font.family"] = ["Inter", *rcParams["font.family"]]  # the latter for missing signs


class FigureCanvas(FigureCanvasQTAgg):
    """A figure in the colours of its parent, which are those of the theme."""

    def __init__(self, parent: QWidget, name: str, figure: Figure) -> None:
        super().__init__(figure)
        self._window = parent
        self.setParent(parent)
        self.setAccessibleName(name)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        parent.installEventFilter(self)
        self.recolour()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.PaletteChange:
            self.recolour()
        return bool(super().eventFilter(watched, event))

    def recolour(self) -> None:
        palette = self._window.palette()
        paint(self.figure, palette.windowText().color().name(), palette.window().color().name())
        self.draw_idle()


_WITH_UNIT = re.compile(r"(.*\w) (\(.*\))")
_NAMED = re.compile(r"(.+): (.+)")
_AT = re.compile(r"(.* \(.*\)) at (.*)")
_MEAN = re.compile(r"(10\S+ )?× mean(.*)")


def translate(figure: Figure, names: Collection[str] = ()) -> None:
    """Translate labels and legends of a new figure, labels of lines too, but not ``names``."""
    texts = cast("list[Text]", figure.findobj(Text))
    _translate_texts(text for text in texts if text.get_text() not in names)
    for line in cast("list[Line2D]", figure.findobj(Line2D)):
        if (label := str(line.get_label())) not in names:
            line.set_label(translated(label))


def translate_axes(figure: Figure) -> None:
    """Translate axis labels that changed with the data."""
    _translate_texts([axis.label for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)])


def _translate_texts(texts: Iterable[Text]) -> None:
    for text in texts:
        english = text.get_text()
        shown = translated(english)
        if shown != english:
            text.set_text(shown)


def translated(english: str) -> str:
    """Return a text of a figure, or a part of one, in the language of the window."""
    if mean := _MEAN.fullmatch(english):
        return (mean[1] or "") + tr("× mean") + mean[2]
    if at := _AT.fullmatch(english):
        return tr("{axis} at {place}").format(axis=translated(at[1]), place=at[2])
    if named := _NAMED.fullmatch(english):
        return f"{tr(named[1])}: {translated(named[2])}"
    parts = _WITH_UNIT.fullmatch(english)
    return f"{tr(parts[1])} {parts[2]}" if parts else tr(english)
