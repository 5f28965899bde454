"""Automatic runs: mirrors, near sources, and lenses shaped by hand."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.scenes import changed
from workbench.design.brush import Stroke, bump
from workbench.design.images import WideImage
from workbench.design.levels import source_cells
from workbench.design.run import Evaluator, run
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import tensors_of
from workbench.scene import Scene


def best(scene, target):
    return [s for s in run(scene, target) if s.best][-1]


@pytest.fixture
def letter():
    image = np.zeros((32, 32))
    image[6:26, 8:12] = 1.0
    image[22:26, 8:24] = 1.0
    return image


def test_the_first_iteration_reduces_the_loss_to_a_third(make_scene, letter):
    first, second, *_ = run(make_scene({"lens.control_points": [24, 24]}), letter)
    assert second.state.loss < 0.3 * first.state.loss


def test_symmetric_tasks_have_symmetric_lenses(make_scene):
    scene = make_scene({"run.iterations": 20})
    across = np.linspace(-1, 1, 32)
    disc = (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)
    heights = best(scene, disc).state.heights["lens.back"]
    for axis in (0, 1):
        assert heights == pytest.approx(np.flip(heights, axis), abs=1e-12)


@pytest.mark.parametrize("kind", ["point", "grid"])
def test_light_of_points_reaches_the_screen(make_scene, letter, kind):
    source = {"kind": "point", "position": [0.1, 0.0, -5.0], "rays": 4096}
    if kind == "grid":
        source = {
            "kind": "grid",
            "center": [0.1, 0.0, -5.0],
            "half_width": [0.02, 0.02],
            "points": [3, 3],
            "rays": 500,
        }
    scene = make_scene({"source": source, "lens.control_points": [24, 24]})
    found = best(scene, letter)
    lost = found.state.account.lost["off_screen"] + found.state.account.lost["total_reflection"]
    assert lost < 0.03 * found.state.account.on_screen


SOURCES = {
    "collimated": {"kind": "collimated", "rays": [48, 48]},
    "point": {"kind": "point", "position": [0.0, 0.0, -3.0], "rays": 3000},
}


@pytest.fixture
def bar():
    """A rectangle, brighter at one end."""
    image = np.zeros((32, 32))
    image[6:26, 10:22] = 1.0
    image[6:12, 10:22] = 3.0
    return image


@pytest.mark.parametrize(
    ("source", "parametrisation", "start"),
    [
        ("collimated", "none", "zeros"),
        ("collimated", "sparse", "uniform"),
        ("collimated", "dense", "random"),
        ("point", "none", "random"),
        ("point", "sparse", "random"),
    ],
)
def test_the_paper_method_shapes_a_mirror(bar, source, parametrisation, start):
    settings = {"method": "paper", "parametrisation": parametrisation, "start": start}
    scene = Scene.from_data(
        {
            "mirror": {
                "half_width": [1.0, 1.0],
                "control_points": [12, 10],
                "height_range": [-0.3, 0.3],
            },
            "source": SOURCES[source],
            "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [32, 32]},
            "filter": {"kind": "gaussian", "size": [3, 3], "alpha": 1.0},
            "target": {"builtin": "tophat"},
            "run": settings | {"iterations": 25},
        }
    )
    shots = list(run(scene, bar))
    assert shots[-1].state.loss < 0.9 * shots[0].state.loss
    assert np.abs(shots[-1].state.heights["mirror.face"]).max() < 0.3


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_grids_of_a_source_have_rows_in_pairs_and_the_middle_where_half_is_traced(
    make_scene, outline
):
    for width in (0.001, 0.1, 0.3, 0.5, 0.9):
        led = {"kind": "area", "center": [0, 0, -1.0], "half_width": [width, width / 2]}
        scene = make_scene({"version": 2, "source": led | {"outline": outline}})
        for mirrored in product((False, True), repeat=2):
            across, up = source_cells(scene, mirrored).of_source
            assert across >= 2 and across % 2 == 0, (width, mirrored)
            if mirrored[1]:
                assert up % 4 == 2, (width, mirrored)
            else:
                assert up >= 3 and up % 2 == 1, (width, mirrored)


PAPER = {"method": "paper", "iterations": 3}


POINT = {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 4096}


@pytest.fixture
def target():
    image = np.zeros((32, 32))
    image[8:20, 10:26] = 1.0
    return image


@pytest.mark.parametrize(
    "changes", [{}, {"run": PAPER}, {"source": POINT}, {"source": POINT, "run": PAPER}]
)
def test_a_lens_is_judged_as_by_its_run(make_scene, target, changes):
    scene = make_scene(changes)
    *_, last = run(scene, target)
    found = Evaluator(scene, target, last.state.heights).snapshot(last.state.heights)
    continued = next(run(scene, target, last.state.heights))
    assert found.state.loss == pytest.approx(continued.state.loss, rel=2e-2)
    lit = continued.state.irradiance.max()
    np.testing.assert_allclose(found.state.irradiance, continued.state.irradiance, atol=1e-2 * lit)
    parts = found.state.account.to_data()
    assert sum(parts.values()) == pytest.approx(2 * parts["emitted"], rel=1e-5)
    assert found.state.heights is not last.state.heights
    assert not found.state.heights["lens.back"].flags.writeable


@pytest.fixture
def lens(make_scene):
    return make_scene().optic  # 12 × 10 points, base at 0.5, heights 0.2 to 0.8


@pytest.fixture
def flat():
    return np.full((12, 10), 0.5)


def test_the_bump_is_the_formula_and_nothing_beyond_the_radius(lens):
    net, radius = ControlNet.of(lens), 0.55
    block, weights = bump(net, (5, 0), radius)
    whole = np.zeros((12, 10))
    whole[block] = weights
    x, y = net.positions
    d = np.hypot(x[:, None] - x[5], y - y[0]) / radius
    np.testing.assert_allclose(whole, np.where(d < 1, (1 - d**2) ** 2, 0), atol=1e-15)
    assert whole[5, 0] == 1


@given(
    index=st.tuples(st.integers(0, 11), st.integers(0, 9)),
    by=st.floats(-5, 5),
    radius=st.floats(0, 3),
)
def test_heights_stay_in_their_range(index, by, radius):
    lens = Scene.from_data(changed({"lens.min_thickness": 0.3})).optic
    heights = Stroke(lens, "lens.back", np.full((12, 10), 0.5), None, index, radius).raised(by)
    assert heights.min() >= 0.3  # the minimal thickness ends before the height range
    assert heights.max() <= 0.8


def test_locked_points_stay(lens, flat):
    locked = np.zeros((12, 10), dtype=bool)
    locked[4:6] = True
    raised = Stroke(lens, "lens.back", flat, locked, (4, 4), 0.8).raised(0.2)
    np.testing.assert_array_equal(raised[locked], 0.5)
    assert raised[3, 4] > 0.55
    assert not Stroke(lens, "lens.back", flat, locked, (4, 4), 0.0).moves
    assert Stroke(lens, "lens.back", flat, locked, (3, 4), 0.0).moves


def test_a_run_with_a_near_source_ends_with_light_of_finer_beams(make_scene, letter):
    """The descent corrects the errors of its own beams."""
    led = {"kind": "area", "center": [0, 0, -1.5], "half_width": [0.15, 0.15]}
    lens = {"lens.control_points": [16, 16], "lens.height_range": [-1, 2], "run.iterations": 25}
    screen = {"screen.z": 6, "screen.half_width": [3, 3]}
    scene = make_scene({"version": 2, "source": led} | lens | screen)
    *steps, last = run(scene, letter)
    seen = [step for step in steps if step.best][-1].state.loss
    finer, extent = source_cells(scene, finer=3), scene.receiver.half_extent
    heights = tensors_of(last.state.heights, scene)
    true = WideImage(scene, letter, finer, extent).step(heights).state.loss
    assert last.judged
    assert seen < true
    assert abs(last.state.loss - true) < 0.4 * abs(seen - true)
