"""Light account."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QWidget

from ui.views.choices import ImageChoice
from ui.views.shared_view import SharedView
from ui.views.view import View
from ui.words import later, tr
from workbench.optics.account import LOSSES, losses_in, words_for
from workbench.scene import Screen

if TYPE_CHECKING:
    from ui.document.frame import Frame
    from workbench.files.session import Session

_AT_FIRST = words_for(Screen)
_SUM = later(("All parts", "Sum of all parts; 100 % when the account is complete."))


class LightView(View):
    """Table of the parts of the emitted light, in percent."""

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._shared.changed.connect(self._ask)
        self._choice = ImageChoice(self._shared)
        self._box.addWidget(self._choice)
        table = QWidget()
        self._grid = QGridLayout(table)
        self._grid.setContentsMargins(8, 6, 8, 6)
        self._grid.setVerticalSpacing(2)
        self._grid.setHorizontalSpacing(8)
        self._grid.setColumnStretch(1, 1)
        self._rows = {
            name: _AccountLine(self._grid, *map(tr, text)) for name, text in _AT_FIRST.items()
        }
        rule = QFrame(frameShape=QFrame.Shape.HLine, frameShadow=QFrame.Shadow.Plain)
        rule.setForegroundRole(QPalette.ColorRole.Mid)
        self._grid.addWidget(rule, self._grid.rowCount(), 0, 1, 3)
        self._sum = _AccountLine(self._grid, *map(tr, _SUM))
        self._grid.setRowStretch(self._grid.rowCount(), 1)
        self._box.addWidget(table)

    def texts(self) -> dict[str, str]:
        lines = (*self._rows.values(), self._sum)
        return {line.name.text(): line.value.text() for line in lines if not line.value.isHidden()}

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        self._choice.show_scene(session.scene)
        session, frame = self._of_image(session, frame)
        there = losses_in(session.scene)
        for name, text in words_for(session.scene.receiver).items():
            self._rows[name].call(*map(tr, text))
            self._rows[name].show(name not in LOSSES or name in there)
        if frame is None:
            for line in (*self._rows.values(), self._sum):
                line.clear()
            return
        account = frame.state.account
        flux = account.to_data()
        shares = {name: flux.get(name, 0.0) / account.emitted for name in self._rows}
        for name, share in shares.items():
            self._rows[name].show_share(share)
        self._sum.show_share(sum(shares.values()))
        self.repaint()


class _AccountLine:
    def __init__(self, grid: QGridLayout, name: str, tip: str) -> None:
        self.name = QLabel()
        self.value = QLabel()
        self._bar = _Bar()
        self.value.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.value.setMinimumWidth(self.value.fontMetrics().horizontalAdvance("100.00 %"))
        row = grid.rowCount()
        for column, widget in enumerate((self.name, self._bar, self.value)):
            grid.addWidget(widget, row, column)
        self.call(name, tip)

    def call(self, name: str, tip: str) -> None:
        self.name.setText(name)
        self.value.setAccessibleName(name)
        for widget in (self.name, self._bar, self.value):
            widget.setToolTip(f"<p>{tip}</p>")

    def show(self, shown: bool) -> None:
        for widget in (self.name, self._bar, self.value):
            widget.setVisible(shown)

    def clear(self) -> None:
        self.value.clear()
        self._bar.show_share(0.0)

    def show_share(self, share: float) -> None:
        percent = round(100 * share, 2) + 0.0  # no minus before a zero
        self.value.setText(f"{percent:.2f} %")
        self._bar.show_share(share)
        for label in (self.name, self.value):
            label.setEnabled(bool(percent))


class _Bar(QWidget):
    def __init__(self) -> None:
        super().__init__()
        self.setMinimumWidth(20)
        self._share = 0.0

    def show_share(self, share: float) -> None:
        if share != self._share:
            self._share = share
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        thick = 5.0
        painter = QPainter(self)
        track = QRectF(0, (self.height() - thick) / 2, self.width(), thick)
        painter.fillRect(track, self.palette().midlight())
        track.setWidth(self.width() * min(max(self._share, 0.0), 1.0))
        painter.fillRect(track, self.palette().highlight())
        painter.end()
