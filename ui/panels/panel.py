"""A panel: the rows of one part of the scene under a heading that folds them away."""

from collections.abc import Sequence, Set

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFormLayout, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from ui.panels.fields import Row
from ui.panels.rows import Make, Rows
from ui.widgets.controls import filled
from ui.words import in_sentence, tr
from workbench.files.session import Session
from workbench.scene import FieldDescription, Kinds


class Panel(QWidget):
    """Rows under a heading; independent of other panels and of the document."""

    edited = Signal(object)
    reverted = Signal(object)

    def __init__(self, title: str, rows: Sequence[Row]) -> None:
        super().__init__()
        self._rows: list[Row] = []
        self._label_width = 0
        self._session: Session | None = None
        self._heading = QToolButton()
        self._heading.setObjectName("heading")
        self._heading.setText(title)
        self._heading.setCheckable(True)
        self._heading.setChecked(True)
        self._heading.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._heading.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._heading.toggled.connect(self.unfold)
        self._body = QWidget()
        self._form = QFormLayout(self._body)
        self._form.setContentsMargins(10, 4, 6, 8)
        self._form.setVerticalSpacing(5)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft)
        self._add_rows(rows, title)
        filled(QVBoxLayout(self), self._heading, self._body, margins=0, spacing=0)
        self.unfold(True)

    @property
    def rows(self) -> Sequence[Row]:
        return self._rows

    @property
    def session(self) -> Session:
        assert self._session is not None  # shown before anything can be edited
        return self._session

    def prepare(self, session: Session) -> None:
        """Make the rows that a session needs."""

    def show_session(self, session: Session, present: Set[Row], pending: Set[str]) -> None:
        self._session = session
        for row in self.rows:
            if row in present:
                row.show_scene(session.scene, pending)
            else:
                row.forget()  # before it is hidden, which enters what is typed
            self._form.setRowVisible(row, row in present)

    def unfold(self, unfolded: bool) -> None:
        self._heading.setChecked(unfolded)
        self._heading.setArrowType(Qt.ArrowType.DownArrow if unfolded else Qt.ArrowType.RightArrow)
        self._body.setVisible(unfolded)

    def align(self, width: int) -> None:
        self._label_width = width
        for row in self.rows:
            row.label.setMinimumWidth(width)

    def _add_rows(self, rows: Sequence[Row], name: str) -> None:
        self._name_rows(rows, name)
        for row in rows:
            row.label.setMinimumWidth(self._label_width)
            self._form.addRow(row.label, row)
            row.leave_undo()
            row.edited.connect(self.edited)
            row.reverted.connect(self.reverted)
            self._rows.append(row)

    def _name_rows(self, rows: Sequence[Row], name: str) -> None:
        for row in rows:
            row.name = name
            for part in filter(None, (row.of, row.label.text())):
                row.name = tr("{panel} {field}").format(panel=row.name, field=in_sentence(part))

    def _remove_rows(self, rows: Sequence[Row]) -> None:
        for row in rows:
            row.blockSignals(True)  # an editor that loses the focus enters its text
            self._rows.remove(row)
            self._form.takeRow(row)
            for widget in (row.label, row):
                widget.hide()
                widget.deleteLater()


class PartPanel(Panel):
    """Rows generated from the fields of a part."""

    def __init__(self, field: FieldDescription, path: str = "") -> None:
        self.path = path or field.name
        rows, kinds = Rows(lambda: self.session.scene, self.own_rows()), field.mark(Kinds)
        super().__init__(
            tr(field.title),
            rows.of_kinds(field, kinds, self.path, kinds.title)
            if kinds
            else rows.of_part(field.parts[0], self.path),
        )

    def own_rows(self) -> dict[str, Make]:
        return {}
