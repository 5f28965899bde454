"""Manual in a window, and the commands of the help menu."""

from collections.abc import Callable, Iterator

from PySide6.QtCore import QObject, QSettings, QSize, Qt, QUrl
from PySide6.QtGui import QImage, QResizeEvent, QTextCursor, QTextDocument
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QMainWindow,
    QMessageBox,
    QPushButton,
    QTextBrowser,
    QTextEdit,
    QVBoxLayout,
    QWidget,
)

import workbench
from resources.manual_pages import Page, pages
from ui.commands.actions import Commands
from ui.commands.command_search import CommandPalette
from ui.dialogs.coach import CoachMarks
from ui.widgets.controls import filled, named
from ui.widgets.dialog import Buttons, Dialog
from ui.widgets.labels import WrappedLabel
from ui.words import tr

_COLUMNS, _ROWS = 140, 48  # characters and lines seen at once
_LIST_COLUMNS = 36
_MARGIN = 24  # pixels beside a picture


class PageView(QTextBrowser):
    """A page whose pictures fit into the view."""

    def __init__(self) -> None:
        super().__init__(openExternalLinks=True)
        # One that came with a long page would change the width while that page is being read.
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)

    def loadResource(self, kind: int, name: QUrl | str) -> object:
        if kind != QTextDocument.ResourceType.ImageResource.value:
            return super().loadResource(kind, name)
        image = QImage(self.source().resolved(QUrl(name)).toLocalFile())
        ratio = self.devicePixelRatioF()
        wide = round(ratio * max(self.viewport().width() - _MARGIN, 1))
        if image.width() > wide:
            image = image.scaledToWidth(wide, Qt.TransformationMode.SmoothTransformation)
            image.setDevicePixelRatio(ratio)
        return image

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width() and not self.source().isEmpty():
            place = self.verticalScrollBar().value()
            self.reload()
            self.verticalScrollBar().setValue(place)


class Manual(Dialog):
    """Window of the manual."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(tr("Manual"), window, Buttons.Close)
        self._pages: list[Page] = pages()
        self._places: list[QTextCursor] = []  # of what is searched for, on this page
        search = QLineEdit(placeholderText=tr("Search"), clearButtonEnabled=True)
        tip = tr("Find pages with all words; Return shows the next match")
        self._search = named(search, tr("Search the manual"), tip)
        self._list = named(QListWidget(), tr("Pages of the manual"))
        self._list.addItems([page.title for page in self._pages])
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._nothing = WrappedLabel(textFormat=Qt.TextFormat.PlainText)
        self._nothing.hide()
        self._text = named(PageView(), tr("Manual"))
        self._search.textChanged.connect(self._find)
        self._search.returnPressed.connect(self._find_next)
        self._list.currentRowChanged.connect(self._open)
        self._text.sourceChanged.connect(self._follow)
        self._lay_out()
        self._list.setCurrentRow(0)

    def _lay_out(self) -> None:
        aside, font = QWidget(), self.fontMetrics()
        aside.setFixedWidth(font.averageCharWidth() * _LIST_COLUMNS)
        filled(QVBoxLayout(aside), self._search, self._nothing, (self._list, 1), margins=0)
        line = filled(QHBoxLayout(), aside, (self._text, 1))
        for button in self.buttons.findChildren(QPushButton):
            button.setAutoDefault(False)  # Return goes on searching
        size = QSize(font.averageCharWidth() * _COLUMNS, font.lineSpacing() * _ROWS)
        self.fill((line, 1), size=size)

    def _open(self, row: int) -> None:
        url = QUrl.fromLocalFile(str(self._pages[row].file))
        if self._text.source() != url:  # else a link has led there
            self._text.setSource(url)

    def _follow(self, source: QUrl) -> None:
        names = [page.file.name for page in self._pages]
        if (name := source.fileName()) in names:
            self._list.setCurrentRow(names.index(name))
        self._mark()

    def _find(self, words: str) -> None:
        for row, page in enumerate(self._pages):
            self._list.item(row).setHidden(not page.holds(words))
        shown = self._listed()
        self._nothing.setText(tr("No page found: {words}").format(words=words))
        self._nothing.setVisible(not shown)
        if shown and self._list.currentRow() not in shown:
            self._list.setCurrentRow(shown[0])
        else:
            self._mark()

    def _listed(self) -> list[int]:
        return [row for row in range(self._list.count()) if not self._list.item(row).isHidden()]

    def _mark(self) -> None:
        self._places = sorted(self._found(), key=QTextCursor.position)
        marks = []
        for place in self._places:
            mark = QTextEdit.ExtraSelection()
            mark.cursor = place
            mark.format.setBackground(self.palette().highlight())
            mark.format.setForeground(self.palette().highlightedText())
            marks.append(mark)
        self._text.setExtraSelections(marks)
        if self._places:
            self._go_to(self._places[0])

    def _found(self) -> Iterator[QTextCursor]:
        document = self._text.document()
        for word in self._search.text().split():
            place = document.find(word)
            while not place.isNull():
                yield place
                place = document.find(word, place)

    def _find_next(self) -> None:
        at = self._text.textCursor().position()
        after = next((place for place in self._places if place.position() > at), None)
        if after is not None:
            self._go_to(after)
            return
        rows, here = self._listed(), self._list.currentRow()
        following = next((row for row in rows if row > here), rows[0] if rows else here)
        if following == here:
            self._mark()  # from the top again
        else:
            self._list.setCurrentRow(following)

    def _go_to(self, place: QTextCursor) -> None:
        cursor = QTextCursor(place)
        cursor.clearSelection()  # the mark is seen, not the selection above it
        self._text.setTextCursor(cursor)
        self._text.ensureCursorVisible()


TITLE = "Freeform Lens Workbench"
_SHOWN = "coach_marks_shown"


class Help(QObject):
    """Functions of the help menu."""

    def __init__(
        self, window: QMainWindow, commands: Commands, place: Callable[[str], QWidget]
    ) -> None:
        super().__init__(window)
        self._window, self._commands, self._place = window, commands, place
        self._marks: CoachMarks | None = None

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            "palette": self._search,
            "shortcuts": lambda: self._search(with_keys=True),
            "tour": self.show_marks,
            "manual": lambda: Manual(self._window).show(),
            "about": self._show_about,
        }

    def show_marks_once(self, settings: QSettings) -> None:
        if not settings.value(_SHOWN):
            settings.setValue(_SHOWN, True)
            self.show_marks()

    def show_marks(self) -> None:
        """Show what the parts of the window are for, in the workspace that has them all."""
        if self._marks is not None:
            return
        self._commands["workspace_task"].trigger()
        bar = self._commands.toolbar
        places = (
            self._place("design"),
            bar.widgetForAction(self._commands["start"]),
            self._place("irradiance"),
            self._window.menuBar().cornerWidget(),
        )
        self._marks = CoachMarks(self._window, places)
        self._marks.ended.connect(self._forget_marks)

    def _forget_marks(self) -> None:
        self._marks = None
        self._window.setFocus()

    def _search(self, *, with_keys: bool = False) -> None:
        entries = self._commands.entries()
        CommandPalette(entries, self._window, with_keys=with_keys).open()

    def _show_about(self) -> None:
        QMessageBox.about(
            self._window,
            tr("About {title}").format(title=TITLE),
            tr(
                "<h3>{title} {version}</h3><p>Designs freeform lenses and mirrors that form a "
                "given irradiance.</p><p>MIT licence</p>"
            ).format(title=TITLE, version=workbench.__version__),
        )
