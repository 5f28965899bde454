"""Rows under a heading that folds them away."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFormLayout, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from ui.widgets.controls import filled
from ui.widgets.labels import text_label


class Fold(QWidget):
    """A heading with a note, and a body that it folds away."""

    unfolded = Signal(bool)  # by a person

    def __init__(self, title: str) -> None:
        super().__init__()
        self.title = title
        self._heading = QToolButton()
        self._heading.setObjectName("heading")
        self._heading.setCheckable(True)
        self._heading.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._heading.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._heading.clicked.connect(self.unfold)
        self._heading.clicked.connect(self.unfolded)
        self._open, self._forced = True, False
        self.body = QWidget()
        filled(QVBoxLayout(self), self._heading, self.body, margins=0, spacing=0)
        self.note("")
        self.unfold(True)

    def note(self, text: str, tip: str = "") -> None:
        """Show a short text behind the title."""
        self._heading.setText(f"{self.title} · {text}" if text else self.title)
        self._heading.setToolTip(tip)

    def unfold(self, unfolded: bool) -> None:
        self._open = unfolded
        self.force(self._forced)

    def force(self, forced: bool) -> None:
        """Show the body for the time being, whether it is folded or not."""
        self._forced = forced
        shown = self._open or forced
        self._heading.setChecked(shown)
        self._heading.setArrowType(Qt.ArrowType.DownArrow if shown else Qt.ArrowType.RightArrow)
        self.body.setVisible(shown)


def form_in(body: QWidget) -> QFormLayout:
    """Return a layout of rows in a widget."""
    form = QFormLayout(body)
    form.setContentsMargins(8, 4, 8, 8)
    form.setHorizontalSpacing(8)
    form.setVerticalSpacing(4)
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
    form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft)
    return form


class Section(QWidget):
    """Rows of one panel within a group of several."""

    def __init__(self, title: str) -> None:
        super().__init__()
        self.heading, body = text_label(title, "section"), QWidget()
        self.form = form_in(body)
        filled(QVBoxLayout(self), self.heading, body, margins=0, spacing=0)
