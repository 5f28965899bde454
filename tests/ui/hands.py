"""What hands do at the forms and dialogs of a window."""

from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QWidget

from resources import EXAMPLES


def rows(forms):
    """All rows of all panels."""
    return [row for panel in forms.panels for row in panel.rows]


def unfold(forms, wanted):
    """Unfold what holds rows, as a person does who looks for them."""
    for each in filter(wanted, rows(forms)):
        forms.reveal(each)


def row(forms, path, visible=True):
    """The row at a path; it can be seen, unless that does not matter."""
    if visible:
        unfold(forms, lambda row: row.path == path)
    first = max((each for each in rows(forms) if each.path == path), key=QWidget.isVisible)
    assert first.isVisible() or not visible, f"{path} is hidden"
    return first


def editor(forms, path):
    """The field at a path, of its row: ``elements[0].half_width[0]``."""
    return field_row(forms, path).editors[path]


def field_row(forms, path):
    """The row of the field at a path; it can be seen."""
    unfold(forms, lambda row: path in getattr(row, "editors", {}))
    having = [each for each in rows(forms) if path in getattr(each, "editors", {})]
    first = max(having, key=QWidget.isVisible)
    assert first.isVisible(), f"{path} is hidden"
    return first


def fill(qtbot, field, text, key=Qt.Key.Key_Return):
    """Type into a field instead of what it holds; gives the field."""
    field.setFocus()
    field.selectAll()
    qtbot.keyClick(field, Qt.Key.Key_Delete)
    qtbot.keyClicks(field, text)
    if key is not None:
        qtbot.keyClick(field, key)
    return field


def enter(qtbot, forms, path, text, key=Qt.Key.Key_Return):
    """Fill in the field at a path."""
    return fill(qtbot, editor(forms, path), text, key)


def choose(forms, path, value):
    """Choose from the list at a path."""
    chooser = row(forms, path).chooser
    chooser.setCurrentIndex(chooser.findData(value))
    chooser.activated.emit(chooser.currentIndex())


def move_screen(document, z, text="change of receiver position", key=""):
    """One step of the design, of this text and key."""
    scene = document.session.scene
    document.edit(scene.with_receiver(scene.receiver.moved_to(float(z))), text, key)


def drop(window, path):
    """Drop a file onto a window."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    window.dropEvent(QDropEvent(QPointF(9, 9), Qt.DropAction.CopyAction, data, left, none))


def open_example(window, name):
    """Choose an example on the start page."""
    window.commands["new"].trigger()
    row = [example.name for example in EXAMPLES].index(name)
    window.start_page.examples.chosen.emit(row)
