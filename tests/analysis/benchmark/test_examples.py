import numpy as np
import pytest
import torch

import resources
from workbench.analysis.benchmark.examples import BenchmarkTask, wavy
from workbench.design.heights import HeightRange
from workbench.errors import Refused
from workbench.files.session import open_design
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


def test_the_photograph_is_drawn_at_any_size_as_it_ships():
    shipped, same, finer = (
        BenchmarkTask.of("photo"),
        BenchmarkTask.photo(256),
        BenchmarkTask.photo(512),
    )
    np.testing.assert_allclose(same.target, shipped.target, atol=0.5 / 255 + 1e-9)
    assert same.scene == shipped.scene
    assert finer.target.shape == (512, 512) and finer.scene.receiver.pixels == (512, 512)
    assert same.scene.optic.net_shape == (480, 480)
    assert finer.scene.optic.net_shape == (960, 960)


def test_the_cloud_has_detail_of_every_size():
    image = BenchmarkTask.cloud().target
    np.testing.assert_array_equal(image, BenchmarkTask.cloud().target)
    assert image.min() == 0 and image.max() == 1 and image.shape == (256, 256)
    frequency = np.hypot(np.fft.fftfreq(256)[:, None], np.fft.rfftfreq(256))
    waves = np.abs(np.fft.rfft2(image))
    ranges = [(low, 2 * low) for low in (0.02, 0.05, 0.1, 0.2)]
    times = [(waves * frequency)[(frequency >= a) & (frequency < b)].mean() for a, b in ranges]
    np.testing.assert_allclose(times, times[0], rtol=0.1)


def test_a_saved_example_is_the_same_task(make_example, tmp_path):
    example = make_example()
    opened = open_design(example.save(tmp_path))
    np.testing.assert_allclose(
        opened.target / opened.target.sum(), example.target / example.target.sum()
    )
    assert opened.scene.optic == example.scene.optic and opened.scene.run == example.scene.run


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


def test_impossible_changes_are_refused():
    with pytest.raises(Refused, match="control_points"):
        BenchmarkTask.of("tophat", changes={"lens.back.control_points": [2, 2]})


@pytest.mark.parametrize("name", ["tophat", "flame-x1", "ball-x5", "flame-point"])
def test_the_wavy_lens_is_allowed_and_bends_light(name):
    scene = BenchmarkTask.of(name, changes={"lens.back.control_points": 16}).scene
    heights = wavy(scene)
    free = HeightRange.of(scene.optic, ControlNet.of(scene.optic))
    assert (heights > free.lower.numpy()).all() and (heights < free.upper.numpy()).all()
    slopes = np.diff(heights, axis=0)
    assert np.ptp(slopes) > 0
    assert Plan(scene).trace({"exit": torch.tensor(heights)}).account.on_screen > 0.1
