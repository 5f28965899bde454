"""All figures of a check in a dock: stated, explained, copied; and the choice of rays."""

import dataclasses

import pytest
from PySide6.QtGui import QAction

from tests.ui.hands import move_screen
from ui.run.check_figures import CheckFigures
from ui.run.checks import CheckedLens
from workbench.analysis.metrics import relative_l2
from workbench.analysis.validation import validate, validating
from workbench.analysis.validation_figures import MadeStep
from workbench.report.figures import account_rows, check_rows

pytestmark = pytest.mark.usefixtures("kernels")

RAYS = 20_000


@pytest.fixture
def found(designed):
    return validate(designed.scene, designed.target, designed.result.state.heights, RAYS)


@pytest.fixture
def figures(settings, qtbot):
    action = QAction("&Check lens")
    figures = CheckFigures(settings, action)
    figures.action = action
    qtbot.addWidget(figures)
    with qtbot.waitExposed(figures):
        figures.show()
    return figures


def named(rows):
    """As the table says it: each name begins with a capital."""
    return {name[:1].upper() + name[1:]: value for name, value in rows}


def rows(figures):
    return dict(line.split("\t") for line in figures.text.splitlines())


def test_all_figures_are_listed_and_explained(figures, designed, found):
    figures.show_check(CheckedLens(designed, designed.result.state.heights), found, 0.0321)
    assert rows(figures) == named(
        (*check_rows(found, 0.0321), *account_rows(found.account, designed.scene))
    )
    received = rows(figures)
    assert received["Error with ray noise"].startswith(f"{100 * found.relative_l2:.3f} % (")
    assert received["Difference to the optimiser"] == "3.210 %"
    assert received["On the screen"] == received["Efficiency"] == f"{100 * found.efficiency:.3f} %"
    table = figures._table
    for row, (name, value) in enumerate(received.items()):
        assert table.item(row, 0).text() == name.replace(" %", "\N{NO-BREAK SPACE}%")
        assert table.item(row, 1).text() == value.replace(" %", "\N{NO-BREAK SPACE}%")
    tips = [table.item(row, 0).toolTip() for row in range(table.rowCount())]
    assert len(set(tips)) == table.rowCount() == 18
    assert all(table.item(row, 1).toolTip() == tip for row, tip in enumerate(tips))


def test_errors_as_designed_and_after_each_process_come_first(figures, designed, found):
    steps = MadeStep("", 0.01, (0.009, 0.011), 0), MadeStep("Milling", 0.08, (0.07, 0.09), 0.07)
    lens = CheckedLens(designed, designed.result.state.heights)
    figures.show_check(lens, dataclasses.replace(found, steps=steps), 0.0)
    (first, as_designed), (second, milled), *_ = rows(figures).items()
    assert (first, second) == ("Error as designed", "Milling")
    assert as_designed == "1.000 % (0.900 % to 1.100 %)"
    assert milled.startswith("8.000 %, +7.000 percentage points by this process")


def test_the_choice_of_rays_is_kept(figures, settings, qtbot):
    assert figures.rays == 4_000_000
    with qtbot.waitSignal(figures.rays_chosen) as chosen:
        figures._rays.setCurrentIndex(figures._rays.findText("16 million rays"))
    assert chosen.args == [16_000_000] and figures.rays == 16_000_000
    again = CheckFigures(settings, figures.action)
    qtbot.addWidget(again)
    assert again.rays == 16_000_000
    settings.setValue("check/rays", 7)
    unknown = CheckFigures(settings, figures.action)
    qtbot.addWidget(unknown)
    assert unknown.rays == 4_000_000


@pytest.fixture
def window(display, open_window, designed, found, monkeypatch, qtbot):
    asked = []

    def few(scene, target, heights, rays, threads, accuracy):
        asked.append(rays)
        return validating(scene, target, heights, RAYS)

    monkeypatch.setattr("workbench.analysis.making.as_made.validating", few)
    window = open_window(designed)
    window.asked = asked
    window.build()
    qtbot.waitUntil(lambda: window.loaded.check._shown is not None, timeout=60_000)
    return window


def test_a_check_brings_the_dock_with_its_figures(window, found, qtbot):
    dock, figures = window.panes.docks["check"], window.loaded.figures
    assert not dock.isVisible()
    window.commands["check"].trigger()
    qtbot.waitUntil(lambda: figures.text != "", timeout=60_000)
    qtbot.waitUntil(lambda: not figures._table.visibleRegion().isEmpty())
    own = window.loaded.check._shown.snapshot.state.irradiance
    received = named(check_rows(found, relative_l2(found.irradiance, own)))
    assert received.items() <= rows(figures).items()
    assert figures._hint.isHidden()
    move_screen(window.document, 7)
    qtbot.waitUntil(lambda: not figures._table.isEnabled(), timeout=60_000)
    assert received.items() <= rows(figures).items()
