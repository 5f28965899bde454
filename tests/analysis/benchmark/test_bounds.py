"""Lenses for the sun and their bounds."""

from workbench.analysis.benchmark.bounds import compare_with_bound, table
from workbench.analysis.benchmark.examples import BenchmarkTask


def test_a_lens_for_the_sun_lies_between_its_bound_and_a_sharp_lens():
    small = {
        "images[0].receiver.pixels": [24, 24],
        "lens.back.control_points": [32, 32],
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
