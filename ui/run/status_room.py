"""How a sentence and figures share a status bar."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QLabel, QStatusBar, QWidget

_GAP = 8  # pixels between two things in a status bar, at most


class StatusRoom(QObject):
    """Makes room for a sentence where figures beside it would cut it off.

    First they get no wider than they are, which lets them move as they count; then the least
    important ones are hidden, until the sentence fits.

    Parameters
    ----------
    bar : QStatusBar
        Holds all of them.
    figures : sequence of QLabel
        Each with a minimum width that keeps it from moving.
    least_important : sequence of QLabel
        Those of them that may be hidden, in this order.
    """

    def __init__(
        self, bar: QStatusBar, figures: Sequence[QLabel], least_important: Sequence[QLabel]
    ) -> None:
        super().__init__(bar)
        self._bar = bar
        self._widths = {figure: figure.minimumWidth() for figure in figures}
        self._least_important = least_important
        bar.installEventFilter(self)

    def share(self) -> None:
        """Share the bar out among the texts of now, unless a message lies over them."""
        if self._bar.currentMessage():
            return
        for figure, width in self._widths.items():
            figure.setMinimumWidth(width)
            figure.show()
        if self._fits:
            return
        for figure in self._widths:
            figure.setMinimumWidth(0)
            figure.setVisible(bool(figure.text()))
        for figure in self._least_important:
            if self._fits:
                return
            figure.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Follow the width of the bar."""
        if event.type() == QEvent.Type.Resize:
            self.share()
        return super().eventFilter(watched, event)

    @property
    def _fits(self) -> bool:
        layout = self._bar.layout()
        assert layout is not None  # a status bar has one as soon as it holds something
        held = self._bar.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
        margins = layout.contentsMargins()
        needed = margins.left() + margins.right()
        for each in held:
            if not each.isHidden():
                wanted = max(each.sizeHint().width(), each.minimumWidth())
                needed += min(wanted, each.maximumWidth()) + _GAP
        return needed <= self._bar.width()
