"""White light: an image is the sum over the lines of a spectrum, each with its own indices."""

import math

import numpy as np
import pytest
import torch

from workbench.analysis.cells.image import imaging
from workbench.analysis.photo.photo import photograph
from workbench.analysis.tolerances import Perturbation
from workbench.analysis.validation import validate
from workbench.design.design_run import DesignRun
from workbench.design.task import begin
from workbench.geometry.surface import ControlNet
from workbench.materials import refractive_index
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import Plan
from workbench.optics.samples import Corners
from workbench.progress import finished
from workbench.scene import Scene

LINES = ((0.45, 0.3), (0.55, 0.5), (0.63, 0.2))
SLOPE, THICK, FAR = 0.4, 5.0, 60.0
LIGHTS = {
    "collimated": {"kind": "collimated"},
    "point": {"kind": "point", "position": [0, 0, -40]},
    "extended": {"kind": "area", "position": [0, 0, -40], "half_width": [0.5, 0.5]},
}


def scene_of(light, elements=(), **receiver):
    receiver = {"position": [15, 0, FAR], "half_width": [4, 3], "pixels": [80, 24]} | receiver
    lens = {"kind": "lens", "name": "lens", "half_width": [2, 2], "material": "PC"}
    lens |= {"thickness": THICK, "position": [0, 0, 0]}
    lens["faces"] = [{"shape": "plane"}, {"shape": "bspline", "control_points": [8, 8]}]
    image = {"receiver": {"kind": "plane", **receiver}, "target": {"builtin": "tophat"}}
    return Scene.from_data(
        {
            "version": 3,
            "source": {"kind": "collimated"} | light,
            "elements": [lens, *elements],
            "images": [image],
            "run": {"method": "auto", "iterations": 12},
        }
    )


def wedge(scene):
    x, _ = ControlNet.of(scene.optic).positions
    return {"lens.back": np.repeat(THICK + SLOPE * x[:, None], 8, axis=1)}


def behind_wedge(scene):
    """Flux in the columns of pixels, by Snell's law and Fresnel's equations line by line."""
    receiver = scene.receiver
    (half, _), (count, _) = receiver.half_width, receiver.pixels
    edges = receiver.position[0] + np.linspace(-half, half, count + 1)
    flux = np.zeros(count)
    for wavelength, part in LINES:
        n, inside = refractive_index("PC", wavelength), math.atan(SLOPE)
        outside = math.asin(n * math.sin(inside))
        a, b = math.cos(inside), math.cos(outside)
        through = 1 - sum(((n * p - q) / (n * p + q)) ** 2 for p, q in ((a, b), (b, a))) / 2
        through *= 1 - ((n - 1) / (n + 1)) ** 2
        bent = math.tan(outside - inside)
        begin, end = (x + (FAR - THICK - SLOPE * x) * bent for x in (-2.0, 2.0))
        flux += part * through * np.diff(((edges - begin) / (end - begin)).clip(0, 1))
    return flux


def tensors(heights):
    return {name: torch.as_tensor(each) for name, each in heights.items()}


def test_each_line_is_shifted_by_snells_law_behind_a_wedge():
    scene = scene_of({"spectrum": LINES})
    heights, wanted = wedge(scene), behind_wedge(scene)
    light = BeamPlan(scene, (16, 16), dtype=torch.float64).trace(tensors(heights))
    assert light.flux.sum(0).numpy() == pytest.approx(wanted, abs=1e-12)
    assert light.account.on_screen == pytest.approx(wanted.sum(), abs=1e-12)
    by_cells = finished(imaging(scene, heights)).irradiance * scene.receiver.pixel_measure
    assert by_cells.sum(0) == pytest.approx(wanted, abs=1e-5)
    check = validate(scene, by_cells, heights, rays=160_000, accuracy=1e-3)
    assert check.account.on_screen == pytest.approx(wanted.sum(), abs=1e-4)
    assert check.by_cells.difference_over_noise < 1.2
    assert check.rays < 170_000  # of all lines together


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
def test_an_image_is_the_sum_of_those_of_its_lines(light):
    """Also of a train, whose fixed lens has a glass of its own; and of rays through a filter."""
    behind = {"kind": "lens", "name": "field", "position": [0, 0, 12], "half_width": [9, 9]}
    behind |= {"material": "N-BK7", "thickness": 2}
    behind["faces"] = [{"shape": "conic", "radius": 80}, {"shape": "plane"}]
    white = scene_of(light | {"spectrum": LINES}, [behind])
    heights = tensors(wedge(white))
    makers = [lambda scene: BeamPlan(scene, Corners(20, 20, 4), dtype=torch.float64)]
    if light["kind"] != "area":
        makers.append(lambda scene: Plan(scene, dtype=torch.float64))
    for make in makers:
        found, total, lost, key = make(white).trace(heights), 0.0, 0.0, "fresnel_exit@field"
        for wavelength, part in LINES:
            one = make(scene_of(light | {"wavelength_um": wavelength}, [behind])).trace(heights)
            total, lost = total + part * one.flux, lost + part * one.account.lost[key]
        assert (found.flux - total).abs().max() < 1e-12 * total.max()
        assert found.account.lost[key] == pytest.approx(lost, abs=1e-12)


def test_the_gradient_of_white_light_is_that_of_central_differences(rng):
    scene = scene_of({"spectrum": LINES})
    plan = BeamPlan(scene, (24, 24), dtype=torch.float64)
    wanted = torch.as_tensor(rng.random((24, 80)))
    heights = torch.as_tensor(wedge(scene)["lens.back"] + 0.02 * rng.random((8, 8)))

    def figure(heights):
        return (plan.trace({"lens.back": heights}).flux * wanted).sum()

    leaf = heights.clone().requires_grad_()
    (gradient,) = torch.autograd.grad(figure(leaf), leaf)
    way, step = torch.as_tensor(rng.standard_normal((8, 8))), 1e-6
    change = (figure(heights + step * way) - figure(heights - step * way)) / (2 * step)
    assert float((gradient * way).sum()) == pytest.approx(float(change), rel=1e-4)


def test_a_design_for_white_light_is_better_in_it_than_one_for_its_mean_wavelength():
    lens = {"half_width": [3, 3], "position": [15, 0, FAR], "pixels": [32, 32]}
    white = scene_of({"spectrum": LINES}, **lens)
    errors = []
    for light in ({"spectrum": LINES}, {"wavelength_um": white.source.wavelength}):
        run = DesignRun(begin(scene_of(light, **lens), "."))
        for _ in run:
            pass
        heights = run.session.result.state.heights
        found = validate(white, run.session.target, heights, rays=100_000, accuracy=1e-3)
        errors.append(found.verified.relative_l2_corrected)
    assert errors[0] < 0.9 * errors[1]


def test_a_photo_shows_the_lines_of_the_spectrum_in_their_colours_and_places():
    scene = scene_of({"spectrum": [[0.45, 1], [0.63, 1]]}, position=[15.5, 0, FAR])
    photo = photograph(scene, np.ones((24, 80)), wedge(scene))
    assert photo.wavelengths_um == (0.45, 0.63)
    red, _, blue = photo.rgb.sum(axis=0).T
    columns = np.arange(80)
    apart = np.average(columns, weights=blue) - np.average(columns, weights=red.clip(0))
    assert 5 < apart < 12  # the pixels are 0.1 wide, and blue is bent more by 0.8


def test_an_error_of_the_index_leaves_the_dispersion():
    scene = scene_of({"spectrum": LINES})
    off, _ = Perturbation(index=0.01).applied(scene, wedge(scene))
    indices = [[line.scene.optic.index for line in each.lines] for each in (scene, off)]
    assert np.subtract(*indices) == pytest.approx([-0.01] * 3, abs=1e-12)
