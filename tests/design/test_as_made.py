"""Designs for the image as made, and what checks find of them."""

import numpy as np
import pytest
import torch

from workbench.analysis.making.as_made import checking
from workbench.analysis.metrics import relative_l2
from workbench.analysis.validation import validate
from workbench.design.levels import finest_image, judging_image
from workbench.design.loss import relative_error
from workbench.design.run import run
from workbench.errors import Refused
from workbench.geometry.surface import nets_of
from workbench.optics.plan import tensors_of
from workbench.progress import finished
from workbench.scene import Scene

_POLISHING = {"kind": "polishing", "width": 0.06}
_MILLING = {"kind": "milling", "ball_radius": 0.3, "step_over": 0.02}


def scene_of(make_scene, *processes, **changes):
    small = {"lens.control_points": [40, 40], "screen.pixels": [40, 40], **changes}
    scene = make_scene(small)
    return Scene.from_data(scene.to_data() | {"processes": list(processes)})


def letter():
    target = np.full((40, 40), 0.2)
    target[8:32, 10:16] = target[26:32, 16:30] = 1.0
    return target


def best(scene, target):
    *_, last = run(scene, target)
    return last.state


class TestRun:
    def test_polishing_that_it_knows_costs_less(self, make_scene):
        target, polished = letter(), scene_of(make_scene, _POLISHING)
        ideal = best(polished.ideal, target)
        known = best(polished, target)
        errors = [
            validate(polished, target, state.heights, rays=400_000, accuracy=1e-3).by_cells
            for state in (ideal, known)
        ]
        unaware, aware = (each.relative_l2_corrected for each in errors)
        assert aware < 0.7 * unaware
        assert relative_error(known, target) == pytest.approx(aware, rel=0.1)

    def test_it_sees_what_the_check_sees(self, make_scene):
        target = letter()
        scene = scene_of(make_scene, _MILLING, _POLISHING | {"width": 0.004})
        state = best(scene, target)
        found = finished(checking(scene, target, state.heights, rays=1_000_000))
        designed, milled, made = found.steps
        assert [step.title for step in found.steps] == ["", "Milling", "Polishing"]
        assert made.error == found.relative_l2_corrected
        assert milled.change == milled.error - designed.error
        off = max(made.interval) - made.error
        seen = relative_error(state, target)
        assert seen == pytest.approx(made.error, abs=off + 0.05 * made.error)
        assert found.by_cells is None
        assert "the relief that manufacture leaves scatters the light" in str(found.left_out)

    def test_the_last_look_knows_the_errors_of_a_part(self, make_scene, rng):
        error = {"kind": "figure_error", "slope": 20.0, "length": 0.4}
        scene, target = scene_of(make_scene, error), letter()
        lens = {"lens.back": 0.5 + 0.001 * rng.random((40, 40))}
        tensors = tensors_of(lens, scene)
        seen, judged = (
            image(scene, target, tensors).step(tensors).state.irradiance
            for image in (finest_image, judging_image)
        )
        assert np.abs(judged - seen).max() > 0.05 * seen.mean()
        checked = validate(scene, target, lens, rays=400_000, accuracy=1e-3).by_cells
        assert relative_l2(judged, checked.irradiance) < 0.01

    def test_the_papers_method_refuses_it(self, make_scene):
        scene = scene_of(make_scene, _POLISHING, **{"run.method": "paper"})
        with pytest.raises(Refused, match="processes: the paper's method"):
            next(run(scene, letter()))


@pytest.mark.parametrize(
    "processes",
    [
        [_POLISHING],
        [{"kind": "moulding", "shrinkage": 0.01}],
        [_MILLING, _POLISHING | {"width": 0.005}],
        [{"kind": "printing", "layer_height": 0.002, "pixel_size": 0.004, "dip_width": 0.01}],
    ],
    ids=["polished", "moulded", "milled", "printed"],
)
def test_the_gradient_is_that_of_differences(make_scene, rng, processes):
    scene, target = scene_of(make_scene, *processes), letter()
    net = nets_of(scene)["lens.back"]
    x, y = net.positions
    lens = {"lens.back": 0.5 - 0.05 * (x[:, None] ** 2 + y**2)}
    image = finest_image(scene, target, tensors_of(lens, scene))
    way = torch.as_tensor(np.cos(2 * x[:, None]) * np.sin(3 * y))
    heights = tensors_of(lens, scene)["lens.back"].requires_grad_()
    value = image.compare({"lens.back": heights})[0].square().sum()
    (gradient,) = torch.autograd.grad(value, [heights])
    step = 1e-4
    ends = [
        image.compare({"lens.back": heights.detach() + s * way})[0].square().sum().item()
        for s in (step, -step)
    ]
    assert (gradient * way).sum().item() == pytest.approx(
        (ends[0] - ends[1]) / (2 * step), rel=2e-2
    )
