"""The comparison of two runs: light of areas, lines of equal light, fields in words."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QWidget

from tests.accounts import result_of
from ui.run.comparison import RunComparison
from workbench.analysis.regions import light_of_areas
from workbench.design.session import KeptRun
from workbench.design.task import begin

DESK = {"name": "Desk", "size": [0.5, 0.5]}


@pytest.fixture
def compare(qtbot, make_scene, rng):
    """Compares two runs whose scenes have these changes, with noisy light; returns both."""
    window = QWidget()
    qtbot.addWidget(window)

    def do(one, other):
        runs = []
        for changes in (one, other):
            session = begin(make_scene(changes), Path())
            heights = np.full(session.scene.optic.net_shape, 0.5)
            light = session.target / session.target.sum() * (200 + 50 * rng.random((32, 32)))
            result = result_of(heights).with_state(irradiance=light)
            runs.append(KeptRun(f"run {len(runs)}", session.scene, session.target, result))
        shown = RunComparison(lambda run: "", window)
        shown.show_pair(tuple(runs))
        lines = [
            [shown.table.item(row, column) for column in range(3)]
            for row in range(shown.table.rowCount())
        ]
        return runs, [[item.text() if item else "" for item in line] for line in lines], shown

    return do


def test_light_of_the_lit_area_and_of_regions_is_stated_for_both(compare):
    even = {"target": {"builtin": "rectangle"}}
    runs, lines, shown = compare(even, even | {"regions": [DESK]})
    names = [line[0] for line in lines]
    lit, desk = names.index("Whole receiver"), names.index("Desk")
    areas = [light_of_areas(run.scene, run.target, run.result.state.irradiance) for run in runs]
    assert lines[lit + 5] == [
        "U₀ (minimum / average)",
        *(f"{light[0].uniformity:.3f}" for light in areas),
    ]
    assert lines[lit + 6][0] == "U₁ (minimum / maximum)"
    assert lines[desk + 5][1:] == ["–", f"{areas[1][1].uniformity:.3f}"]
    assert shown.table.item(desk, 0).font().bold() and not shown.table.item(0, 0).font().bold()
    assert shown._canvas.figure.axes[0].lines


def test_a_picture_has_neither_areas_nor_lines(compare):
    letter = {"target": {"builtin": "text", "text": "A"}}
    _, lines, shown = compare(letter, letter | {"run.seed": 3})
    assert lines[-1] == ["Run · Seed", "0", "3"]
    assert not any("U₀" in line[0] for line in lines)
    assert not shown._canvas.figure.axes[0].lines
