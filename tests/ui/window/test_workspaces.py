"""Workspaces show what each part of the work needs, and the image of light largest."""

import pytest
from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtGui import QScreen
from PySide6.QtWidgets import QApplication, QInputDialog, QLabel, QMainWindow, QToolButton

from ui.commands.panes import PANES, WORKSPACES
from ui.commands.table import WORKSPACE_CHOICES
from ui.window.image_panel import ImagePanel
from workbench.scene.paths import with_values

pytestmark = pytest.mark.usefixtures("kernels")


def choose(window, name):
    window.commands[f"workspace_{name}"].trigger()


def shown(window):
    return {name for name, dock in window.panes.docks.items() if not dock.isHidden()}


def share(window):
    size = window.panes.images.size()
    return size.width() * size.height() / (window.width() * window.height())


@pytest.fixture
def sized(open_window, monkeypatch, qtbot):
    def make(*size):
        monkeypatch.setattr(QScreen, "availableSize", lambda _: QSize(*size))
        window = open_window()
        window.build()
        window.setWindowState(window.windowState().WindowNoState)
        window.resize(QSize(*size))
        qtbot.waitUntil(lambda: window.size() == QSize(*size))
        window.commands["reset_layout"].trigger()
        return window

    return make


def test_each_shows_its_docks_and_its_image(window):
    for name, wanted in WORKSPACES.items():
        choose(window, name)
        assert shown(window) == {dock for tabs in (*wanted.left, *wanted.right) for dock in tabs}
        assert window.panes.images.name == wanted.image
        assert [key for key in WORKSPACE_CHOICES if window.commands[key].isChecked()] == [
            f"workspace_{name}"
        ]


def test_docks_are_known_and_none_is_in_two_places():
    for workspace in WORKSPACES.values():
        placed = [name for tabs in (*workspace.left, *workspace.right) for name in tabs]
        assert len(placed) == len(set(placed))
        assert not any(PANES[name].image for name in placed) and PANES[workspace.image].image


def test_the_image_has_its_part_of_a_common_window(sized, qtbot):
    window = sized(1440, 900)
    for name, least in (("design", 0.3), ("check", 0.45)):
        choose(window, name)
        qtbot.waitUntil(lambda least=least: share(window) >= least)


def test_a_square_image_has_as_much_width_as_height(sized, qtbot):
    window = sized(1440, 900)
    choose(window, "check")
    panel = window.panes.images
    qtbot.waitUntil(lambda: abs(panel.width() - panel.height()) < 0.15 * panel.height())


def test_the_scene_stands_below_a_wide_image_and_beside_a_narrow_one(sized, qtbot):
    window = sized(1440, 900)
    choose(window, "design")
    scene, area = window.panes.docks["scene"], Qt.DockWidgetArea
    desk = window.pages.desk
    assert desk.dockWidgetArea(scene) == area.RightDockWidgetArea
    path = "images[0].receiver.half_width"
    wide = with_values(window.document.session.scene, {path: [2.0, 1.0]})
    window.document.edit(wide, "a wide screen", "")
    assert desk.dockWidgetArea(scene) == area.BottomDockWidgetArea
    result = window.panes.docks["result"]
    qtbot.waitUntil(lambda: share(window) >= 0.3 and scene.y() == result.y())
    assert result.x() >= scene.geometry().right()  # beside each other
    window.document.undo_stack.undo()
    assert desk.dockWidgetArea(scene) == area.RightDockWidgetArea


def test_what_a_hand_arranged_comes_back_and_reset_undoes_it(open_window):
    window = open_window()
    choose(window, "design")
    window.panes.docks["history"].show()
    window.panes.docks["light"].hide()
    arranged = shown(window)
    choose(window, "check")
    assert shown(window) != arranged
    choose(window, "design")
    assert shown(window) == arranged
    window.commands["reset_layout"].trigger()
    assert "history" not in shown(window) and "light" in shown(window)


def test_docks_have_title_bars_only_where_they_are_arranged_by_hand(open_window):
    window = open_window()
    choose(window, "design")
    assert window.panes.docks["design"].titleBarWidget() is not None
    choose(window, "custom")
    assert window.panes.docks["design"].titleBarWidget() is None
    assert not window.panes.docks["design"].isHidden()


def test_a_run_from_the_task_shows_the_design(display, window, qtbot):
    window.build()
    choose(window, "task")
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()
    assert window.workspaces.name == "design"


def test_a_check_goes_to_its_workspace_but_not_out_of_a_custom_one(display, window, qtbot):
    window.build()
    choose(window, "design")
    qtbot.waitUntil(lambda: window.loaded.check._shown is not None, timeout=60_000)
    for begin, end in (("design", "check"), ("custom", "custom")):
        choose(window, begin)
        with qtbot.waitSignal(window.loaded.check.checked, timeout=60_000):
            window.loaded.check.use_rays(100_000 if end == "check" else 200_000)
            window.commands["check"].trigger()
        assert window.workspaces.name == end
        assert "check" in shown(window)


def test_a_small_window_can_be_used(sized, display, qtbot):
    window = sized(960, 640)
    for name in WORKSPACES:
        choose(window, name)
        qtbot.wait(50)
        assert window.size() == QSize(960, 640)
        image = window.panes.images
        assert image.width() >= 300 and image.height() >= 300


def test_docks_give_way_to_the_image_when_the_window_shrinks(sized, display, qtbot):
    window = sized(1440, 900)
    for name in (*WORKSPACES, "custom"):
        window.resize(QSize(1440, 900))
        window.commands["reset_layout"].trigger()
        choose(window, name)
        qtbot.wait(50)
        window.resize(QSize(960, 640))
        qtbot.waitUntil(lambda: window.panes.images.width() >= 960 / 3)
        assert window.size() == QSize(960, 640)


def test_docks_keep_a_width_that_leaves_the_image_its_third(sized, qtbot):
    window = sized(1440, 900)
    choose(window, "design")
    qtbot.wait(50)
    before = {name: dock.width() for name, dock in window.panes.docks.items() if dock.seen}
    window.resize(QSize(1300, 900))
    qtbot.waitUntil(lambda: window.pages.desk.width() == 1300)
    qtbot.wait(50)
    assert before == {n: dock.width() for n, dock in window.panes.docks.items() if dock.seen}


def entries(menu):
    return [action.text() for action in menu.actions() if not action.isSeparator()]


@pytest.fixture
def answer(monkeypatch):
    """Answers the next questions for the name of a layout; None cancels."""

    def answer(name):
        given = ("", False) if name is None else (name, True)
        monkeypatch.setattr(QInputDialog, "getItem", lambda *_, **__: given)

    return answer


def test_a_layout_is_saved_under_a_name_and_chosen_later(open_window, answer):
    window = open_window()
    commands, menu = window.commands, window.commands.menus["Lay&outs"]
    choose(window, "custom")
    window.panes.docks["history"].show()
    arranged = shown(window)
    answer(" Wide & low ")
    commands["save_layout"].trigger()
    for name in ("history", "design"):
        window.panes.docks[name].hide()
    window.pages.show_start()
    other = open_window()
    assert entries(other.commands.menus["Lay&outs"])[2:] == ["Wide && low"]
    menu.actions()[-1].trigger()
    assert not window.pages.at_start and window.workspaces.name == "custom"
    assert shown(window) == arranged


def test_a_layout_is_replaced_or_deleted_by_its_name_and_not_by_cancelling(open_window, answer):
    window = open_window()
    commands, menu = window.commands, window.commands.menus["Lay&outs"]
    assert not commands["delete_layout"].isEnabled()
    for name in ("Beta", "Alpha", None, "Beta"):
        answer(name)
        commands["save_layout"].trigger()
    assert entries(menu)[2:] == ["Alpha", "Beta"]
    for name, left in ((None, ["Alpha", "Beta"]), ("Alpha", ["Beta"]), ("Beta", [])):
        answer(name)
        commands["delete_layout"].trigger()
        assert entries(menu)[2:] == left
    assert not commands["delete_layout"].isEnabled()


@pytest.fixture
def panel(qtbot):
    """A panel whose views are labels."""
    window = QMainWindow()
    panel = ImagePanel(QLabel())
    window.setCentralWidget(panel)
    panel.put({name: QLabel(name) for name in panel.names})
    window.resize(800, 600)
    qtbot.addWidget(window)
    window.show()
    yield panel
    window.close()


def visible(panel):
    return {label.text() for label in panel.findChildren(QLabel) if label.isVisible()} - {""}


def test_the_panel_shows_one_view_by_its_button(panel, qtbot):
    panel.choose("error")
    assert visible(panel) == {"error"} and panel.compared == ""


def view_at(panel, across):
    """The view that is seen at a part of the panel's width."""
    views = panel.findChild(QLabel).parentWidget()
    return views.childAt(QPoint(round(across * views.width()), views.height() // 2))


def buttons(panel):
    """Texts of the buttons that there is space for; the chosen one in capitals."""
    found = [b for b in panel.findChildren(QToolButton) if b.isVisible() and b.defaultAction()]
    found.sort(key=lambda button: button.x())
    return [b.text().upper() if b.isChecked() else b.text() for b in found]


def test_a_narrow_panel_shows_the_button_of_the_chosen_view(panel, qtbot):
    every = buttons(panel)
    assert every[0] == "IRRADIANCE" and every[-1] == "Through focus"
    panel.window().resize(360, 600)
    qtbot.waitUntil(lambda: len(buttons(panel)) < 4)
    few = buttons(panel)
    assert few == every[: len(few)]
    panel.choose("focus")
    qtbot.waitUntil(lambda: "THROUGH FOCUS" in buttons(panel))
    panel.choose("target")
    qtbot.waitUntil(lambda: "TARGET" in buttons(panel))
    panel.window().resize(800, 600)
    qtbot.waitUntil(lambda: len(buttons(panel)) == len(every))
    assert [text.lower() for text in buttons(panel)] == [text.lower() for text in every]


@pytest.mark.parametrize("name", ["irradiance", "surface", "focus"])
def test_no_width_hides_the_button_of_the_chosen_view(panel, name):
    panel.choose(name)
    for width in range(240, 800, 35):
        panel.window().resize(width, 600)
        QApplication.processEvents()
        assert any(text.isupper() for text in buttons(panel))


def test_a_handle_parts_two_views_and_moves_by_mouse_and_keys(panel, qtbot):
    panel.choose("irradiance")
    panel.compare_with("target")
    assert (panel.name, panel.compared) == ("irradiance", "target")
    (handle,) = (
        w
        for w in panel.findChildren(QLabel)[0].parentWidget().children()
        if w.objectName() == "handle"
    )
    for keys, place in ((0, 0.5), (4, 0.7)):
        for _ in range(keys):
            qtbot.keyClick(handle, Qt.Key.Key_Right)
        assert view_at(panel, place - 0.05).text() == "irradiance"
        assert view_at(panel, place + 0.05).text() == "target"
    middle = handle.rect().center()
    qtbot.mousePress(handle, Qt.MouseButton.LeftButton, pos=middle)
    qtbot.mouseMove(handle, middle - QPoint(400, 0))
    qtbot.mouseRelease(handle, Qt.MouseButton.LeftButton)
    assert view_at(panel, 0.4).text() == "target"


def test_views_that_are_compared_are_two(panel):
    panel.choose("target")
    panel.compare_with("target")
    assert panel.name != panel.compared == "target"
    panel.choose("photo")
    assert (panel.name, panel.compared) == ("photo", "target")


def test_a_pinned_image_is_offered_and_compared_with_until_it_is_removed(panel):
    buttons = panel._modes["pinned"], panel._seconds["pinned"]
    assert not any(button.isVisible() for button in buttons)
    panel.follow_pin(True)
    assert all(button.isVisible() for button in buttons)
    assert (panel.name, panel.compared) == ("irradiance", "pinned")
    assert panel._compare.text() == "Compare: Pinned"
    panel.choose("error")
    assert (panel.name, panel.compared) == ("error", "pinned")
    panel.follow_pin(False)
    assert (panel.name, panel.compared) == ("error", "")
    assert panel._compare.text() == "Compare"
    panel.compare_with("photo")
    panel.choose("pinned")
    panel.follow_pin(False)
    assert (panel.name, panel.compared) == ("irradiance", "photo")


def test_a_layout_of_an_earlier_program_is_left_out(open_window):
    window = open_window()
    choose(window, "check")
    before = shown(window)
    window._view_state.restore({"layout": "AAAA", "on": []})
    assert shown(window) == before and window.workspaces.name == "check"


def test_a_desk_that_the_start_page_hid_at_first_has_its_usual_shares(sized, settings, qtbot):
    window = sized(1440, 900)
    choose(window, "design")
    qtbot.wait(500)  # shared twice
    usual = window.panes.images.size()
    window.discard_and_close()
    settings.clear()
    late = sized(1440, 900)
    late.pages.show_start()
    late.workspaces.choose("design")
    qtbot.waitUntil(lambda: late.panes.images.size() == usual)
