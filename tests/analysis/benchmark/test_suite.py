"""Benchmarks that users run: examples, experiments and bounds."""

import numpy as np
import pytest

import resources
from workbench.analysis.benchmark import experiments
from workbench.analysis.benchmark.bounds import compare_with_bound, table
from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.analysis.benchmark.experiments import (
    DERIVATIVES,
    DESIGNS,
    derivative,
    design,
    tables,
)
from workbench.analysis.benchmark.names import BENCHMARKS, DEFAULT
from workbench.analysis.benchmark.suite import SUITE
from workbench.analysis.validation import validate
from workbench.targets import load_target


def test_a_lens_for_the_sun_lies_between_its_bound_and_a_sharp_lens():
    small = {
        "images[0].receiver.pixels": 16,
        "lens.back.control_points": 20,
        "source.angular_diameter": 5.0,
        "run.iterations": 4,
    }
    progress = []
    example = BenchmarkTask.of("sun-plate", changes=small)
    found = compare_with_bound("photo", example, lambda case, state: progress.append((case, state)))
    assert 0 < found.bound <= found.light < found.lens < found.sharp
    assert found.bound <= found.spots < found.lens
    assert found.to_spots == found.lens / found.spots
    assert found.ratio == found.lens / found.bound
    assert progress[0] == ("photo", "its bound") and progress[-1] == ("photo", "iteration 4")
    assert "| photo | " in table([found]).to_markdown()


def test_reads_what_ships():
    example = BenchmarkTask.of("flame")
    (shipped,) = (each for each in resources.EXAMPLES if each.name == "flame")
    assert example.group == shipped.group
    assert example.scene.receiver.pixels == (256, 256)
    np.testing.assert_array_equal(example.target, load_target(example.scene, shipped.file.parent))


RAYS = 10_000


def test_every_listed_benchmark_is_in_the_suite():
    assert list(SUITE) == list(BENCHMARKS)
    assert DEFAULT in BENCHMARKS


def test_a_design_is_judged_by_the_independent_check(make_example, progress):
    example = make_example({"run.iterations": 5, "run.method": "paper"})
    found = design(example, "paper", RAYS, progress)
    light = validate(example.scene, example.target, found.result.state.heights, RAYS)
    assert (found.error, found.noise) == (light.relative_l2, light.noise)
    assert found.efficiency == light.efficiency
    assert found.loss == found.result.losses.min()
    assert found.iterations == 5 and len(found.times) == 6
    assert found.seconds == found.times[-1]
    assert found.milliseconds_an_iteration * 5 / 1e3 == pytest.approx(
        found.times[-1] - found.times[0]
    )
    assert progress.lines[-1] == ("small, paper", "verifying")


def test_every_experiment_of_the_paper_is_there():
    shipped = {each.name for each in resources.EXAMPLES}
    assert {*DESIGNS, *DERIVATIVES} <= shipped
    assert len(DERIVATIVES) == 3
    methods = {name: [method for _, method in experiments._methods(name)] for name in DESIGNS}
    for name, each in methods.items():
        assert each == (["paper"] if name.startswith("tophat") else ["paper", "auto"])


def test_derivatives_move_light_and_make_none():
    found = []
    for name in DERIVATIVES:
        changes = {"source.rays": 96, "images[0].receiver.pixels": 32}
        example = BenchmarkTask.of(name, changes=changes)
        found.append(derivative(example))
    a, b, c = found
    for each in found:
        assert each.sum == pytest.approx(
            each.map.sum() * each.scene.receiver.pixel_measure, abs=1e-9
        )
        assert each.moved > 0.1 and each.pixels == np.count_nonzero(each.map)
    assert abs(a.balance) < 1e-12
    assert 1e-9 < abs(c.balance) < 1e-3  # light crosses the border of the screen
    assert a.pixels < b.pixels and a.pixels < c.pixels
    _, table = tables(found)
    assert [row["sum"] for row in table.to_data()] == [each.sum for each in found]
