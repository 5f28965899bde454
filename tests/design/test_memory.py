"""Memory of a run, computed before it and measured."""

import json
from pathlib import Path

import numpy as np
import pytest
import torch

from tests.scenes import changed
from workbench.analysis.benchmark.examples import wavy
from workbench.design import memory
from workbench.design.lens_blur import BlurChange, LensBlur
from workbench.design.levels import FINE, cells_of, image_of
from workbench.design.memory import auto_memory, check_auto
from workbench.design.near_sources import source_cells
from workbench.design.run import run
from workbench.errors import Refused
from workbench.extended.blur import Blur
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene
from workbench.system_memory import as_bytes, release_freed_memory
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


def scene_of(name):
    return Scene.from_data(changed({"version": 2, "screen.pixels": [288, 288], **SCENES[name]}))


def status(name):
    """A number of bytes that the kernel knows of this process."""
    text = Path("/proc/self/status").read_text("ascii")
    return 1024 * int(text.split(f"{name}:")[1].split()[0])


def peak_of(work):
    """Bytes that work takes beyond what there was before, at most."""
    release_freed_memory()
    before = status("VmRSS")
    Path("/proc/self/clear_refs").write_text("5")  # the peak counts anew
    work()
    return status("VmHWM") - before


def blur_of(scene):
    """The blur of a lens, in which light of the sun is evaluated."""
    if not getattr(scene.source, "angular_diameter", 0):
        return None
    return LensBlur(Blur.of(scene), BlurChange(np.zeros((3, 10)), scene.receiver.half_extent))


def evaluation_peak(scene):
    """Bytes that an evaluation of a lens takes with its gradient, measured."""
    target = load_target(scene, None)
    heights = {
        face: torch.as_tensor(wavy(scene.with_net(net.shape)) - (0.3 if face == "entrance" else 0))
        for face, net in freeform_nets(scene.optic).items()
    }
    extent = scene.receiver.half_extent
    image = image_of(FINE, scene, target, extent, blur=blur_of(scene), cells=source_cells(scene))

    def evaluate():
        given = {face: each.clone().requires_grad_() for face, each in heights.items()}
        error, _ = image.compare(given)
        torch.autograd.grad(error.square().sum(), list(given.values()))

    evaluate()  # what is loaded and kept once
    # Threads that draw batches at the same time take the most, and do not always do so.
    return max(peak_of(evaluate) for _ in range(5))


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
    assert refused.value.path == "screen.pixels"
    assert refused.value.reason == (
        f"1024 × 1024 pixels with 64 × 64 control points need about {as_bytes(needed)} of memory, "
        f"and {as_bytes(needed - 1)} are free; take fewer of both, or close other programs"
    )
    monkeypatch.setattr(memory, "available_memory", lambda: needed)
    check_auto(large)


if __name__ == "__main__":
    print(json.dumps({name: evaluation_peak(scene_of(name)) for name in SCENES}))


def test_the_most_pixels_that_are_allowed_take_less_than_four_gigabytes():
    """By the table that the measurements of runs made."""
    most = {"version": 2, "screen.pixels": [4096, 4096], "lens.control_points": [16, 16]}
    scene = Scene.from_data(changed(most | SCENES["far"]))
    assert max(cells_of(FINE, scene)[:2]) <= 4096
    assert 2e9 < auto_memory(scene) < 4e9
