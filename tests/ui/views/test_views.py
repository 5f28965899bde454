"""The views in a window: what they draw, when, and what they leave alone."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QPalette, QWheelEvent
from PySide6.QtWidgets import QApplication, QHBoxLayout, QMainWindow, QTabWidget, QWidget

from tests.accounts import account_of
from ui.views.canvas import PlotCanvas
from ui.views.drawing_queue import DrawingQueue, drawing_queue
from ui.views.error_view import ErrorView
from ui.views.irradiance_view import IrradianceView
from ui.views.light_view import LightView
from ui.views.loss_view import LossView
from ui.views.scene_view import SceneView
from workbench.files.session import Session
from workbench.geometry.faces import FaceArrays
from workbench.optics.account import LOSSES

PLOTS = [IrradianceView, ErrorView, LossView]


@pytest.fixture
def frame(session, frames):
    """A frame of some iteration with an uneven image of its own."""

    def make(iteration, of=session):
        n_x, n_y = of.scene.receiver.pixels
        return frames(
            iteration,
            of,
            irradiance=np.linspace(0, 0.1 * (1 + iteration), n_x * n_y).reshape(n_y, n_x),
            heights=FaceArrays({"exit": np.full(of.scene.optic.net_shape, 0.5)}),
        )

    return make


@pytest.fixture
def draws(monkeypatch):
    """Counts how often each view draws."""
    counts = {}
    for kind in (*PLOTS, LightView, SceneView):
        original = kind._draw

        def counted(self, *args, kind=kind, original=original):
            counts[kind] = counts.get(kind, 0) + 1
            original(self, *args)

        monkeypatch.setattr(kind, "_draw", counted)
    return counts


def dark_palette():
    palette = QPalette()
    palette.setColor(QPalette.ColorRole.Window, QColor("#202020"))
    palette.setColor(QPalette.ColorRole.WindowText, QColor("#f0f0f0"))
    return palette


def grabbed(widget):
    image = widget.grab().toImage()
    data = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return data[:, : 4 * image.width()].reshape(image.height(), image.width(), 4)[..., :3].copy()


@pytest.mark.parametrize("kind", PLOTS)
def test_plot_draws_the_latest_frame(kind, session, frame, draws, show, qtbot):
    view = kind()
    view.show_design(session)
    show(view, 380, 260)
    qtbot.waitUntil(lambda: draws.get(kind) == 1)
    empty = grabbed(view)
    for iteration in (1, 2, 3):
        view.show_frame(frame(iteration))
    qtbot.waitUntil(lambda: draws[kind] == 2)
    assert (grabbed(view) != empty).any()
    qtbot.wait(100)
    assert draws[kind] == 2  # three frames at once are one drawing


@pytest.mark.parametrize("kind", PLOTS)
def test_blitted_picture_is_the_drawn_picture(kind, session, frame, draws, show, qtbot):
    """Blitting leaves the same pixels as drawing everything anew."""
    view = show(kind(), 380, 260)
    for count, iteration in enumerate((3, 5), start=1):
        view.show_frame(frame(iteration))
        qtbot.waitUntil(lambda count=count: draws.get(kind) == count)
    blitted = grabbed(view)
    view._canvas.draw()
    np.testing.assert_array_equal(grabbed(view), blitted)


@pytest.mark.parametrize("kind", PLOTS)
def test_hidden_plot_draws_nothing_and_catches_up(kind, session, frame, draws, qtbot):
    tabs = QTabWidget()
    qtbot.addWidget(tabs)
    front, view = IrradianceView(), kind()
    tabs.addTab(front, "front")
    tabs.addTab(view, "behind")
    with qtbot.waitExposed(tabs):
        tabs.show()
    view.show_frame(frame(1))
    view.show_frame(frame(2))
    qtbot.wait(100)
    assert not draws
    tabs.setCurrentWidget(view)
    qtbot.waitUntil(lambda: draws == {kind: 1})
    assert view._frame.snapshot.iteration == 2


@pytest.mark.parametrize("kind", PLOTS)
def test_plot_follows_the_palette(kind, session, frame, draws, show, qtbot):
    view = kind()
    view.show_frame(frame(1))
    show(view, 380, 260)
    qtbot.waitUntil(lambda: draws.get(kind) == 1)
    light = grabbed(view)[2, 2].mean()
    view.setPalette(dark_palette())
    qtbot.waitUntil(lambda: draws[kind] == 2)
    dark = grabbed(view)
    assert dark[2, 2].mean() == 0x20 < light
    assert (dark.mean(axis=-1) > 200).any()  # ticks and labels are light


@pytest.mark.parametrize("kind", PLOTS)
@pytest.mark.parametrize("size", [(380, 260), (260, 180), (900, 500)])
def test_labels_lie_inside_at_any_size(kind, size, session, frame, draws, show, qtbot):
    view = kind()
    view.show_frame(frame(4))
    show(view, 380, 260)
    view.resize(*size)
    qtbot.waitUntil(lambda: draws.get(kind, 0) > 0)
    qtbot.wait(50)
    figure = view._canvas.figure
    tight = figure.get_tightbbox()
    width, height = figure.get_size_inches()
    assert tight.x0 > 0 and tight.y0 > 0
    assert tight.x1 < width and tight.y1 < height


def test_another_scene_gets_another_picture(session, frame, make_scene, draws, show, qtbot):
    view = IrradianceView()
    view.show_frame(frame(1))
    show(view, 380, 260)
    qtbot.waitUntil(lambda: draws.get(IrradianceView) == 1)
    wide = make_scene({"screen.half_width": [3.0, 1.0], "screen.pixels": [24, 8]})
    other = dataclasses.replace(session, scene=wide, target=np.ones((8, 24)))
    view.show_design(other)
    view.show_frame(frame(2, of=other))
    qtbot.waitUntil(lambda: draws[IrradianceView] == 2)
    assert view._canvas.figure.axes[0].get_xlim() == (-3, 3)


def test_one_view_draws_in_one_turn(qapp, qtbot):
    order = []

    class Slow:
        def __init__(self, name):
            self.name = name

        def draw_now(self):
            order.append(self.name)
            queue.ask(last)
            if len(order) > 3:
                queue.leave(last)

    queue = DrawingQueue(qapp)
    first, last = Slow("first"), Slow("last")
    queue.ask(first)
    queue.ask(last)
    queue.ask(first)
    assert order == []
    qtbot.waitUntil(lambda: len(order) == 4)
    assert order == ["first", "last", "last", "last"]
    queue.setParent(None)


def test_a_view_that_fails_does_not_keep_others_from_drawing(qapp, qtbot):
    drawn = []

    class Broken:
        def draw_now(self):
            raise ZeroDivisionError

    class Sound:
        def draw_now(self):
            drawn.append(self)

    queue, broken, sound = DrawingQueue(qapp), Broken(), Sound()
    with qtbot.captureExceptions() as raised:
        queue.ask(broken)
        queue.ask(sound)
        qtbot.waitUntil(lambda: drawn == [sound])
    assert [kind for kind, *_ in raised] == [ZeroDivisionError]
    queue.setParent(None)


def test_all_views_share_one_drawing_queue(qapp):
    assert drawing_queue() is drawing_queue()


def test_pictures_of_a_new_size_are_drawn_in_several_turns(frame, show, draws, qtbot, monkeypatch):
    window = QWidget()
    row = QHBoxLayout(window)
    views = [IrradianceView(), IrradianceView(), IrradianceView()]
    for view in views:
        row.addWidget(view)
        view.show_frame(frame(1))
    show(window, 900, 250)
    qtbot.waitUntil(lambda: draws.get(IrradianceView) == 3)
    qtbot.waitUntil(lambda: not any(view._canvas._stale for view in views))
    full, drawn = PlotCanvas.draw, []
    monkeypatch.setattr(PlotCanvas, "draw", lambda self: (drawn.append(self), full(self)))
    window.resize(1200, 300)
    seen = [grabbed(view) for view in views]  # which paints them
    assert len(drawn) == 1
    assert all(len(np.unique(each.reshape(-1, 3), axis=0)) > 100 for each in seen)
    qtbot.waitUntil(lambda: set(drawn) == {view._canvas for view in views})
    assert len(drawn) == 3


def test_a_picture_that_has_to_wait_for_its_turn_is_no_white_sheet(show, monkeypatch):
    monkeypatch.setattr(DrawingQueue, "may_draw", lambda self, drawer: False)
    holder = QWidget()
    holder.setPalette(dark_palette())
    canvas = PlotCanvas(holder, bar=False)
    show(holder, 300, 200)
    assert (grabbed(canvas) == 0x20).all()


# In three dimensions.


@pytest.fixture
def scene_view(display, qtbot):
    view = SceneView()
    window = QMainWindow()
    qtbot.addWidget(window, before_close_func=lambda _: view.close_plotter())
    window.setCentralWidget(view)
    window.resize(480, 320)
    yield view  # the window lives as long


@pytest.fixture
def drawn_scene(scene_view, frame, draws, qtbot):
    """The 3D scene of a frame, drawn once."""
    scene_view.show_frame(frame(1))
    scene_view.window().show()
    qtbot.waitUntil(lambda: draws.get(SceneView) == 1)
    return scene_view


def test_scene_is_made_when_first_seen(scene_view, session, frame, draws, qtbot):
    scene_view.show_design(session)
    scene_view.show_frame(frame(1))
    qtbot.wait(50)
    assert not draws and scene_view._plotter is None
    with qtbot.waitExposed(scene_view.window()):
        scene_view.window().show()
    qtbot.waitUntil(lambda: draws.get(SceneView) == 1)
    assert len(np.unique(grabbed(scene_view).reshape(-1, 3), axis=0)) > 100


def test_scene_is_updated_in_place(drawn_scene, session, frame, draws, qtbot):
    plotter = drawn_scene._plotter
    plotter.camera.azimuth = 15
    camera, actors = plotter.camera_position, list(plotter.actors)
    before = grabbed(drawn_scene)
    drawn_scene.show_frame(frame(9))
    qtbot.waitUntil(lambda: draws[SceneView] == 2)
    assert plotter.camera_position == camera
    assert list(plotter.actors) == actors
    assert (grabbed(drawn_scene) != before).any()
    drawn_scene.fit()
    assert plotter.camera_position != camera


def test_camera_moves_only_with_the_lens_and_screen(
    drawn_scene, session, frame, make_scene, draws, qtbot
):
    plotter = drawn_scene._plotter
    plotter.camera.azimuth = 15
    camera = plotter.camera_position
    denser = dataclasses.replace(session, scene=make_scene({"lens.control_points": [20, 20]}))
    drawn_scene.show_frame(frame(0, of=denser))
    qtbot.waitUntil(lambda: draws[SceneView] == 2)
    assert plotter.camera_position == camera
    farther = dataclasses.replace(session, scene=make_scene({"screen.z": 9.0}))
    drawn_scene.show_frame(frame(0, of=farther))
    qtbot.waitUntil(lambda: draws[SceneView] == 3)
    assert plotter.camera_position != camera


def test_untouched_scene_stays_fitted_on_resize(drawn_scene, qtbot):
    scale = drawn_scene._plotter.camera.parallel_scale
    drawn_scene.window().resize(300, 500)
    qtbot.waitUntil(lambda: drawn_scene._plotter.camera.parallel_scale > scale)


@pytest.mark.parametrize("perspective", [False, True])
def test_the_wheel_zooms_to_what_is_under_the_pointer(drawn_scene, session, perspective):
    drawn_scene.see_in_perspective(perspective)
    plotter, sight = drawn_scene._plotter, drawn_scene.sight
    corner = np.array([[0.9, 0.8, session.scene.receiver.z]])  # of the screen
    near = corner + np.array([0.01, 0.0, 0.0])
    (x, y), there = sight.pixels(np.concatenate([corner, near]))
    for angle in (120, 240, -120, 360):
        event = QWheelEvent(
            QPointF(x, plotter.height() - 1 - y),
            QPointF(),
            QPoint(),
            QPoint(0, angle),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(plotter, event)
        np.testing.assert_allclose(sight.pixels(corner), [[x, y]], atol=0.2)
    grown = np.linalg.norm(sight.pixels(near) - [x, y]) / np.linalg.norm(there - [x, y])
    assert grown == pytest.approx(1.2**5, rel=0.1)


def test_hidden_scene_draws_nothing_and_catches_up(drawn_scene, frame, draws, qtbot):
    drawn_scene.hide()
    drawn_scene.show_frame(frame(2))
    qtbot.wait(100)
    assert draws[SceneView] == 1
    drawn_scene.show()
    qtbot.waitUntil(lambda: draws[SceneView] == 2)


def test_scene_follows_the_palette(drawn_scene, draws, qtbot):
    light = grabbed(drawn_scene)[5, 5].mean()
    drawn_scene.setPalette(dark_palette())
    qtbot.waitUntil(lambda: draws[SceneView] == 2)
    assert grabbed(drawn_scene)[5, 5].mean() < light / 2


def test_closed_scene_stays_closed(drawn_scene, frame, qtbot):
    drawn_scene.close_plotter()
    drawn_scene.close_plotter()
    drawn_scene.show_frame(frame(2))
    drawn_scene.fit()
    qtbot.wait(50)
    assert drawn_scene._plotter is None


def test_the_light_account_adds_up(frame, show, qtbot):
    view = show(LightView(), 380, 260)
    account = account_of(2.0, 1.0, 0.5, 0.1, 0.06, 0.0, 0.3, 0.04)
    one = frame(1)
    view.show_frame(
        dataclasses.replace(
            one,
            snapshot=dataclasses.replace(
                one.snapshot, state=dataclasses.replace(one.snapshot.state, account=account)
            ),
        )
    )
    qtbot.waitUntil(lambda: view.texts()["All parts"] == "100.00 %")
    assert view.texts() == {
        "On the screen": "50.00 %",
        "Missed the screen": "25.00 %",
        "Missed the lens": "5.00 %",
        "Out of the side": "3.00 %",
        "Totally reflected": "0.00 %",
        "Reflected on entry": "15.00 %",
        "Absorbed": "0.00 %",
        "Reflected on exit": "2.00 %",
        "All parts": "100.00 %",
    }


def test_every_loss_has_a_row_in_the_light_account(qtbot):
    view = LightView()
    qtbot.addWidget(view)
    assert list(view._rows) == ["on_screen", *LOSSES]


def test_a_hidden_light_account_does_nothing(frame, draws, qtbot):
    view = LightView()
    qtbot.addWidget(view)
    view.show_frame(frame(1))
    qtbot.wait(50)
    assert LightView not in draws
    view.show()
    qtbot.waitUntil(lambda: draws.get(LightView) == 1)
    assert view.texts()["On the screen"] == "92.00 %"


@pytest.mark.parametrize("kind", PLOTS)
def test_a_design_without_a_frame_is_not_shown_as_the_one_before(kind, session, frame, show, qtbot):
    view = kind()
    view.show_design(session)
    show(view, 380, 260)
    qtbot.waitUntil(lambda: view._shown is session)
    assert view.empty and view._hint.text()
    empty = grabbed(view._canvas)
    view.show_frame(frame(3))
    qtbot.waitUntil(lambda: not view.empty)
    assert not view._hint.text() and (grabbed(view._canvas) != empty).any()
    view.show_nothing(session)
    qtbot.waitUntil(lambda: view.empty)
    view._hint.setText("")
    blank = grabbed(view._canvas)
    assert (blank == blank[-1, -1]).mean() > 0.98  # all but a button in a corner


@pytest.mark.parametrize("kind", [IrradianceView, ErrorView])
@pytest.mark.parametrize("largest", [1e-6, 0.02, 12345.0])
@pytest.mark.parametrize("size", [(250, 200), (500, 700)])
def test_labels_of_a_bar_lie_inside_whatever_its_numbers(
    kind, largest, size, make_scene, frames, show, qtbot
):
    scene = make_scene({"screen.half_width": [1 / largest**0.5] * 2, "screen.z": 100.0})
    wide = Session(scene, np.eye(32) + 0.5)
    view = kind()
    view.show_frame(frames(1, wide, irradiance=largest * np.eye(32)))
    show(view, *size)
    qtbot.waitUntil(lambda: not view.empty)
    figure = view._canvas.figure
    assert figure.get_tightbbox().x1 < figure.get_size_inches()[0]


def test_a_light_account_of_nothing_is_empty(session, frame, show, qtbot):
    view = show(LightView(), 380, 260)
    view.show_frame(frame(1))
    qtbot.waitUntil(lambda: view.texts()["On the screen"] != "")
    view.show_nothing(session)
    qtbot.waitUntil(lambda: set(view.texts().values()) == {""})


def test_the_3d_scene_of_nothing_has_a_dark_screen(display, session, frame, qtbot):
    window, view = QMainWindow(), SceneView()
    qtbot.addWidget(window)
    window.setCentralWidget(view)
    view.show_frame(frame(3))
    with qtbot.waitExposed(window):
        window.show()
    qtbot.waitUntil(lambda: view._contents.picture is not None)
    lit = view._contents.picture
    assert lit._receivers[0]._texels.point_data["colour"].max() > 100
    view.show_nothing(session)
    qtbot.waitUntil(lambda: view._contents.picture is not lit)
    assert view._contents.picture._receivers[0]._texels.point_data["colour"].max() < 10
    view.close_plotter()


def lines_of(view):
    picture = view._contents.picture
    return picture._rays.n_lines if picture._light.visibility else 0


def test_the_number_of_rays_is_adjustable_without_another_frame(display, frame, draws, show, qtbot):
    view = show(SceneView(), 300, 200)
    view.show_frame(frame(1))
    qtbot.waitUntil(lambda: draws.get(SceneView) == 1, timeout=20_000)
    assert lines_of(view) == 225
    middle = view._frame.paths.points[45 * 45 // 2]
    for count, rays in enumerate((45, 5, 0, 15), start=2):
        view.show_rays(rays)
        qtbot.waitUntil(lambda count=count: draws[SceneView] == count, timeout=20_000)
        assert lines_of(view) == rays**2
        ends = np.asarray(view._contents.picture._rays.points).reshape(-1, 4, 3)[:, 3]
        assert not rays or np.isclose(ends, middle[3]).all(axis=1).any()
    view.close_plotter()


def test_exploded_distances_bring_the_screen_nearer_and_back(
    display, session, frame, draws, show, qtbot
):
    scene = session.scene
    far = scene.with_receiver(
        scene.receiver.model_copy(update={"z": 90.0, "half_width": (40.0, 40.0)})
    )
    view = show(SceneView(), 300, 200)
    view.show_frame(frame(1, dataclasses.replace(session, scene=far)))
    qtbot.waitUntil(lambda: draws.get(SceneView) == 1, timeout=20_000)
    camera = view._plotter.camera
    to_scale = camera.parallel_scale
    view.explode(True)
    qtbot.waitUntil(lambda: draws[SceneView] == 2, timeout=20_000)
    assert camera.parallel_scale < to_scale / 5
    view.explode(False)
    qtbot.waitUntil(lambda: draws[SceneView] == 3, timeout=20_000)
    assert camera.parallel_scale == pytest.approx(to_scale)
    view.close_plotter()


def test_the_light_account_of_a_far_field_is_called_so(make_scene, session, show, qtbot):
    far = {"half_angle": [20.0, 10.0], "pixels": [32, 32]}
    scene = make_scene({"screen": None, "far_field": far})
    view = show(LightView(), 380, 260)
    view.show_design(dataclasses.replace(session, scene=scene, result=None))
    qtbot.waitUntil(lambda: "In the far field" in view.texts())
    assert "Missed the far field" in view.texts()
    view.show_nothing(session)
    qtbot.waitUntil(lambda: "On the screen" in view.texts())
