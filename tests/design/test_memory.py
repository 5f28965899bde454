"""Memory of a run, computed before it and measured."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
import torch

from tests.benchmarks.kernels import wavy
from tests.scenes import changed
from workbench.design import memory
from workbench.design.images import WideImage
from workbench.design.levels import FINE, cells_of, fine_level, source_cells
from workbench.design.memory import auto_memory, check_auto
from workbench.design.run import run
from workbench.errors import Refused
from workbench.process import as_bytes, release_freed_memory
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
    monkeypatch.setattr("workbench.design.run.Bounds", lambda *_: pytest.fail("was made"))
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
    assert 1e9 < auto_memory(scene) < 4e9


def peak_of(work):
    """Bytes that work takes at most, beyond what there was before."""

    def status(name):
        text = Path("/proc/self/status").read_text("ascii")
        return 1024 * int(text.split(f"{name}:")[1].split()[0])

    release_freed_memory()
    before = status("VmRSS")
    Path("/proc/self/clear_refs").write_text("5")  # the peak counts anew
    work()
    return status("VmHWM") - before


def evaluation_peak(scene):
    """Bytes that an evaluation of a lens takes with its gradient, measured."""
    heights = {scene.optic.designed_face: torch.as_tensor(wavy(scene))}
    extent, cells = scene.receiver.half_extent, source_cells(scene)
    cells = cells or cells_of(FINE, scene)
    image = WideImage(scene, load_target(scene, None), cells, extent)

    def evaluate():
        given = {face: each.clone().requires_grad_() for face, each in heights.items()}
        error, _ = image.compare(given)
        torch.autograd.grad(error.square().sum(), list(given.values()))

    evaluate()  # what is loaded and kept once
    # Threads that draw batches at the same time take the most, and do not always do so.
    return max(peak_of(evaluate) for _ in range(3))


MEASURED = ("far", "lamp")


@pytest.fixture(scope="module")
def peaks():
    """Peaks from a process in which each array is mapped by itself.

    In a heap, where freed pieces stay between others, the same evaluation took 5 to 28 % more.
    """
    settings = os.environ | {
        "GLIBC_TUNABLES": "glibc.malloc.mmap_threshold=65536",
        "PYTHONPATH": str(Path(__file__).parents[2]),
    }
    done = subprocess.run([sys.executable, __file__], env=settings, capture_output=True, check=True)
    return json.loads(done.stdout)


@pytest.mark.full
@pytest.mark.skipif(sys.platform != "linux", reason="needs the account of Linux's kernel")
@pytest.mark.parametrize("name", MEASURED)
def test_an_evaluation_takes_the_memory_that_was_computed(peaks, name):
    scene = scene_of(name)
    cells = source_cells(scene)
    level = fine_level(scene)
    computed = memory._of_nodes(scene, cells) if cells else memory._of_image(scene, level)
    # The formula counts pieces of the heap, too.
    assert 1.05 * peaks[name] < computed < 1.4 * peaks[name]


def scene_of(name):
    return Scene.from_data(changed({"version": 2, "screen.pixels": [288, 288], **SCENES[name]}))


if __name__ == "__main__":
    print(json.dumps({name: evaluation_peak(scene_of(name)) for name in MEASURED}))
