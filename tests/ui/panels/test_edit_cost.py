"""What an edit costs: the scene is written out and validated once, whatever it holds."""

from collections import Counter

import pytest

from tests.ui.hands import enter
from ui.document.frame import make_frame
from workbench.scene import Scene

GRID = {"kind": "grid", "center": [0, 0, -5], "half_width": [0.2, 0.2], "points": [3, 3]}
STAGES = [{"iterations": 3, "source": GRID}, {"iterations": 2, "control_points": [6, 6]}]


@pytest.fixture(params=["plain", "staged"])
def session(request, make_session):
    stages = STAGES if request.param == "staged" else []
    return make_session({"run": {"iterations": 10, "stages": stages}})


@pytest.fixture
def counted(monkeypatch):
    """How often scenes are written out, and validated."""
    calls = Counter()

    def count(name, function):
        def counting(*arguments, **options):
            calls[name] += 1
            return function(*arguments, **options)

        return counting

    for name in ("model_dump", "model_dump_json"):
        monkeypatch.setattr(Scene, name, count("written", getattr(Scene, name)))
    for name in ("model_validate", "model_validate_json"):
        monkeypatch.setattr(Scene, name, count("validated", getattr(Scene, name)))
    return calls


def test_an_edit_validates_once(forms, qtbot, counted):
    enter(qtbot, forms, "images[0].receiver.position[2]", "7")
    assert counted == {"written": 1, "validated": 1}


def test_frames_validate_nothing(session, snapshots, history, counted):
    frame = make_frame(session, snapshots(0), history(0))
    assert frame.source == (session.scene.run.stages or [session.scene])[0].source
    assert counted == {}
