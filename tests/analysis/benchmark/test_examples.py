import numpy as np
import pytest
import torch

import resources
from workbench.analysis.benchmark.examples import BenchmarkTask, wavy
from workbench.design.heights import HeightRange
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan
from workbench.scene import PaperRun, PointSource
from workbench.targets import load_target


def test_reads_what_ships():
    example = BenchmarkTask.of("flame")
    (shipped,) = (each for each in resources.EXAMPLES if each.name == "flame")
    assert example.group == shipped.group
    assert example.scene.receiver.pixels == (256, 256)
    np.testing.assert_array_equal(example.target, load_target(example.scene, shipped.file.parent))


def test_changes_are_by_path():
    example = BenchmarkTask.of(
        "tophat",
        changes={
            "lens.back.control_points": [8, 9],
            "source": {"kind": "point", "position": [0, 0, -5], "rays": 10},
            "run": {"method": "paper", "iterations": 3},
            "unit": "mm",
        },
    )
    scene = example.scene
    assert scene.optic.control_points == (8, 9) and scene.optic.index == 1.5
    assert isinstance(scene.source, PointSource) and scene.source.rays == 10
    assert isinstance(scene.run, PaperRun) and scene.run.iterations == 3
    assert scene.unit == "mm"


<<<<<<< HEAD
=======
def test_impossible_changes_are_refused():
    with pytest.raises(Refused, match="control_points"):
        BenchmarkTask.of("tophat", changes={"lens.back.control_points": [2, 2]})


>>>>>>> v3files
@pytest.mark.parametrize("name", ["tophat", "flame-x1", "ball-x5", "flame-point"])
def test_the_wavy_lens_is_allowed_and_bends_light(name):
    scene = BenchmarkTask.of(name, changes={"lens.back.control_points": 16}).scene
    heights = wavy(scene)
    free = HeightRange.of(scene.optic, ControlNet.of(scene.optic))
    assert (heights > free.lower.numpy()).all() and (heights < free.upper.numpy()).all()
    slopes = np.diff(heights, axis=0)
    assert np.ptp(slopes) > 0
    assert Plan(scene).trace({"exit": torch.tensor(heights)}).account.on_screen > 0.1
