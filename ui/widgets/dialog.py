"""A dialog of parts below each other, with buttons."""

from collections.abc import Callable

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QPushButton, QVBoxLayout, QWidget

from ui.widgets.controls import Item, filled

Buttons = QDialogButtonBox.StandardButton


class Dialog(QDialog):
    """Has standard buttons, which accept or reject, and own ones."""

    def __init__(self, title: str, window: QWidget, standard: Buttons) -> None:
        super().__init__(window)
        self.setWindowTitle(title)
        self._most = window.window().size()
        self.buttons = QDialogButtonBox(standard)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)

    def add_button(
        self, text: str, tip: str = "", act: Callable[[], object] | None = None
    ) -> QPushButton:
        """Add a button that acts, or one that accepts."""
        roles = QDialogButtonBox.ButtonRole
        button = self.buttons.addButton(text, roles.ActionRole if act else roles.AcceptRole)
        button.setToolTip(tip)
        if act is not None:
            button.clicked.connect(lambda _: act())
        return button

    def fill(self, *items: Item, size: QSize | None = None) -> None:
        """Lay out parts above the buttons, in a size that is not larger than the window."""
        filled(QVBoxLayout(self), *items, self.buttons)
        if size is not None:
            self.resize(size.boundedTo(self._most))
