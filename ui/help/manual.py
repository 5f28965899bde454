"""The manual, to read beside the window."""

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget

from resources import path

_COLUMNS, _ROWS = 100, 40  # characters and lines seen at once


class Manual(QDialog):
    """All that can be done here and in a shell.

    Parameters
    ----------
    window : QWidget
        The dialog stands over it.
    """

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self.setWindowTitle("Manual")
        text = QTextBrowser(openExternalLinks=True)
        text.setAccessibleName("Manual")
        text.setMarkdown(path("manual.md").read_text("utf-8"))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        for widget in (text, buttons):
            column.addWidget(widget)
        font = self.fontMetrics()
        wanted = font.averageCharWidth() * _COLUMNS, font.lineSpacing() * _ROWS
        self.resize(min(wanted[0], window.width()), min(wanted[1], window.height()))
