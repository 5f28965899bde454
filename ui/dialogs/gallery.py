"""The examples, each with a small picture of its target."""

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QIcon, QPixmap
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QListView,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from resources import Example
from ui.widgets.controls import filled
from ui.widgets.labels import WrappedLabel
from ui.words import tr
from workbench.errors import Refused
from workbench.files.scene import read_scene

_PICTURE = 96  # logical pixels
_CELL = 150  # wide
_SIZE = QSize(680, 560)


class Gallery(QDialog):
    """Dialog to choose an example by keyboard or mouse."""

    chosen = Signal(object)  # Example

    def __init__(self, examples: Sequence[Example], window: QWidget) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("New from example"))
        self._examples = examples
        self._list = QListWidget()
        self._list.setAccessibleName(tr("Examples"))
        self._list.setViewMode(QListView.ViewMode.IconMode)
        self._list.setResizeMode(QListView.ResizeMode.Adjust)
        self._list.setMovement(QListView.Movement.Static)
        self._list.setIconSize(QSize(_PICTURE, _PICTURE))
        below = 3 * self._list.fontMetrics().lineSpacing()  # two lines, and some air
        self._list.setGridSize(QSize(_CELL, _PICTURE + below))
        self._list.setWordWrap(True)
        for example in examples:
            self._list.addItem(self._item(example))
        self._description = WrappedLabel()
        self._description.setMinimumHeight(3 * self._description.fontMetrics().lineSpacing())
        self._description.setAlignment(Qt.AlignmentFlag.AlignTop)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Open | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        filled(QVBoxLayout(self), (self._list, 1), self._description, buttons)
        self._list.currentRowChanged.connect(self._describe)
        self._list.itemDoubleClicked.connect(self.accept)
        self._list.setCurrentRow(0)
        self.resize(_SIZE.boundedTo(window.size()))

    def accept(self) -> None:
        example = self._examples[self._list.currentRow()]
        super().accept()
        self.chosen.emit(example)

    def _describe(self, row: int) -> None:
        example = self._examples[row]
        self._description.setText(f"{tr(example.group)}: {tr(example.look)}")

    def _item(self, example: Example) -> QListWidgetItem:
        item = QListWidgetItem(self._picture(example), tr(example.title))
        item.setToolTip(tr(example.look))
        item.setTextAlignment(Qt.AlignmentFlag.AlignHCenter)
        return item

    def _picture(self, example: Example) -> QIcon:
        try:
            image = read_scene(example.file).image
        except Refused:  # reported when it is opened
            return QIcon()
        if image is None:
            return QIcon()
        side = round(_PICTURE * self.devicePixelRatioF())
        picture = QPixmap(image).scaled(
            side,
            side,
            Qt.AspectRatioMode.KeepAspectRatio,
            Qt.TransformationMode.SmoothTransformation,
        )
        picture.setDevicePixelRatio(self.devicePixelRatioF())
        return QIcon(picture)
