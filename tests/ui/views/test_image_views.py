"""Images of the screen: zoomed and moved together, read under the pointer, cut along lines."""

import dataclasses
import math

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication, QHBoxLayout, QWidget

from ui.views.error_view import ErrorView
from ui.views.image_link import ImageLink
from ui.views.irradiance_view import IrradianceView
from ui.views.section_view import SectionView
from ui.views.target_view import TargetView
from workbench.pictures.images import shown_error, target_irradiance


@pytest.fixture
def frame(frames):
    return frames(1, irradiance=np.arange(1024.0).reshape(32, 32) / 1000)


@pytest.fixture
def views(frame, show, qtbot):
    """Irradiance, target and error beside each other, drawn."""
    link, window = ImageLink(), QWidget()
    views = [IrradianceView(link), TargetView(link), ErrorView(link)]
    row = QHBoxLayout(window)
    for view in views:
        row.addWidget(view)
        view.show_frame(frame)
    show(window, 1200, 380)
    qtbot.waitUntil(lambda: all(view._values is not None for view in views))
    yield views


@pytest.fixture
def section(views, frame, show, qtbot):
    """A cross-section of the same light, drawn."""
    section = SectionView(views[0]._link)
    section.show_frame(frame)
    show(section, 400, 260)
    qtbot.waitUntil(lambda: section._shown is not None)
    return section


def place(view, x, y):
    """Where a place on the screen is in the canvas."""
    i, j = view._axes.transData.transform((x, y)) / view._canvas.device_pixel_ratio
    return QPoint(round(i), round(view._canvas.height() - j))


def drag(view, qtbot, start, end, modifier=Qt.KeyboardModifier.NoModifier):
    canvas = view._canvas
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, modifier, place(view, *start))
    qtbot.mouseMove(canvas, place(view, *end))
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, modifier, place(view, *end))


def turn_wheel(view, x, y, steps):
    at = QPointF(place(view, x, y))
    event = QWheelEvent(
        at,
        view._canvas.mapToGlobal(at),
        QPoint(),
        QPoint(0, 120 * steps),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(view._canvas, event)


def limits(view):
    return (*view._axes.get_xlim(), *view._axes.get_ylim())


def test_all_zoom_about_the_pointer(views, qtbot):
    turn_wheel(views[0], 0.5, -0.25, 3)
    qtbot.waitUntil(lambda: all(limits(view) != (-1, 1, -1, 1) for view in views))
    scale = 1.25**-3
    wanted = (0.5 - 1.5 * scale, 0.5 + 0.5 * scale, -0.25 - 0.75 * scale, -0.25 + 1.25 * scale)
    for view in views:  # the pointer is on a whole pixel of the window
        np.testing.assert_allclose(limits(view), wanted, atol=0.01)
    turn_wheel(views[2], 0.5, -0.25, -9)
    qtbot.waitUntil(lambda: all(limits(view) == (-1, 1, -1, 1) for view in views))


def test_dragging_moves_all_no_farther_than_the_screen(views, qtbot):
    views[0]._link.show_part((-0.5, 0.5, -0.5, 0.5))
    qtbot.waitUntil(lambda: limits(views[1]) == (-0.5, 0.5, -0.5, 0.5))
    canvas, start = views[1]._canvas, place(views[1], 0, 0)
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    end = place(views[1], 0.25, 0)
    qtbot.mouseMove(canvas, end)
    qtbot.waitUntil(lambda: limits(views[0])[0] < -0.7)
    np.testing.assert_allclose(limits(views[0]), (-0.75, 0.25, -0.5, 0.5), atol=0.01)
    qtbot.mouseMove(canvas, end + QPoint(2000, 0))
    qtbot.waitUntil(lambda: limits(views[2])[0] == -1)
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=end)
    qtbot.mouseDClick(canvas, Qt.MouseButton.LeftButton, pos=start)
    qtbot.waitUntil(lambda: all(limits(view) == (-1, 1, -1, 1) for view in views))


def test_all_show_their_value_under_the_pointer(views, frame, session, qtbot):
    x, y = 0.40625, -0.65625  # the middle of row 26, column 22
    qtbot.mouseMove(views[1]._canvas, place(views[1], x, y))
    image, scene = frame.state.irradiance, session.scene
    wanted = [
        image[26, 22],
        target_irradiance(scene, session.target, scene.receiver.total(image))[26, 22],
        shown_error(scene, session.target, image)[26, 22],
    ]
    for view, value in zip(views, wanted, strict=True):
        assert view._readout.text().startswith(f"{value:.4g} / cm² at x = 0.4")
    qtbot.mouseMove(views[1]._canvas, QPoint(2, 2))
    assert {view._readout.text() for view in views} == {"Viewed from behind the screen"}


def test_values_are_those_under_a_pointer_at_rest_after_keys_have_moved_the_images(views, qtbot):
    view, x, y = views[1], 0.40625, -0.65625
    qtbot.mouseMove(view._canvas, place(view, x, y))
    before = [view._readout.text() for view in views]
    for keys in ((Qt.Key.Key_Plus, Qt.Key.Key_Plus), (Qt.Key.Key_Left,), (Qt.Key.Key_Home,)):
        seen = limits(view)
        for key in keys:
            qtbot.keyClick(view._canvas, key)
        qtbot.waitUntil(lambda seen=seen: all(limits(view) != seen for view in views))
        place_now = view._place_at(*view._pointer)
        assert view._pointed == pytest.approx(place_now)
        after = [view._readout.text() for view in views]
        for each in views:
            each._point(place_now)
        assert after == [view._readout.text() for view in views]
        assert (after == before) == (keys == (Qt.Key.Key_Home,))
    qtbot.mouseMove(view._canvas, QPoint(2, 2))
    qtbot.keyClick(view._canvas, Qt.Key.Key_Plus)
    qtbot.waitUntil(lambda: limits(view) != (-1, 1, -1, 1))
    assert {view._readout.text() for view in views} == {"Viewed from behind the screen"}


def test_the_middle_of_an_image_is_at_0_whatever_the_pixel_of_the_pointer(views):
    views[0]._point((1e-17, -3e-5))
    assert views[0]._readout.text().endswith("at x = 0 cm, y = 0 cm")


def test_value_and_place_under_the_pointer_are_said_in_short_where_there_is_little_room(views):
    view = views[0]
    view._point((0.4, 0.2))
    for width, words in ((400, "at x ="), (150, "(0.4"), (90, " / cm²"), (400, "at x =")):
        view._readout.resize(width, view._readout.height())
        text = view._readout.text()
        assert words in text
        assert view._readout.fontMetrics().horizontalAdvance(text) <= width


def test_light_has_a_logarithmic_scale(views, qtbot):
    qtbot.mouseClick(views[0]._logarithmic, Qt.MouseButton.LeftButton)
    light, target, error = (view._content.image.artists[0] for view in views)
    qtbot.waitUntil(lambda: views[1]._logarithmic.isChecked())
    for image in (light, target):
        assert image.norm.vmax / image.norm.vmin == pytest.approx(1000)
        assert image.norm(image.norm.vmax / 10) == pytest.approx(2 / 3)
    assert error.norm.vmin == -error.norm.vmax
    qtbot.mouseClick(views[1]._logarithmic, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not views[0]._logarithmic.isChecked())
    assert light.norm.vmin == 0 and light.norm(light.norm.vmax / 2) == 0.5


def test_the_target_is_drawn_once_for_a_run_that_loses_as_much_light(views, frame, frames):
    target = views[1]
    target.show_frame(frames(2, irradiance=frame.state.irradiance[::-1]))
    assert not target._to_draw


def test_the_target_has_as_much_light_as_arrives(views, frame, frames, qtbot):
    light, target = (view._content.image.artists[0] for view in views[:2])
    total = frame.session.scene.receiver.total
    assert total(target.get_array()) == pytest.approx(total(light.get_array()))
    for view in views[:2]:
        view.show_frame(frames(2, irradiance=frame.state.irradiance / 8))
    qtbot.waitUntil(lambda: not views[1]._to_draw)
    assert total(target.get_array()) == pytest.approx(total(frame.state.irradiance) / 8)
    qtbot.waitUntil(lambda: light.get_clim() == target.get_clim())


def test_a_cross_section_goes_through_the_place_that_is_clicked(
    views, section, frame, session, qtbot
):
    image = frame.state.irradiance
    light = lambda: section._curves.artists[1].get_ydata()  # noqa: E731
    np.testing.assert_array_equal(light(), image[16])
    qtbot.mouseClick(
        views[2]._canvas, Qt.MouseButton.LeftButton, pos=place(views[2], 0.40625, -0.65625)
    )
    qtbot.waitUntil(lambda: len(light()) and np.array_equal(light(), image[26]))
    assert " at y = -0.6" in section._curves._axes.get_xlabel()
    section._direction.actions()[1].trigger()
    qtbot.waitUntil(lambda: np.array_equal(light(), image[::-1, 22]))
    wanted = section._curves.artists[0].get_ydata()
    assert wanted.max() == pytest.approx(
        image.mean() * 4 * target_irradiance(session.scene, session.target)[:, 22].max()
    )
    qtbot.waitUntil(lambda: views[1]._marks[0].get_visible())
    section.hide()
    qtbot.waitUntil(lambda: not views[1]._marks[0].get_visible())


@pytest.mark.parametrize("with_tool", [False, True])
def test_a_cross_section_follows_a_line_that_is_drawn(views, section, qtbot, with_tool):
    link, modifier = views[0]._link, Qt.KeyboardModifier.ShiftModifier
    if with_tool:
        qtbot.mouseClick(views[0]._line_tool, Qt.MouseButton.LeftButton)
        qtbot.waitUntil(lambda: views[2]._line_tool.isChecked())
        modifier = Qt.KeyboardModifier.NoModifier
    drag(views[2], qtbot, (-0.5, 0.5), (0.5, -0.25), modifier)
    assert section._direction.checkedAction().text() == "Along a line"
    qtbot.waitUntil(lambda: section._curves._axes.get_xlim()[1] == pytest.approx(1.25, abs=0.02))
    (x_0, y_0), (x_1, y_1) = link.line
    np.testing.assert_allclose((x_0, y_0, x_1, y_1), (-0.5, 0.5, 0.5, -0.25), atol=0.01)
    # A slanted plane stays a straight line.
    light = section._curves.artists[1].get_ydata()
    np.testing.assert_allclose(np.diff(light), np.diff(light).mean(), rtol=1e-6)
    for view in views:  # what is seen has not moved
        assert limits(view) == (-1, 1, -1, 1)
        qtbot.waitUntil(lambda view=view: view._marks[2].get_visible())
        assert not view._marks[0].get_visible()
    section._direction.actions()[0].trigger()
    qtbot.waitUntil(lambda: views[1]._marks[0].get_visible())
    assert link.line is None
    section.hide()
    assert link.pin is None


def test_arrows_move_place_and_line(views, section, frame, qtbot):
    link, shift = views[0]._link, Qt.KeyboardModifier.ShiftModifier
    canvas, pixel, image = section.focusProxy(), 2 / 32, frame.state.irradiance
    light = lambda: section._curves.artists[1].get_ydata()  # noqa: E731
    qtbot.keyClick(canvas, Qt.Key.Key_Down)
    qtbot.keyClick(canvas, Qt.Key.Key_Left, shift)
    assert link.pin == pytest.approx((-10 * pixel, -pixel))
    qtbot.waitUntil(lambda: np.array_equal(light(), image[17]))
    for _ in range(3):
        qtbot.keyClick(canvas, Qt.Key.Key_Left, shift)
    assert link.pin == pytest.approx((-1.0, -pixel))  # the edge of the screen
    section._direction.actions()[2].trigger()
    assert link.line == ((-1.0, -1.0), (1.0, 1.0))
    ctrl = Qt.KeyboardModifier.ControlModifier
    qtbot.keyClick(canvas, Qt.Key.Key_Down, ctrl | shift)
    qtbot.keyClick(canvas, Qt.Key.Key_Left, ctrl)
    start, end = link.line
    assert start == (-1.0, -1.0) and end == pytest.approx((1 - pixel, 1 - 10 * pixel))
    qtbot.keyClick(canvas, Qt.Key.Key_Right, shift)  # as far as there is room
    qtbot.keyClick(canvas, Qt.Key.Key_Up)
    start, end = link.line
    assert start == pytest.approx((-1 + pixel, -1 + pixel))
    assert end == pytest.approx((1.0, 1 - 9 * pixel))
    qtbot.waitUntil(lambda: not section._to_draw and not views[1]._to_draw)
    np.testing.assert_allclose(views[1]._marks[2].get_xydata(), link.line)
    assert section._curves._axes.get_xlim()[1] == pytest.approx(math.hypot(31, 22) * pixel)


def test_a_line_keeps_a_length(views, section, qtbot):
    link, ctrl = views[0]._link, Qt.KeyboardModifier.ControlModifier
    link.drawn.emit(((0.0, 0.0), (2 / 32, 0.0)))
    qtbot.keyClick(section.focusProxy(), Qt.Key.Key_Left, ctrl)
    assert link.line == ((0.0, 0.0), (2 / 32, 0.0))
    qtbot.keyClick(section.focusProxy(), Qt.Key.Key_Up, ctrl)
    assert link.line == ((0.0, 0.0), (2 / 32, 2 / 32))


def test_a_line_drawn_for_a_hidden_section_is_its_when_it_is_shown(views, qtbot):
    section = SectionView(views[0]._link)
    qtbot.addWidget(section)
    with qtbot.waitSignal(views[0]._link.drawn):
        drag(views[0], qtbot, (-0.5, 0), (0.5, 0), Qt.KeyboardModifier.ShiftModifier)
    assert section._along == "line" and section._line[1][0] == pytest.approx(0.5, abs=0.01)


def test_images_are_zoomed_moved_and_pinned_by_keys(views, qtbot):
    canvas, link = views[1]._canvas, views[1]._link
    canvas.setFocus()
    qtbot.keyClick(canvas, Qt.Key.Key_Plus, Qt.KeyboardModifier.ShiftModifier)
    assert link.part == pytest.approx((-0.8, 0.8, -0.8, 0.8))
    qtbot.keyClick(canvas, Qt.Key.Key_Right)
    qtbot.keyClick(canvas, Qt.Key.Key_Down)
    assert link.part == pytest.approx((-0.64, 0.96, -0.96, 0.64))
    with qtbot.waitSignal(link.pinned) as pinned:
        qtbot.keyClick(canvas, Qt.Key.Key_Return)
    assert pinned.args[0] == pytest.approx((0.16, -0.16))
    qtbot.keyClick(canvas, Qt.Key.Key_Minus)
    qtbot.keyClick(canvas, Qt.Key.Key_Home)
    assert link.part is None


def test_light_has_one_choice_of_colours(views, qtbot):
    views[0]._link.set_colours("cividis")
    light, target, error = (view._content.image.artists[0] for view in views)
    qtbot.waitUntil(lambda: light.get_cmap().name == target.get_cmap().name == "cividis")
    assert error.get_cmap().name == "RdBu_r"


def test_another_screen_is_seen_whole(views, make_scene, session, frames, qtbot):
    views[0]._link.show_part((0, 0.5, 0, 0.5))
    qtbot.waitUntil(lambda: limits(views[0]) == (0, 0.5, 0, 0.5))
    wide = make_scene({"screen.half_width": [3.0, 1.0], "screen.pixels": [24, 8]})
    other = dataclasses.replace(session, scene=wide, target=np.ones((8, 24)))
    for view in views:
        view.show_frame(frames(1, other, irradiance=np.ones((8, 24))))
    qtbot.waitUntil(lambda: all(limits(view) == (-3, 3, -1, 1) for view in views))


def test_a_narrow_image_has_the_unit_of_its_light_above(frame, show, qtbot):
    view = IrradianceView()  # alone: a layout would give it its own width again
    view.show_frame(frame)
    show(view, 300, 300)
    qtbot.waitUntil(lambda: view._values is not None)
    title = lambda: view._canvas.figure.axes[0].get_title(loc="right")  # noqa: E731
    for width, above in ((300, "flux / cm²"), (700, ""), (300, "flux / cm²")):
        view.resize(width, 300)
        qtbot.waitUntil(lambda above=above: title() == above)


def test_an_image_at_rest_says_from_which_side_it_is_drawn(frame, make_session, show, qtbot):
    target = {"builtin": "tophat", "viewed_from": "front"}
    session = make_session({"target": target})
    view = IrradianceView()
    view.show_frame(dataclasses.replace(frame, session=session))
    show(view, 420, 380)
    qtbot.waitUntil(lambda: view._values is not None)
    view._point(None)
    view._readout.resize(400, view._readout.height())
    assert view._readout.text() == "Viewed from behind the screen: mirror-inverted"
    view._readout.resize(230, view._readout.height())
    assert view._readout.text() == "Viewed from behind the screen"
    view._readout.resize(40, view._readout.height())
    assert view._readout.text() == ""
