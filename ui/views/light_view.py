"""Light account."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QProgressBar, QWidget

from ui.document.frame import Frame
from ui.views.choices import ImageChoice
from ui.views.shared_view import SharedView
from ui.views.view import View
from ui.words import later, tr
from workbench.files.session import Session
from workbench.optics.account import keys_in, words_of
from workbench.scene import Screen

_WHOLE, _THICK = 1000, 6  # steps and pixels of a bar
_SUM = later(("All parts", "Sum of all parts; 100 % when the account is complete."))


class LightView(View):
    """Table of the parts of the emitted light, in percent."""

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._shared.changed.connect(self._ask)
        self._choice = ImageChoice(self._shared)
        self._box.addWidget(self._choice)
        self._table, self._words = QWidget(), dict[str, tuple[str, str]]()
        self._box.addWidget(self._table)
        self._list({"on_screen": words_of("on_screen", Screen)})

    def texts(self) -> dict[str, str]:
        return {line.name.text(): line.value.text() for line in (*self._lines.values(), self._sum)}

    def _list(self, words: dict[str, tuple[str, str]]) -> None:
        """Show one line for each part of the account, by its title and tip."""
        if words == self._words:
            return
        self._words, table = words, QWidget()
        grid = QGridLayout(table)
        grid.setContentsMargins(8, 6, 8, 6)
        grid.setVerticalSpacing(2)
        grid.setHorizontalSpacing(8)
        grid.setColumnStretch(1, 1)
        self._lines = {part: _AccountLine(grid, *map(tr, text)) for part, text in words.items()}
        rule = QFrame(frameShape=QFrame.Shape.HLine, frameShadow=QFrame.Shadow.Plain)
        rule.setForegroundRole(QPalette.ColorRole.Mid)
        grid.addWidget(rule, grid.rowCount(), 0, 1, 3)
        self._sum = _AccountLine(grid, *map(tr, _SUM))
        grid.setRowStretch(grid.rowCount(), 1)
        self._box.replaceWidget(self._table, table)
        self._table.deleteLater()
        self._table = table

    def _draw(self, session: Session, frame: Frame | None) -> None:
        self._choice.show_scene(session.scene)
        session, frame = self._of_image(session, frame)
        scene, account = session.scene, None if frame is None else frame.state.account
        parts = account.parts_in(scene) if account else ("on_screen", *keys_in(scene))
        self._list({part: words_of(part, scene.receiver) for part in parts})
        if account is None:
            for line in (*self._lines.values(), self._sum):
                line.clear()
            return
        _, *fluxes = account.to_data().values()
        for part, flux in account.parts_in(scene).items():
            self._lines[part].show_share(flux / account.emitted)
        self._sum.show_share(sum(fluxes) / account.emitted)
        self.repaint()


class _AccountLine:
    def __init__(self, grid: QGridLayout, name: str, tip: str) -> None:
        self.name = QLabel(name)
        self.value = QLabel()
        self._bar = QProgressBar(maximum=_WHOLE, textVisible=False)
        self._bar.setFixedHeight(_THICK)
        self._bar.setMinimumWidth(20)
        self.value.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.value.setMinimumWidth(self.value.fontMetrics().horizontalAdvance("100.00 %"))
        row = grid.rowCount()
        for column, widget in enumerate((self.name, self._bar, self.value)):
            grid.addWidget(widget, row, column)
        self.value.setAccessibleName(name)
        for widget in (self.name, self._bar, self.value):
            widget.setToolTip(f"<p>{tip}</p>")

    def clear(self) -> None:
        self.value.clear()
        self._bar.setValue(0)

    def show_share(self, share: float) -> None:
        percent = round(100 * share, 2) + 0.0  # no minus before a zero
        self.value.setText(f"{percent:.2f} %")
        self._bar.setValue(round(_WHOLE * min(max(share, 0.0), 1.0)))
        for label in (self.name, self.value):
            label.setEnabled(bool(percent))
