import pytest

from ui.commands.table import COMMANDS
from ui.window.window_state import Situation
from workbench.scene import Lens, Mirror, PlaneFace, SplineFace

FACE = SplineFace(control_points=(8, 8))
LENS = Lens(
    kind="lens",
    name="lens",
    half_width=(1.0, 1.0),
    material="PMMA",
    thickness=0.5,
    faces=(PlaneFace(), FACE),
)
TWO_FACES = LENS.with_face("lens.front", SplineFace())
MIRROR = Mirror(kind="mirror", name="mirror", half_width=(1.0, 1.0), face=FACE)


def situation(
    state="idle",
    has_lens=True,
    lens="a lens",
    can_undo=True,
    can_redo=True,
    can_revert=True,
    has_refused=False,
    following=False,
    optic=LENS,
):
    can = can_undo, can_redo, can_revert
    return Situation(optic, state, has_lens, lens, *can, has_refused, following)


def allowed(**what):
    return {name for name, allow in situation(**what).allows().items() if allow}


def test_every_name_is_a_command():
    assert situation().allows().keys() <= COMMANDS.keys()


def test_a_run_can_begin_only_when_there_is_none():
    for state in ("loading", "running", "paused", "stopping"):
        assert not {"start", "continue"} & allowed(state=state)
    assert {"start", "continue"} <= allowed()
    assert "continue" not in allowed(has_lens=False)
    assert "continue" in allowed(has_lens=False, following=True)


@pytest.mark.parametrize("state", ["running", "paused", "stopping"])
def test_commands_that_replace_the_design_are_disabled_during_a_run(state):
    changing = {"open", "new", "revert", "undo", "redo", "restore_run", "lock_all"}
    assert not changing & allowed(state=state)
    reasons = situation(state=state).reasons()
    assert all("Stop it first" in reasons[name] for name in changing)


@pytest.mark.parametrize("state", ["running", "paused", "stopping"])
def test_a_run_can_be_saved(state):
    assert {"save", "save_as"} <= COMMANDS.keys() - situation(state=state).allows().keys()


def test_a_run_that_is_stopping_cannot_be_paused():
    assert {"pause", "stop"} <= allowed(state="paused")
    assert not {"pause", "stop"} & allowed(state="stopping")


def test_a_lens_that_changes_is_not_checked():
    assert [
        state
        for state in ("idle", "running", "paused", "stopping")
        if "check" in allowed(state=state)
    ] == ["idle", "paused"]


def test_export_and_report_take_any_lens_and_say_which():
    for command in ("export", "report"):
        assert command in allowed(state="running", has_lens=False, lens="")
        assert command not in allowed(has_lens=False, lens="")
        assert situation().reasons()[command] == "Uses a lens"
        assert "best lens so far" in situation(state="running").reasons()[command]
        assert "no lens yet" in situation(has_lens=False, lens="").reasons()[command]


def test_undo_takes_a_refused_entry_back_also_during_a_run():
    assert "undo" not in allowed(can_undo=False)
    assert "undo" in allowed(can_undo=False, has_refused=True)
    assert "undo" in allowed(state="running", has_refused=True)
    assert situation(state="running", has_refused=True).reasons()["undo"] == ""


def test_revert_needs_unsaved_changes():
    assert "revert" in allowed()
    assert "revert" not in allowed(can_revert=False)


def test_the_entrance_face_is_switched_and_the_other_face_is_only_where_there_is_one():
    assert "second_face" in allowed() and "other_face" not in allowed()
    assert situation().texts()["second_face"] == "Freeform &entrance face"
    assert {"second_face", "other_face"} <= allowed(optic=TWO_FACES)
    assert situation(optic=TWO_FACES).texts()["second_face"] == "Flat &entrance face"
    assert not {"second_face", "other_face"} & allowed(optic=MIRROR)
    assert situation(optic=MIRROR).reasons()["second_face"] == "A mirror has one freeform face"


def test_reasons_say_what_the_optic_is_called():
    reasons = situation(optic=MIRROR, has_lens=False).reasons()
    assert reasons["continue"] == "There is no mirror yet; Start designs one"


def test_a_second_click_on_colours_of_faces_leads_back_to_the_material(window):
    commands = window.commands
    by_limits, material = commands["faces_by_limits"], commands["faces_material"]
    by_limits.setEnabled(True)
    by_limits.trigger()
    assert by_limits.isChecked() and not material.isChecked()
    by_limits.trigger()
    assert material.isChecked() and not by_limits.isChecked()
