"""What set-up compiles is all that designs and checks need."""

import os
import subprocess
import sys

import pytest

pytestmark = pytest.mark.full

# Designs and checks of all kinds in a process of their own; prints all kernels that they need
# beyond those of set-up, which may come from disk.
SCRIPT = """
import gc
from contextlib import suppress
import numpy as np
import torch
from numba.core.dispatcher import Dispatcher
from tests.scenes import changed
from workbench.analysis.cells.image import imaging
from workbench.analysis.kernels import compile_all
from workbench.analysis.validation import validate
from workbench.design.run import Evaluator
from workbench.design.limits import undesigned
from workbench.design.run import run
from workbench.errors import RunFailed
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import precision_of
from workbench.scene import Scene

compile_all(dtypes=(torch.float32, torch.float64))  # what set-up does

def signatures():  # of all that is compiled or taken from disk
    return {
        f"{kernel.py_func.__module__}.{kernel.py_func.__qualname__} {signature}"
        for kernel in gc.get_objects()
        if isinstance(kernel, Dispatcher) and "workbench" in kernel.py_func.__module__
        for signature in kernel.signatures
    }

before, fine = signatures(), []
point = {"kind": "point", "position": [0, 0, -4], "rays": 500}
grid = {"kind": "grid", "center": [0.1, 0, -4], "half_width": [0.2, 0.2], "points": [3, 2]}
sources = [{}, {"source": point}, {"source": point | {"emission": "lambertian"}}, {"source": grid}]
small = {"screen.pixels": [9, 12]}
other = {"lens.degree": [1, 4], "screen.pixels": [12, 9], "filter.size": [1, 5]}
far = {"screen.z": 2e5, "screen.pixels": [64, 64]}  # needs float64
tasks = [source | shape | {"run": {"method": method, "iterations": 2}}
         for source, shapes in zip(sources, [(small, far), (small, far), (other,), (other,)])
         for shape in shapes for method in ("auto", "paper")]
for task in tasks:
    scene = Scene.from_data(changed(task))
    fine.append(precision_of(scene, ControlNet.of(scene.optic)) == torch.float64)
    target = np.ones(scene.receiver.pixels[::-1])
    target[:, 0] = 0
    heights = undesigned(scene.optic)
    with suppress(RunFailed):  # a far screen may see no light
        for snapshot in run(scene, target):
            heights = snapshot.state.heights
        Evaluator(scene, target, heights).snapshot(heights)
        validate(scene, target, heights, rays=100)
        for _ in imaging(scene, heights, accuracy=0.1):
            pass
assert fine.count(True) == 4
print(*signatures() - before, sep="\\n")
"""


def python(*arguments):
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, *arguments]
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.timeout(1200)  # the first time, set-up takes minutes
def test_after_set_up_no_design_and_no_check_compiles_anything():
    assert python("-c", SCRIPT).split() == []
