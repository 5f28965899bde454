"""One sentence on top of the work, until it is read and closed."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QSizePolicy, QStyle, QToolButton, QWidget

from ui import theme


class MessageBar(QFrame):
    """Shows failures and notes without stopping anybody; hidden while there is nothing to say.

    Attributes
    ----------
    said : Signal(str)
        Each of them as it is shown.
    """

    said = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self._icon = QLabel()
        self._text = QLabel()
        self._text.setWordWrap(True)
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._text.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        close = QToolButton()
        close.setText("✕")
        close.setAutoRaise(True)
        close.setToolTip("Close this message")
        close.setAccessibleName("Close this message")
        close.clicked.connect(self.clear)
        row = QHBoxLayout(self)
        row.setContentsMargins(10, 6, 6, 6)
        row.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self._text, 1)
        row.addWidget(close, 0, Qt.AlignmentFlag.AlignTop)
        self.hide()

    @property
    def text(self) -> str:
        """What it says; empty while hidden."""
        return self._text.text()

    def warn(self, text: str) -> None:
        """Say what went wrong, and what to do."""
        self._show("warning", QStyle.StandardPixmap.SP_MessageBoxWarning, text)

    def note(self, text: str) -> None:
        """Say something good to know."""
        self._show("note", QStyle.StandardPixmap.SP_MessageBoxInformation, text)

    def clear(self) -> None:
        """Say nothing any more."""
        self._text.clear()
        self.hide()

    def _show(self, kind: str, icon: QStyle.StandardPixmap, text: str) -> None:
        self.setObjectName(kind)
        theme.restyle(self)
        self._icon.setPixmap(self.style().standardIcon(icon).pixmap(18, 18))
        self._text.setText(text)
        self.show()
        self.said.emit(text)
