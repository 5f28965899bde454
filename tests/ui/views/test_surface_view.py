"""The map of the exit face."""

import io

import numpy as np
import pytest
from matplotlib.colors import to_hex
from PySide6.QtWidgets import QApplication

from ui.views.surface_view import SurfaceView
from ui.widgets import theme
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet


@pytest.fixture
def tilted(session, frames):
    """A frame whose face rises by so much per length along x."""

    def make(slope):
        x, y = ControlNet.of(session.scene.optic).positions
        return frames(1, heights=FaceArrays({"lens.back": 0.5 + slope * x[:, None] + 0 * y}))

    return make


@pytest.fixture
def view(tilted, show, qtbot):
    view = SurfaceView()
    view.show_frame(tilted(0.1))
    show(view, 500, 400)
    qtbot.waitUntil(lambda: not view.empty)
    return view


def test_view_follows_the_lens_and_shows_the_value_under_the_pointer(view, tilted, qtbot):
    view.chooser.setCurrentIndex(1)
    view.show_frame(tilted(1.0))
    qtbot.waitUntil(lambda: view._values is not None and np.allclose(view._values, 45))

    def reading():  # anew, should the layout still move
        qtbot.mouseMove(view._canvas, view._canvas.position_of(0.25, 0.5).toPoint())
        return view._readout.text()

    qtbot.waitUntil(lambda: reading().startswith("45° at x = 0.2"))


def test_a_lens_of_two_faces_lets_one_be_chosen(show, make_session, frames, qtbot):
    entrance = {"shape": "freeform", "height_range": [-0.1, 0.1]}
    session = make_session({"lens.entrance": entrance})
    x, y = ControlNet.of(session.scene.optic).positions
    heights = {"lens.back": np.full((12, 10), 0.5), "lens.front": 0.05 * x[:, None] + 0 * y}
    frame = frames(1, session, heights=FaceArrays(heights))
    view = SurfaceView()
    view.show_frame(frame)
    show(view, 500, 400)
    qtbot.waitUntil(lambda: not view.empty)
    names = [view.faces.itemText(number) for number in range(view.faces.count())]
    assert names == ["Entrance face", "Exit face"] and view.faces.isVisible()
    assert view.faces.face == "lens.back" and np.allclose(view._values, 0)
    view.faces.choose("lens.front")
    qtbot.waitUntil(lambda: view._values is not None and np.ptp(view._values) > 0.09)
    *_, written = view.data()
    assert written.name == "Entrance face: height [cm]"
    titles = []
    (axes,) = view._canvas.figure.axes
    view._canvas.figure.savefig = lambda *_, **__: titles.append(axes.get_title("left"))
    view.write(io.BytesIO(), "png")
    assert titles == ["Entrance face"]
    one = frames(1, heights=FaceArrays({"lens.back": np.full((12, 10), 0.5)}))
    view.show_frame(one)
    qtbot.waitUntil(lambda: not view.faces.isVisible())
    assert view.faces.face == "lens.back"
    assert view.data()[-1].name == "height [cm]"


def test_a_map_follows_a_change_of_the_theme(view, tilted, qtbot):
    application = QApplication.instance()
    for scheme in ("dark", "light"):
        theme.choose(application, scheme)
        ground = view.palette().window().color().name()
        assert to_hex(view._canvas.figure.get_facecolor()) == ground
    theme.choose(application, "system")
