"""Memory of a run, computed before it and measured."""

import pytest

from tests.scenes import changed
from workbench.design import memory
from workbench.design.levels import FINE, cells_of
from workbench.design.memory import auto_memory, check_auto
from workbench.design.run import run
from workbench.errors import Refused
from workbench.process import as_bytes
from workbench.scene import Scene
from workbench.targets import load_target

SCENES = {
    "far": {"source": {"kind": "collimated", "rays": [16, 16]}},
    "sun": {"source": {"kind": "collimated", "rays": [16, 16], "angular_diameter": 0.533}},
    "point": {"source": {"kind": "point", "position": [0, 0, -30], "rays": 256}},
    "two faces": {"lens.entrance": {"shape": "freeform"}},
    "lamp": {
        "source": {"kind": "area", "center": [0, 0, -3], "half_width": [0.02, 0.02]},
        "lens.control_points": [128, 128],
    },
}


@pytest.fixture
def large(make_scene):
    """The smallest task with a net whose runs take 1 GB or more."""
    return make_scene({"screen.pixels": [1024, 1024], "lens.control_points": [64, 64]})


def test_a_run_that_does_not_fit_is_refused_before_anything_is_made(large, monkeypatch):
    needed = auto_memory(large)
    monkeypatch.setattr(memory, "available_memory", lambda: needed - 1)
    monkeypatch.setattr("workbench.design.run.Room", lambda *_: pytest.fail("was made"))
    with pytest.raises(Refused) as refused:
        next(run(large, load_target(large, None)))
    assert refused.value.path == "images[0].receiver.pixels"
    assert refused.value.reason == (
        f"1024 × 1024 pixels with 64 × 64 control points need about {as_bytes(needed)} of memory, "
        f"and {as_bytes(needed - 1)} are free; take fewer of both, or close other programs"
    )
    monkeypatch.setattr(memory, "available_memory", lambda: needed)
    check_auto(large)


def test_the_most_pixels_that_are_allowed_take_less_than_four_gigabytes():
    """By the table that the measurements of runs made."""
    most = {"version": 2, "screen.pixels": [4096, 4096], "lens.control_points": [16, 16]}
    scene = Scene.from_data(changed(most | SCENES["far"]))
    assert max(cells_of(FINE, scene)[:2]) <= 4096
    assert 2e9 < auto_memory(scene) < 4e9
