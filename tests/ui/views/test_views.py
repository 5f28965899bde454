"""The views in a window: what they draw, when, and what they leave alone."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QPalette, QWheelEvent
from PySide6.QtWidgets import QApplication, QMainWindow, QTabWidget

from tests.accounts import account_of
from ui.views.error_view import ErrorView
from ui.views.irradiance_view import IrradianceView
from ui.views.light_view import LightView
from ui.views.loss_view import LossView
from ui.views.scene_view import SceneView
from workbench.geometry.faces import FaceArrays

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
