"""Views of a scene of several images show the one that is chosen."""

import numpy as np
import pytest
from PySide6.QtWidgets import QVBoxLayout, QWidget

from tests.accounts import account_of
from tests.scene.test_images import SECOND
from ui.views.choices import ImageChoice
from ui.views.light_images import ErrorView, IrradianceView, TargetView
from ui.views.light_view import LightView
from ui.views.section_view import SectionView
from ui.views.shared_view import SharedView
from workbench.design.lens_state import FurtherLight
from workbench.design.task import begin
from workbench.pictures.images import shown_error, target_irradiance


@pytest.fixture
def frame(make_scene, frames, tmp_path):
    """Light of a scene of two images."""
    session = begin(make_scene({"further_images": [SECOND]}), tmp_path)
    elsewhere = np.arange(32.0 * 24).reshape(32, 24) / 1000
    further = (FurtherLight(elsewhere, 0.1, account_of(1.0, 0.3, 0.62, 0.0, 0.0, 0.0, 0.04, 0.04)),)
    return frames(1, session, further=further)


@pytest.fixture
def views(show):
    link, window = SharedView(), QWidget()
    views = [view(link) for view in (IrradianceView, TargetView, ErrorView, SectionView, LightView)]
    column = QVBoxLayout(window)
    for view in views:
        column.addWidget(view)
    show(window, 700, 1400)
    yield views  # the window lives as long


def choice(view):
    return view.findChild(ImageChoice)


def test_all_views_show_the_image_that_is_chosen_in_one(views, frame, qtbot):
    for view in views:
        view.show_frame(frame)
    lit, wanted, off, section, light = views
    qtbot.waitUntil(lambda: all(view._values is not None for view in views[:3]))
    np.testing.assert_array_equal(lit._values, 4 * frame.state.irradiance)  # of 4 cm²
    chooser = choice(lit)
    assert [chooser.itemText(k) for k in (0, 1)] == ["Image 1, z = 5 cm", "Image 2, z = 6 cm"]
    chooser.setCurrentIndex(1)
    chooser.activated.emit(1)
    qtbot.waitUntil(lambda: all(view._values.shape == (32, 24) for view in views[:3]))
    scene, target, _ = frame.session.scene.wanted(frame.session.target)[1]
    elsewhere = frame.state.further[0].irradiance
    np.testing.assert_array_equal(lit._values, 6 * elsewhere)  # of 6 cm²
    flux = scene.receiver.total(elsewhere)
    wanted_light = target_irradiance(scene, target, flux)
    np.testing.assert_array_equal(wanted._values, 6 * wanted_light)
    np.testing.assert_array_equal(off._values, shown_error(scene, target, elsewhere))
    qtbot.waitUntil(lambda: section._shown.scene.receiver == scene.receiver)
    qtbot.waitUntil(lambda: light.texts()["On the screen"] == "30.00 %")
    assert all(choice(view).currentIndex() == 1 for view in (lit, wanted, off, light))
