"""Checks from the window: figures beside the loss, until another lens is shown."""

from threading import Semaphore
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.accounts import account_of
from tests.ui.hands import move_screen
from ui.run.checks import verified_error
from workbench.analysis.by_cells import RandomShare
from workbench.analysis.metrics import Quality
from workbench.analysis.validation import validating
from workbench.analysis.validation_figures import Validation
from workbench.errors import RunFailed
from workbench.progress import finished

pytestmark = pytest.mark.usefixtures("kernels")

RAYS = 20_000
STEPS = 4


@pytest.fixture
def few_rays(monkeypatch):
    """Real checks, with fewer rays."""
    monkeypatch.setattr(
        "workbench.analysis.making.as_made.validating",
        lambda scene, target, heights, rays, threads, accuracy: validating(
            scene, target, heights, RAYS
        ),
    )


@pytest.fixture
def window(display, open_window, designed, qtbot):
    window = open_window(designed)
    window.build()
    qtbot.waitUntil(lambda: window.loaded.check._shown is not None, timeout=60_000)
    return window


def parts(window):
    """Of the checks under way, as the shelf shows them."""
    return [task.part for task in window.early.shelf.running if task.title == "Check"]


def is_verified(window):
    card = window.loaded.cards.cards.get("error")
    return card is not None and " verified error" in card.text


def test_the_verified_error_stands_on_a_card(window, few_rays, qtbot):
    window.commands["check"].trigger()
    assert parts(window) == [None]
    qtbot.waitUntil(lambda: is_verified(window), timeout=60_000)
    session = window.document.session
    steps = validating(session.scene, session.target, session.result.state.heights, RAYS)
    found = finished(steps)
    error = verified_error(found)
    assert f"{error} verified error" in window.loaded.cards.cards["error"].text
    assert parts(window) == [] and window.early.shelf.entries == []  # nothing was written
    log = window.log.toPlainText()
    assert f"relative L2 error {error}" in log
    assert f"{100 * found.relative_l2:.2f} ± {100 * found.noise:.2f} %" in log
    assert f"{100 * found.efficiency:.1f} % on the screen" in log


def test_an_error_below_the_scatter_of_the_rays_is_shown_as_a_bound():
    found = SimpleNamespace(
        relative_l2_corrected=0.004, relative_l2_corrected_interval=(0.0, 0.0123)
    )
    assert verified_error(found) == "< 1.23 %"
    found.relative_l2_corrected_interval = (0.001, 0.0123)
    assert verified_error(found) == "0.40 %"


def test_the_check_of_a_run_fills_the_table_and_is_not_done_again(
    window, few_rays, as_seen_run, qtbot
):
    window.commands["workspace_design"].trigger()
    window.loaded.control.runner._generate = as_seen_run(window.loaded.control.runner, 3)
    with qtbot.waitSignal(window.loaded.control.ended, timeout=60_000):
        window.commands["start"].trigger()
    figures, check = window.loaded.figures, window.loaded.check
    qtbot.waitUntil(lambda: figures.text != "", timeout=60_000)
    qtbot.waitUntil(lambda: is_verified(window))
    assert window.workspaces.name == "design"
    window.commands["check"].trigger()
    assert window.workspaces.name == "check" and not check.background.busy
    move_screen(window.document, 7)
    qtbot.waitUntil(lambda: "Outdated" in figures._hint.text(), timeout=60_000)


def test_figures_go_when_the_lens_changes(window, few_rays, qtbot):
    window.commands["check"].trigger()
    qtbot.waitUntil(lambda: is_verified(window), timeout=60_000)
    scene, stack = window.document.session.scene, window.document.undo_stack
    run = scene.run.model_copy(update={"iterations": 17})
    window.document.edit(scene.model_copy(update={"run": run}), "run", "")
    qtbot.waitUntil(lambda: window.loaded.check._shown.session.scene.run.iterations == 17)
    assert is_verified(window)  # it is the same lens
    move_screen(window.document, 7)
    qtbot.waitUntil(lambda: not is_verified(window), timeout=60_000)
    assert stack.count() == 2


def test_the_command_again_cancels_the_check(window, gate, qtbot):
    check = window.commands["check"]
    check.trigger()
    assert check.text() == "Cancel &check"
    gate.release(1)
    qtbot.waitUntil(lambda: parts(window) == [0.25])
    check.trigger()
    assert parts(window) == [] and check.text() == "&Check lens"
    gate.release(1)  # the step that it was in
    qtbot.waitUntil(lambda: not window.loaded.check.background.running)
    assert len(gate.left) == 1
    assert "Check with" not in window.log.toPlainText()
    check.trigger()
    gate.release(STEPS)
    qtbot.waitUntil(lambda: is_verified(window))
    assert len(gate.begun) == 2 and len(gate.left) == 1


def test_escape_cancels_the_check_where_no_tool_needs_the_key(window, gate, qtbot):
    scene = window.loaded.views.scene
    qtbot.waitUntil(lambda: scene._plotter is not None, timeout=30_000)
    window.commands["lock"].trigger()
    window.commands["check"].trigger()
    qtbot.keyClick(scene._plotter, Qt.Key.Key_Escape)
    assert window.commands["turn"].isChecked()
    assert len(parts(window)) == 1
    qtbot.waitUntil(lambda: len(gate.begun) == 1)
    qtbot.keyClick(scene._plotter, Qt.Key.Key_Escape)
    assert parts(window) == [] and window.commands["check"].text() == "&Check lens"
    gate.release(1)  # the step that it was in
    qtbot.waitUntil(lambda: not window.loaded.check.background.running)
    assert len(gate.left) == 1


def test_a_check_that_fails_shows_the_reason(window, monkeypatch, qtbot):
    def dark(*lens, threads, accuracy):
        raise RunFailed("no light of this lens reaches the screen")

    monkeypatch.setattr("workbench.analysis.making.as_made.validating", dark)
    window.commands["check"].trigger()
    qtbot.waitUntil(lambda: "no light" in window.messages.text, timeout=60_000)
    assert parts(window) == [] and "no light" in window.early.shelf.entries[0].outcome.text()
    monkeypatch.setattr("workbench.analysis.making.as_made.validating", lambda *_, **named: 1 / 0)
    window.commands["check"].trigger()
    qtbot.waitUntil(lambda: "ZeroDivisionError" in window.messages.text, timeout=60_000)


def test_closing_the_window_ends_a_check(window, gate, qtbot):
    check = window.loaded.check
    window.commands["check"].trigger()
    qtbot.waitUntil(lambda: len(gate.begun) == 1)
    gate.release(1)
    # The next step ends after the check has been asked to end.
    check.background.changed.connect(lambda task: task.ended and gate.release())
    window.discard_and_close()
    assert not check.background.running
    assert gate.left == gate.begun


@pytest.fixture
def gate(session, monkeypatch):
    """Checks of some steps that wait until they are let; notes scenes begun, and left half-way."""
    allowed, begun, left = Semaphore(0), [], []
    found = Validation(
        loss=0.1,
        relative_l2=0.5,
        relative_l2_interval=(0.4, 0.6),
        relative_l2_corrected=0.4,
        relative_l2_corrected_interval=(0.3, 0.5),
        efficiency=0.9,
        account=account_of(1.0, 0.9, 0.02, 0.0, 0.0, 0.0, 0.04, 0.04),
        quality=Quality(None, 0.8, 0.7, 0.6, None),
        rays=16,
        noise=0.001,
        irradiance=np.ones_like(session.target),
        image_noise=0.01,
        share=RandomShare(0.9, 0.001, 16),
    )

    def steps(scene, target, heights, rays, threads, accuracy):
        begun.append(scene)
        try:
            for step in range(STEPS):
                assert allowed.acquire(timeout=30)
                yield (step + 1) / STEPS
        except GeneratorExit:
            left.append(scene)
            raise
        return found

    monkeypatch.setattr("workbench.analysis.making.as_made.validating", steps)
    yield SimpleNamespace(release=allowed.release, begun=begun, left=left)
    allowed.release(100)


def test_the_most_light_stands_beside_the_light_and_follows_edits(window, monkeypatch, qtbot):
    monkeypatch.setattr("ui.run.checks._REST_MS", 0)
    cards = window.loaded.cards

    def possible():
        light = cards.cards.get("light")
        return light is not None and ", of at most 92.2 %;" in light.text

    window.loaded.bound.follow(window.document.session)
    qtbot.waitUntil(possible, timeout=60_000)  # two bare faces
    assert "92.2 % passes the faces at best" in cards.toolTip()
    move_screen(window.document, 6.0)
    assert cards.toolTip() == ""
    qtbot.waitUntil(lambda: possible() and cards.toolTip() != "", timeout=60_000)
