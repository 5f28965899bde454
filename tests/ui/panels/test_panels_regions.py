"""Regions in the form: listed, added, edited, of another shape, refused, undone."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QToolButton

from tests.ui.hands import choose, enter, fill, row
from ui.document.document import Document
from ui.panels.images import RegionsPanel
from workbench.scene import PolygonRegion


@pytest.fixture
def document(make_session):
    return Document(make_session(), "observed")


@pytest.fixture
def forms(document, open_forms):
    opened = open_forms(document)
    document.setParent(opened)
    return opened


def regions(document):
    return document.session.scene.regions


def add(qtbot, forms):
    buttons = forms.findChild(RegionsPanel).findChildren(QToolButton)
    button = next(each for each in buttons if each.text() == "Add")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def listed(forms):
    found = forms.findChild(RegionsPanel).findChild(QListWidget)
    return [found.item(at).text() for at in range(found.count())]


def test_a_region_is_added_named_and_resized(document, forms, qtbot):
    add(qtbot, forms)
    fill(qtbot, row(forms, "regions[0].name").editor, "Desk")
    enter(qtbot, forms, "regions[0].size[0]", "0.25")
    (desk,) = regions(document)
    assert (desk.name, desk.size) == ("Desk", (0.25, 0.5))
    assert listed(forms) == ["1.  Desk: rectangle, 0.5 × 1 cm"]
    for _ in range(3):
        document.undo_stack.undo()
    assert not regions(document)
    assert listed(forms) == []


def test_corners_of_a_polygon_are_typed_as_one_line(document, forms, qtbot):
    add(qtbot, forms)
    choose(forms, "regions[0].shape", "polygon")
    corners = "-0.5, -0.5; 0.5,-0.5; 0, 0.25; -0.2, 0.2"
    fill(qtbot, row(forms, "regions[0].corners").editor, corners)
    (region,) = regions(document)
    assert isinstance(region, PolygonRegion)
    assert region.corners == ((-0.5, -0.5), (0.5, -0.5), (0.0, 0.25), (-0.2, 0.2))
