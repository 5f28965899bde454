"""Plots are copied and saved, whichever was clicked or reached last."""

import csv
from xml.etree import ElementTree

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QHBoxLayout, QWidget

from ui.background import close_threads
from ui.document.document import Document
from ui.files.dialogs import FileDialogs
from ui.files.plots import Plots
from ui.views.light_images import IrradianceView
from ui.views.loss_strip import LossStrip
from ui.views.surface_view import SurfaceView
from ui.widgets.messages import Messages


@pytest.fixture
def frame(frames):
    return frames(3, irradiance=np.arange(1024.0).reshape(32, 32) / 1000)


@pytest.fixture
def views(frame, show, qtbot):
    window = QWidget()
    views = {"irradiance": IrradianceView(), "loss": LossStrip(), "surface": SurfaceView()}
    row = QHBoxLayout(window)
    for view in views.values():
        row.addWidget(view)
        view.show_frame(frame)
    show(window, 1000, 300)
    window.activateWindow()
    qtbot.waitUntil(lambda: not any(view.empty for view in views.values()))
    yield views  # the window lives as long


@pytest.fixture
def plots(views, session, settings, qtbot):
    messages = Messages()
    qtbot.addWidget(messages)
    window = next(iter(views.values())).window()
    document = Document(session, "lens", window)
    dialogs = FileDialogs(document, messages, settings, window)
    plots = Plots(views, dialogs)
    yield plots
    close_threads(plots)


def test_the_picture_of_the_plot_that_was_clicked_is_copied(plots, views, qtbot):
    canvas = views["surface"]._canvas
    qtbot.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=QPoint(5, 5))
    plots.copy()
    image = QGuiApplication.clipboard().image()
    assert image.width() > 1.5 * canvas.width()  # sharper than on the screen
    assert image.pixelColor(1, 1).name() == "#ffffff"  # on paper, whatever the theme
    assert "surface" in plots._messages.text
    qtbot.mouseClick(views["loss"].curve, Qt.MouseButton.LeftButton)
    plots.copy()
    assert QGuiApplication.clipboard().image().pixelColor(1, 1).name() == "#ffffff"
    assert "loss" in plots._messages.text


def test_pictures_are_saved(plots, tmp_path):
    plots.save("irradiance", tmp_path / "light.png")
    assert QImage(str(tmp_path / "light.png")).width() > 300
    plots.save("loss", tmp_path / "loss.SVG")
    assert ElementTree.parse(tmp_path / "loss.SVG").getroot().tag.endswith("svg")


def test_numbers_are_saved(plots, views, frame, tmp_path, qtbot):
    with qtbot.waitSignal(plots.background.done):
        plots.save("irradiance", tmp_path / "light.csv")
    with open(tmp_path / "light.csv", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    assert header == ["x [cm]", "y [cm]", "irradiance [x mean]"]
    values = np.array(rows, dtype=float)[:, 2]
    np.testing.assert_allclose(
        values.mean(),
        frame.state.irradiance.mean()
        * frame.session.scene.receiver.total(np.ones_like(frame.state.irradiance)),
    )


def test_a_file_that_cannot_be_written_is_reported(plots, tmp_path):
    folder = tmp_path / "plots"
    folder.mkdir()
    plots.save("loss", folder / "missing" / "loss.png")
    assert "missing" in plots._messages.text
    plots.save("loss", folder / "loss.bmp")
    assert plots._messages.text == "loss.bmp: a plot is saved as one of .png, .svg, .csv"
    assert list(folder.iterdir()) == []
