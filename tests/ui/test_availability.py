import pytest

from ui.commands.availability import Situation
from ui.commands.table import COMMANDS


def situation(
    state="idle", designed=True, has_lens=True, can_undo=True, can_redo=True, can_revert=True
):
    return Situation(state, designed, has_lens, can_undo, can_redo, can_revert)


def allowed(**what):
    return {name for name, allow in situation(**what).allows().items() if allow}


def test_every_name_is_a_command():
    assert situation().allows().keys() <= COMMANDS.keys()


def test_a_run_can_begin_only_when_there_is_none():
    for state in ("loading", "running", "paused", "stopping"):
        assert not {"start", "continue"} & allowed(state=state)
    assert {"start", "continue"} <= allowed()
    assert "continue" in allowed(designed=False)
    assert "continue" not in allowed(designed=False, has_lens=False)


@pytest.mark.parametrize("state", ["running", "paused", "stopping"])
def test_nothing_takes_the_design_away_from_a_run(state):
    assert not {"open", "save", "gallery", "revert", "undo", "redo"} & allowed(state=state)


def test_a_run_that_ends_already_cannot_be_held():
    assert {"pause", "stop"} <= allowed(state="paused")
    assert not {"pause", "stop"} & allowed(state="stopping")


def test_a_lens_that_changes_is_not_checked():
    assert [
        state
        for state in ("idle", "running", "paused", "stopping")
        if "check" in allowed(state=state)
    ] == ["idle", "paused"]


def test_export_needs_a_designed_lens():
    assert "export" in allowed(state="running")
    assert "export" not in allowed(designed=False)


def test_only_what_differs_from_its_file_goes_back_to_it():
    assert "revert" in allowed()
    assert "revert" not in allowed(can_revert=False)
