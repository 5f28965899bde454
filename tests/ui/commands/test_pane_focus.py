"""Every pane is reachable by keyboard, and the one with the focus is marked."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox, QLineEdit, QWidget

from tests.ui.hands import editor
from ui.commands.panes import WORKSPACES
from ui.commands.table import COMMANDS


def holds_focus(pane):
    focused = QApplication.focusWidget()
    return focused is not None and (pane is focused or pane.isAncestorOf(focused))


def test_commands_show_and_focus_every_dock(window, qtbot):
    for name, dock in window.panes.docks.items():
        if name == "scene":
            continue  # loads later, as the images do
        dock.hide()
        window.commands[f"go_{name}"].trigger()
        qtbot.waitUntil(lambda dock=dock: dock.seen)
        assert holds_focus(dock), name
        assert dock.property("active") is True


def test_keys_cycle_the_focus_through_all_visible_panes(window, qtbot):
    window.commands["workspace_design"].trigger()
    window.commands["go_design"].trigger()
    docks = window.panes.docks
    seen = {name for name, dock in docks.items() if dock.seen}
    visited = []
    for _ in range(len(seen) + 3):  # and the image, the strip and the toolbar
        visited += [name for name, dock in docks.items() if holds_focus(dock)]
        qtbot.keyClick(window, Qt.Key.Key_F6, Qt.KeyboardModifier.ControlModifier)
    assert sorted(visited) == sorted(seen) and len(seen) >= 3
    assert holds_focus(docks["design"])
    both = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(window, Qt.Key.Key_F6, both)
    assert holds_focus(window.commands.toolbar)


def test_a_pane_restores_the_focus_of_its_last_field(window, qtbot):
    field = editor(window.forms, "images[0].receiver.position[2]")
    field.setFocus()
    window.commands["go_log"].trigger()
    assert not field.hasFocus()
    window.commands["go_design"].trigger()
    assert field.hasFocus()


def test_nothing_on_the_window_is_without_a_name_for_screen_readers(window):
    nameless = [
        (widget, widget.parent())
        for kind in (QAbstractButton, QLineEdit, QComboBox)
        for widget in window.findChildren(kind)
        if widget.isVisibleTo(window) and not _name_of(widget)
    ]
    assert nameless == []


def _name_of(widget):
    return QAccessible.queryAccessibleInterface(widget).text(QAccessible.Text.Name)


def test_tab_goes_down_the_forms_row_by_row(window):
    forms = window.forms
    content = forms.widget()
    places, widget = [], content.nextInFocusChain()
    while widget is not content:
        takes = widget.focusPolicy() & Qt.FocusPolicy.TabFocus and widget.focusProxy() is None
        if takes and content.isAncestorOf(widget) and widget.isVisibleTo(content):
            middle = widget.mapTo(content, widget.rect().center())
            places.append((middle.y() // 4, middle.x()))  # rows are not exact to the pixel
        widget = widget.nextInFocusChain()
    assert len(places) > 20
    assert places == sorted(places)


def test_every_command_is_in_a_menu_and_with_it_in_the_palette(window):
    offered = {action for _, action in window.commands.entries()}
    missing = [name for name in COMMANDS if window.commands[name] not in offered]
    assert missing == []


def test_commands_look_at_lens_and_screen(display, window, qtbot):
    window.build()
    scene = window.loaded.views.scene
    qtbot.waitUntil(lambda: scene.camera() is not None, timeout=60_000)
    for name, keys in (("screen", "Ctrl+Alt+2"), ("lens", "Ctrl+Alt+1")):
        assert window.commands[f"{name}_view"].shortcut().toString() == keys
        window.commands[f"{name}_view"].trigger()
        assert scene.camera() == {"fitted": name}


def test_tab_reaches_all_that_is_seen_and_nothing_behind(display, window, qtbot):
    window.build()
    for workspace in WORKSPACES:
        window.commands[f"workspace_{workspace}"].trigger()
        qtbot.wait(300)
        check_tabs(window, qtbot)


def check_tabs(window, qtbot):
    reached = []
    while QApplication.focusWidget() not in reached:
        reached.append(QApplication.focusWidget())
        qtbot.keyClick(reached[-1] or window, Qt.Key.Key_Tab)
    assert not any(window.panes.covers(widget) for widget in reached if widget is not None)
    stops = [
        widget
        for widget in window.findChildren(QWidget)
        if widget.focusPolicy() & Qt.FocusPolicy.TabFocus
        and widget.isVisible()
        and widget.isEnabled()
        and widget.focusProxy() is None
        and widget.window() is window
        and not window.panes.covers(widget)
    ]
    assert {name_of(widget) for widget in stops} <= {name_of(each) for each in reached if each}


def name_of(widget):
    return f"{type(widget).__name__} {widget.accessibleName() or widget.objectName()}"


def test_no_button_has_the_keyboard_at_the_start(window):
    assert window.focusWidget() is window.pages.desk
    window.commands["new"].trigger()
    window.commands["workspace_check"].trigger()
    assert window.focusWidget() is window.pages.desk
