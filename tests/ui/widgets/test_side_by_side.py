"""A picture and what belongs to it share the room."""

import pytest
from PySide6.QtWidgets import QLabel, QPushButton, QVBoxLayout, QWidget

from ui.widgets.side_by_side import SideBySide


@pytest.fixture
def figures():
    figures = QWidget()
    column = QVBoxLayout(figures)
    figures.labels = [QLabel(text) for text in ("one", "two")]
    for label in figures.labels:
        column.addWidget(label)
    return figures


def test_the_picture_has_all_room_that_figures_leave_also_when_they_change(figures, show, qtbot):
    picture, button = QWidget(), QPushButton("go")
    beside = show(SideBySide(picture, figures, [button]), 300, 500)

    row = button.sizeHint().height() + 8  # with its margins

    def taken():
        return beside.height() - picture.height() - row

    qtbot.waitUntil(lambda: taken() == figures.sizeHint().height() > 0)
    whole = taken()
    figures.labels[1].hide()
    qtbot.waitUntil(lambda: taken() == figures.sizeHint().height() < whole)
    figures.labels[1].show()
    qtbot.waitUntil(lambda: taken() == whole)
