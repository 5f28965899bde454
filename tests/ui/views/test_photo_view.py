"""The predicted photo: taken for eyes, of the lens that rests, saved with its exposure."""

import io

import numpy as np
import pytest
from PIL import Image
from PySide6.QtWidgets import QComboBox, QLabel, QSlider

from ui.background import close_threads
from ui.views.photo_view import PhotoView
from workbench.analysis.photo.light import LIGHTS
from workbench.analysis.photo.photo import photograph
from workbench.geometry.faces import FaceArrays

pytestmark = pytest.mark.usefixtures("kernels")


@pytest.fixture
def flat(frames):
    """Makes frames of plates, each a little thinner."""

    def make(iteration):
        plate = np.full((12, 10), 0.5 - 0.01 * iteration)
        return frames(iteration, heights=FaceArrays({"lens.back": plate}))

    return make


@pytest.fixture
def view(flat, show, qtbot):
    view = PhotoView()
    view.show_frame(flat(0))
    show(view, 500, 400)
    yield view
    close_threads(view)


def stated(view):
    labels = view.findChildren(QLabel)
    return next(each.text() for each in labels if each.accessibleName() == "State of the photo")


def seen(view):
    """The colour in the middle of what is painted."""
    image = view.grab().toImage()
    return image.pixelColor(image.width() // 2, image.height() // 3).getRgb()[:3]


def test_the_photo_is_that_of_the_engine_and_exposure_changes_it_at_once(view, qtbot):
    qtbot.waitUntil(lambda: view.photo is not None)
    assert stated(view) == (
        "Viewed from behind the screen; daylight (D65), no dispersion known, with cells."
    )
    frame = view._frame
    alone = photograph(frame.session.scene, frame.session.target, frame.state.heights)
    assert view.photo.rgb == pytest.approx(alone.rgb, rel=1e-9)
    for steps in (0, -6, 3):
        view.findChild(QSlider).setValue(steps)
        qtbot.waitUntil(lambda: seen(view) == tuple(alone.picture(view.stops)[16, 16]))
    assert view.stops == 1.0
    assert "+1 stops" in [label.text() for label in view.findChildren(QLabel)]


def test_another_light_and_another_lens_are_taken_anew(view, flat, qtbot):
    qtbot.waitUntil(lambda: view.photo is not None)
    lights = next(
        box for box in view.findChildren(QComboBox) if box.accessibleName() == "Light of the photo"
    )
    lights.setCurrentIndex(lights.findData("led"))
    assert view.photo is None
    qtbot.waitUntil(lambda: view.photo is not None)
    assert view.photo.light is LIGHTS["led"]
    view.show_frame(flat(1))
    assert view.photo is None
    assert stated(view).startswith("Outdated.")
    qtbot.waitUntil(lambda: view.photo is not None)


def test_the_photo_is_written_with_its_exposure_and_not_that_of_an_earlier_lens(view, flat, qtbot):
    assert view.empty
    qtbot.waitUntil(lambda: not view.empty)
    view.findChild(QSlider).setValue(-6)
    with io.BytesIO() as file:
        view.write(file, "png")
        written = np.asarray(Image.open(file))
    np.testing.assert_array_equal(written, view.photo.picture(view.stops))
    view.show_frame(flat(1))
    assert view.empty
