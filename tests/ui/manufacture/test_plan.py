"""Plans of a shop in the window."""

import pytest

from ui.manufacture.plan import PlanDialog

pytestmark = pytest.mark.usefixtures("few_plans")


@pytest.fixture
def chosen():
    return []


@pytest.fixture
def dialog(designed, qtbot, window, chosen):
    found = PlanDialog(designed, chosen.append, window)
    qtbot.addWidget(found)
    found.show()
    yield found
    found.reject()


def searched(qtbot, dialog):
    qtbot.waitUntil(lambda: not dialog.background.busy, timeout=60_000)


def test_the_cheapest_plan_becomes_the_processes_of_the_scene(dialog, qtbot, chosen):
    dialog.fields.enter(error=95.0)
    dialog.search()
    assert not dialog.use.isEnabled()
    searched(qtbot, dialog)
    assert "wanted as made 95.00 %; ball radius " in dialog.state.text()
    dialog.use.click()
    (edit,) = chosen
    (first, *_) = edit.changes["processes"]
    assert first["kind"] == "milling"


def test_what_cannot_be_reached_is_said(dialog, qtbot):
    dialog.fields.enter(error=0.001)
    dialog.search()
    searched(qtbot, dialog)
    assert "is not reached by milling and polishing" in dialog.state.text()
    assert not dialog.use.isEnabled()
