"""Compared runs, and the bound in the status bar."""

import re

import numpy as np
import pytest
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QComboBox, QWidget

from tests.accounts import account_of
from tests.scene.test_images import SECOND
from ui.run.bound import BoundOfDesign
from ui.run.comparison import RunComparison
from workbench.design.lens_state import FurtherLight
from workbench.design.session import KeptRun
from workbench.design.task import begin

GRID = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.3, 0.3], "points": [50, 50]}


@pytest.fixture
def said():
    return []


@pytest.fixture
def bound(document, said, qapp):
    parent = QObject()
    bound = BoundOfDesign(document, parent)
    bound.figures_changed.connect(lambda *words: said.append(words))
    bound.follow(document.session)
    yield bound
    bound.close()


def test_bound_of_an_edited_source_is_said(bound, said, document, make_scene, qtbot):
    assert said == [("", "")]
    document.edit(make_scene({"source": GRID}), "source", "")
    qtbot.waitUntil(lambda: said[-1] != ("", ""), timeout=30_000)
    short, sentence = said[-1]
    assert sentence.startswith("There can be no lens of this size below ")
    least, allowed = (float(part) for part in re.findall(r"([\d.]+) %", sentence))
    assert "with a source half as wide" in sentence and 0 < allowed < least
    assert short == f"at best {least:g} %"
    document.undo_stack.undo()
    assert said[-1] == ("", "")


@pytest.fixture
def kept(make_scene, history, tmp_path):
    """Makes runs of a scene with some fields changed, with this much light in a second image."""

    def make(name, light=None, changes=None):
        further = {} if light is None else {"further_images": [SECOND]}
        session = begin(make_scene({**further, **(changes or {})}), tmp_path)
        result = history(3).result()
        if light is not None:
            account = account_of(1.0, light, 0.96 - light, 0.0, 0.0, 0.0, 0.04, 0.0)
            second = FurtherLight(np.full((32, 24), light), 0.1, account)
            result = result.with_state(further=(second,))
        return KeptRun(name, session.scene, session.target, result)

    return make


@pytest.fixture
def comparison(show, qtbot):
    window = QWidget()
    show(window, 1000, 700)
    shown = RunComparison(lambda run: f"of {run.name}", window)
    shown.show()
    yield shown
    shown.close()
    window.close()


def choice(comparison):
    return comparison.findChild(QComboBox)


def choose(comparison, number):
    choice(comparison).setCurrentIndex(number)
    choice(comparison).activated.emit(number)


def figures(comparison, name):
    """Both values of a line of the table."""
    table = comparison.table
    row = next(row for row in range(table.rowCount()) if table.item(row, 0).text() == name)
    return [table.item(row, column).text() for column in (1, 2)]


def test_pictures_and_figures_are_of_the_image_that_is_chosen(comparison, kept):
    comparison.show_pair((kept("dim", 0.3), kept("bright", 0.5)))
    titles = [choice(comparison).itemText(k) for k in range(choice(comparison).count())]
    assert choice(comparison).isVisible()
    assert titles == ["Image 1, z = 5 cm", "Image 2, z = 6 cm"]
    assert figures(comparison, "On screen") == ["92.0 %", "92.0 %"]
    assert figures(comparison, "Verified") == ["of dim", "of bright"]
    choose(comparison, 1)
    one, other, difference = (a.images[0].get_array() for a in comparison._figure.axes[:3])
    assert one.shape == (32, 24) and (one == 0.3).all() and (other == 0.5).all()
    np.testing.assert_allclose(difference, 0.2)
    assert figures(comparison, "Target") == ["Ball", "Ball"]
    assert figures(comparison, "On screen") == ["30.0 %", "50.0 %"]
    assert figures(comparison, "Verified") == ["–", "–"]  # a check is of the first image
    choose(comparison, 0)
    assert comparison._figure.axes[0].images[0].get_array().shape == (32, 32)
    assert figures(comparison, "On screen") == ["92.0 %", "92.0 %"]
