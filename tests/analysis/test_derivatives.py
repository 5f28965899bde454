"""Derivative maps: the paper's three cases, both modes of differentiation, differences, limits."""

import numpy as np
import pytest
import torch

from workbench.analysis.derivatives import irradiance_derivative
from workbench.design.limits import undesigned
from workbench.errors import Refused
from workbench.geometry.surface import freeform_nets
from workbench.optics.plan import Plan

PAPER = {  # section 3.1, figure: degrees and filter size
    "a": {"lens.degree": [3, 3], "filter.size": [3, 3]},
    "b": {"lens.degree": [3, 3], "filter.size": [11, 11]},
    "c": {"lens.degree": [5, 3], "filter.size": [3, 3]},
}
MIDDLE = (4, 4)
POINT = {"kind": "point", "position": [0.3, -0.2, -5.0], "rays": 20_000}
GRID = {
    "kind": "grid",
    "center": [0.0, 0.0, -5.0],
    "half_width": [0.5, 0.5],
    "points": [5, 5],
    "rays": 800,
}


@pytest.fixture
def make(make_scene):
    """A scene like those of the paper: light through a flat lens onto a screen of its size."""

    def build(case="a", **changes):
        paper = {"lens.control_points": [9, 9], "source.rays": [192, 192]}
        paper |= {"screen.pixels": [48, 48]}
        return make_scene(paper | PAPER[case] | changes)

    return build


def flat(scene):
    return np.full(scene.optic.net_shape, scene.optic.base.height)


def wavy(scene, rng):
    return flat(scene) + 0.02 * rng.normal(size=scene.optic.net_shape)


def derivative_of(scene, heights, weights, index):
    """Reverse mode: derivative of the weighted sum of the image, at one control height."""
    leaf = torch.tensor(heights, requires_grad=True)
    flux = Plan(scene, dtype=torch.float64).flux({"lens.back": leaf})
    (flux * torch.as_tensor(weights)).sum().backward()
    return leaf.grad[index].item() / scene.receiver.pixel_measure


@pytest.mark.parametrize("case", ["a", "b"])
def test_light_is_conserved_where_no_border_pixel_is_reached(make, case):
    scene = make(case)
    found = irradiance_derivative(scene, {"lens.back": flat(scene)}, MIDDLE)
    border = np.ones(found.map.shape, dtype=bool)
    border[1:-1, 1:-1] = False
    assert not found.map[border].any()
    assert abs(found.sum) < 1e-14 * found.flux
    assert found.sum == pytest.approx(found.map.sum() * scene.receiver.pixel_measure, abs=1e-14)


@pytest.mark.parametrize("case", PAPER)
def test_forward_mode_is_reverse_mode(make, rng, case):
    scene = make(case)
    heights, index = wavy(scene, rng), (3, 5)
    found = irradiance_derivative(scene, {"lens.back": heights}, index)
    scale = np.abs(found.map).max()
    for _ in range(3):
        weights = rng.normal(size=found.map.shape)
        by_reverse = derivative_of(scene, heights, weights, index)
        assert (weights * found.map).sum() == pytest.approx(by_reverse, abs=1e-11 * scale)
    rows, columns = np.nonzero(np.abs(found.map) > 0.1 * scale)
    for k in rng.choice(rows.size, 4, replace=False):
        pixel = np.zeros(found.map.shape)
        pixel[rows[k], columns[k]] = 1
        by_reverse = derivative_of(scene, heights, pixel, index)
        assert found.map[rows[k], columns[k]] == pytest.approx(by_reverse, abs=1e-12 * scale)


@pytest.mark.parametrize("source", [None, POINT, GRID], ids=["collimated", "point", "grid"])
@pytest.mark.parametrize("case", PAPER)
def test_differences_of_images_agree(make, rng, case, source):
    scene = make(case) if source is None else make(case, source=source)
    heights, index, step = wavy(scene, rng), (4, 3), 1e-8
    plan = Plan(scene, dtype=torch.float64)
    found = irradiance_derivative(scene, {"lens.back": heights}, index)
    images = []
    for sign in (1, -1):
        moved = torch.tensor(heights)
        moved[index] += sign * step
        images.append(plan.flux({"lens.back": moved}).numpy())
    differences = (images[0] - images[1]) / (2 * step * scene.receiver.pixel_measure)
    # The truncated filter has kinks, and few rays within a step of one make all the difference.
    error = np.linalg.norm(found.map - differences) / np.linalg.norm(differences)
    assert error < 1e-4


@pytest.mark.parametrize(("index", "field"), [((9, 0), "index[0]"), ((0, -1), "index[1]")])
def test_a_point_that_is_not_there_is_refused(make, index, field):
    scene = make()
    with pytest.raises(Refused, match="no control point; 0 to 8") as caught:
        irradiance_derivative(scene, {"lens.back": flat(scene)}, index)
    assert caught.value.path == field


@pytest.mark.parametrize(
    ("changes", "field"),
    [({"filter": {"kind": "box"}}, "filter.kind"), ({"filter.size": [3, 1]}, "filter.size[1]")],
)
def test_filters_that_count_rays_by_pixel_are_refused(make_scene, changes, field):
    scene = make_scene(changes)
    with pytest.raises(Refused, match="no derivative") as caught:
        irradiance_derivative(scene, {"lens.back": flat(scene)}, MIDDLE)
    assert caught.value.path == field


def test_each_face_has_derivatives_of_its_own(make_scene, rng):
    entrance = {"shape": "freeform", "control_points": [6, 7], "height_range": [-0.1, 0.1]}
    scene = make_scene({"lens.entrance": entrance})
    heights = {
        face: each + 0.01 * rng.normal(size=each.shape)
        for face, each in undesigned(scene.optic).items()
    }
    weights = rng.normal(size=scene.receiver.pixels[::-1])
    leaves = {face: torch.tensor(each, requires_grad=True) for face, each in heights.items()}
    flux = Plan(scene, dtype=torch.float64).flux(leaves)
    (flux * torch.as_tensor(weights)).sum().backward()
    for face, index in [("lens.front", (2, 3)), ("lens.back", (6, 5))]:
        found = irradiance_derivative(scene, heights, index, face=face)
        wanted = leaves[face].grad[index].item() / scene.receiver.pixel_measure
        assert (found.map * weights).sum() == pytest.approx(wanted, rel=1e-9)
        assert found.position == pytest.approx(
            [at[i] for at, i in zip(freeform_nets(scene.optic)[face].positions, index, strict=True)]
        )
    with pytest.raises(Refused, match="0 to 5"):
        irradiance_derivative(scene, heights, (6, 5), face="lens.front")
