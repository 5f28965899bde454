import numpy as np

import resources
from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.scene import PaperRun, PointSource
from workbench.targets import load_target


def test_reads_what_ships():
    example = BenchmarkTask.of("flame")
    (shipped,) = (each for each in resources.EXAMPLES if each.name == "flame")
    assert example.group == shipped.group
    assert example.scene.receiver.pixels == (256, 256)
    np.testing.assert_array_equal(example.target, load_target(example.scene, shipped.file.parent))


def test_changes_are_merged_and_other_kinds_replace():
    example = BenchmarkTask.of(
        "tophat",
        lens={"control_points": [8, 9]},
        source={"kind": "point", "position": [0, 0, -5], "rays": 10},
        run={"method": "paper", "iterations": 3},
        unit="mm",
    )
    scene = example.scene
    assert scene.optic.control_points == (8, 9) and scene.optic.index == 1.5
    assert isinstance(scene.source, PointSource) and scene.source.rays == 10
    assert isinstance(scene.run, PaperRun) and scene.run.iterations == 3
    assert scene.unit == "mm"
