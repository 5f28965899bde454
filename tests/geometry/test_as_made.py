"""Faces as manufacture leaves them, and relief against cut surfaces."""

import numpy as np
import pytest
import torch

from workbench.geometry.as_made import AsMade
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.basis import basis_matrix, greville
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet, freeform_nets, nets_of
from workbench.progress import finished
from workbench.scene import Scene
from workbench.scene.making.relief import FacePlaces, Grooves


def interpolated(net: ControlNet, function):
    """Control heights of a face that is a function at the Greville abscissae."""
    x, y = net.positions
    values = function(x[:, None], y)
    for axis in (0, 1):
        knots, degree = net.knots[axis], net.degree[axis]
        matrix = basis_matrix(knots, degree, greville(knots, degree))
        values = np.moveaxis(np.linalg.solve(matrix, np.moveaxis(values, axis, 0)), 0, axis)
    return values


@pytest.fixture
def made_of(make_scene):
    def made_of(*processes, points=(80, 60)):
        scene = make_scene({"lens.control_points": list(points)})
        return AsMade.of(Scene.from_data(scene.to_data() | {"processes": list(processes)}))

    return made_of


def polishing(width, **more):
    return {"kind": "polishing", "width": width, **more}


class TestSmoothing:
    @pytest.mark.parametrize("width", [0.005, 0.02, 0.1])
    def test_planes_stay_planes(self, made_of, width):
        net = ControlNet((80, 60), (3, 3), (1.0, 1.0))
        plane = interpolated(net, lambda x, y: 0.5 + 0.1 * x - 0.2 * y)
        made = made_of(polishing(width)).heights({"lens.back": plane})["lens.back"]
        assert made == pytest.approx(plane, abs=1e-11)

    @pytest.mark.parametrize("width", [0.01, 0.04])
    def test_waves_are_damped_as_by_a_gaussian(self, made_of, width):
        net, k = ControlNet((80, 60), (3, 3), (1.0, 1.0)), 12.0
        wave = interpolated(net, lambda x, y: 0.5 + 0.01 * np.sin(k * x) + 0 * y)
        made = made_of(polishing(width)).heights({"lens.back": wave})["lens.back"]
        x = np.linspace(-0.6, 0.6, 50)
        found = net.at(x, 0 * x, made)[0]
        assert found == pytest.approx(
            0.5 + 0.01 * np.exp(-((k * width) ** 2) / 2) * np.sin(k * x), abs=2e-6
        )

    def test_the_adjoint_is_the_transpose_and_torch_takes_it(self, made_of, rng):
        made = made_of(polishing(0.05), {"kind": "moulding", "shrinkage": 0.01})
        heights, other = rng.random((2, 80, 60))
        face = made.faces["lens.back"]
        linear = face.forward(heights) - face.forward(np.zeros((80, 60)))
        assert (linear * other).sum() == pytest.approx((heights * face.adjoint(other)).sum())
        x = torch.tensor(heights, requires_grad=True)
        found = made.tensors({"lens.back": x})["lens.back"]
        assert found.detach().numpy() == pytest.approx(face.forward(heights))
        (gradient,) = torch.autograd.grad((found * torch.tensor(other)).sum(), [x])
        assert gradient.numpy() == pytest.approx(face.adjoint(other))

    def test_heights_before_it_come_out_as_wanted(self, made_of):
        net = ControlNet((80, 60), (3, 3), (1.0, 1.0))
        wanted = {"lens.back": interpolated(net, lambda x, y: 0.5 + 0.01 * np.sin(20 * x) * y)}
        made = made_of(polishing(0.05))
        off, plain = (
            np.abs(made.heights(each)["lens.back"] - wanted["lens.back"])[10:-10, 10:-10].max()
            for each in (made.for_result(wanted), wanted)
        )
        assert off < 0.01 * plain

    def test_a_layer_and_shrinkage(self, made_of):
        flat = {"lens.back": np.full((80, 60), 0.5)}
        lower = made_of(polishing(0.01, depth=0.03)).heights(flat)["lens.back"]
        assert lower == pytest.approx(0.47)
        small = made_of({"kind": "moulding", "shrinkage": 0.01})
        assert small.heights(flat)["lens.back"] == pytest.approx(0.495)
        assert small.scene.optic.half_width == pytest.approx((0.99, 0.99))

    def test_nothing_without_processes(self, made_of, rng):
        heights, made = {"lens.back": rng.random((80, 60))}, made_of()
        assert made.heights(heights)["lens.back"] is heights["lens.back"]
        assert not made.faces
        assert not made.reliefs


def test_long_waves_of_an_error_are_the_face_and_short_ones_relief(made_of):
    error = {"kind": "figure_error", "slope": 1.0, "length": 0.02, "seed": 3}
    made = made_of(error)
    ((short, _),) = made.reliefs
    long_waves = made.faces["lens.back"].after
    spacing = max(next(iter(nets_of(made.scene).values())).spacing)
    assert np.linalg.norm(short.waves[0], axis=1).min() >= 1 / spacing
    assert np.std(long_waves) > 0
    unknown = AsMade.of(made.scene.altered(processes=()), errors=False)
    assert not unknown.faces


_SHAPES = {
    "flat": lambda x, y: 0.5 + 0 * x * y,
    "steep across": lambda x, y: 0.5 + 0 * x + 0.5 * y,
    "steep along": lambda x, y: 0.5 + 0.5 * x + 0 * y,
    "steep": lambda x, y: 0.5 + 0.4 * x + 0.4 * y,
    "hollow": lambda x, y: 0.5 + 1.0 * (x**2 + y**2) / 2,
    "hump": lambda x, y: 0.8 - 1.0 * (x**2 + y**2) / 2,
    "saddle": lambda x, y: 0.6 + 0.8 * x * y,
}


@pytest.mark.parametrize("shape", _SHAPES)
def test_grooves_have_the_slopes_of_the_swept_ball(make_scene, rng, shape):
    """The cut surface itself: every ball along the tool's path, and the lowest point of all."""
    scene = make_scene({"lens.control_points": [24, 24], "lens.height_range": [-2, 2]})
    net = freeform_nets(scene.optic)["lens.back"]
    heights = interpolated(net, _SHAPES[shape])
    radius = 0.3
    raster = finished(
        CutFace(net, heights, outline_of(scene.optic)).plan_raster(radius, 5e-4, 10**7)
    )
    x, y = rng.uniform(-0.7, 0.7, (2, 120_000))
    _, normal = raster.cut(x, y)
    _, slope_x, slope_y = net.at(x, y, heights)
    swept = -normal[:, 1] / normal[:, 2] - slope_y
    grooves = Grooves(radius, float(raster.y[1] - raster.y[0]), (0.0, 1.0))
    found = grooves.slopes(FacePlaces(x, y, slope_x, slope_y), 0.0)[1]
    assert found.std() == pytest.approx(swept.std(), rel=0.02)
    # Images on a screen where ridges spread light over some 30 pixels, of two sets of rays each.
    far = 30 * 0.05 / (found.max() - found.min())
    images = [
        np.histogram2d(
            x[part], y[part] + far * slope[part], bins=(7, 40), range=[[-0.7, 0.7], [-3, 3]]
        )[0]
        for slope in (found, swept)
        for part in (slice(0, 60_000), slice(60_000, None))
    ]
    one, other, first, second = (image / image.sum() for image in images)
    square = ((one - first) * (other - second)).sum() / (first * second).sum()
    assert square < 0.01**2 + 3 * 2e-4  # three times the scatter of the product


def test_elements_that_are_not_designed_are_ideal(make_scene):
    scene = make_scene({})
    scene = Scene.from_data(scene.to_data() | {"processes": [polishing(0.05)]})
    plain = scene.with_element(0, scene.elements[0].undesigned)
    assert not AsMade.of(plain).faces
