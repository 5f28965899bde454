"""Designs with a diffuser before the receiver."""

import numpy as np
import pytest
import torch

from tests.diffusers import with_diffuser
from workbench.analysis.metrics import relative_l2
from workbench.analysis.validation import validate
from workbench.design.levels import finest_image
from workbench.design.run import run
from workbench.errors import Refused
from workbench.optics.plan import tensors_of
from workbench.scene import Scene

_SLANTED = {"kind": "collimated", "direction": [0, 30]}
_FAR_FIELD = {"kind": "far_field", "half_angle": [35, 30], "pixels": [35, 30]}


def _lens() -> dict[str, np.ndarray]:
    x = np.linspace(-1, 1, 24)
    return {"lens.back": 4 - 0.8 * (x[:, None] ** 2 + x**2) + 0.2 * x[:, None] ** 3}


@pytest.mark.parametrize(
    "changes",
    [
        {"scatter": {"kind": "lambertian"}},
        {"scatter": {"kind": "gaussian", "sigma": 3}},
        {"scatter": {"kind": "gaussian", "sigma": 15}, "tilt": [12, 0, 0]},
        {"receiver": _FAR_FIELD},
    ],
    ids=["lambertian", "narrow", "tilted", "far field"],
)
def test_the_check_sees_the_image_of_the_design(changes):
    scene, lens = Scene.from_data(with_diffuser(**changes)), _lens()
    target = np.ones(scene.receiver.pixels[::-1])
    seen = finest_image(scene, target, tensors_of(lens, scene)).step(tensors_of(lens, scene)).state
    checked = validate(scene, target, lens, rays=500_000)
    assert sum(seen.account.to_data().values()) == pytest.approx(2, abs=1e-12)  # and emitted
    assert sum(checked.account.to_data().values()) == pytest.approx(2, abs=1e-12)
    for name in ("on_screen", "absorbed_diffuser@film", "missed_diffuser@film"):
        one, other = (found.account.to_data()[name] for found in (seen, checked))
        assert one == pytest.approx(other, abs=2e-3)
    # Scatter of as many rays in as many pixels.
    flux = checked.irradiance * scene.receiver.pixel_measure
    noise = np.sqrt(flux.sum() / 500_000) / np.linalg.norm(flux)
    assert relative_l2(seen.irradiance, checked.irradiance) < 1.3 * noise + 0.01


def test_the_gradient_of_scattered_light_is_that_of_differences(rng):
    data = with_diffuser(transmittance=0.8)
    data["elements"][0]["reflection"] = "none"  # as much light arrives from all lenses
    scene = Scene.from_data(data)
    target = rng.random((40, 40)) + 0.2
    lens = tensors_of(_lens(), scene)
    image = finest_image(scene, target, lens)
    x = np.linspace(-1, 1, 24)
    way = torch.as_tensor(np.cos(2 * x[:, None]) * np.sin(3 * x))

    def error(step: float) -> torch.Tensor:
        found, _ = image.compare({"lens.back": lens["lens.back"] + step * way})
        return found.double().square().sum()

    lens["lens.back"].requires_grad_()
    (gradient,) = torch.autograd.grad(error(0.0), [lens["lens.back"]])
    slope = float((gradient * way).sum())
    with torch.no_grad():
        difference = float(error(4e-4) - error(-4e-4)) / 8e-4
    assert slope == pytest.approx(difference, rel=2e-2)


@pytest.mark.parametrize("kind", ["gaussian", pytest.param("lambertian", marks=pytest.mark.full)])
def test_a_lens_makes_good_what_its_diffuser_blurs(kind):
    scatter = {"kind": "gaussian", "sigma": 10} if kind == "gaussian" else {"kind": "lambertian"}
    data = with_diffuser(scatter, position=[0, 0, 27])
    scene = Scene.from_data(data)
    plain = Scene.from_data({**data, "elements": data["elements"][:1]})
    x = np.arange(40) - 19.5
    target = np.where((np.abs(x[:, None]) < 12) & (np.abs(x) < 12), 1.0, 0.0)
    target[14:26, 17:23] = 0
    errors = []
    for task in (scene, plain):
        *_, last = (snapshot for snapshot in run(task, target) if snapshot.best)
        errors.append(validate(scene, target, last.state.heights, rays=200_000))
        if task is scene:
            seen = relative_l2(last.state.irradiance, target)
    assert errors[0].relative_l2_corrected < 0.93 * errors[1].relative_l2_corrected
    assert seen == pytest.approx(errors[0].relative_l2_corrected, rel=0.03)


def test_the_method_of_the_paper_refuses_a_diffuser():
    scene = Scene.from_data({**with_diffuser(), "run": {"method": "paper", "iterations": 1}})
    with pytest.raises(Refused, match=r"elements\[1\].kind"):
        next(run(scene, np.ones((40, 40))))


def test_a_diffuser_behind_a_lens_in_slanted_light_scatters_about_it():
    data = {**with_diffuser({"kind": "gaussian", "sigma": 4}), "source": _SLANTED}
    data["images"][0]["receiver"]["position"] = [14, 0, 30]
    scene, lens = Scene.from_data(data), _lens()
    seen = finest_image(scene, np.ones((40, 40)), tensors_of(lens, scene))
    image = seen.step(tensors_of(lens, scene)).state.irradiance
    checked = validate(scene, np.ones((40, 40)), lens, rays=500_000).irradiance
    for axis in (0, 1):
        profile, wanted = image.sum(axis), checked.sum(axis)
        assert np.linalg.norm(profile - wanted) < 0.02 * np.linalg.norm(wanted)


def test_a_diffuser_behind_a_fold_mirror_is_lit_from_its_back():
    data = with_diffuser(position=[-30, 0, 24], tilt=[0, 90, 0])
    lens, film = data["elements"]
    fold = {"kind": "mirror", "name": "fold", "position": [0, 0, 24], "tilt": [0, 45, 0]}
    fold |= {"half_width": [25, 25], "face": {"shape": "plane"}}
    receiver = {"position": [-38, 0, 24], "tilt": [0, -90, 0]}
    data["elements"] = [lens, fold, film]
    data["images"][0]["receiver"] |= receiver
    scene, heights = Scene.from_data(data), _lens()
    image = finest_image(scene, np.ones((40, 40)), tensors_of(heights, scene))
    seen = image.step(tensors_of(heights, scene)).state
    checked = validate(scene, np.ones((40, 40)), heights, rays=500_000)
    assert seen.account.efficiency == pytest.approx(checked.efficiency, abs=2e-3)
    for axis in (0, 1):
        profile, wanted = seen.irradiance.sum(axis), checked.irradiance.sum(axis)
        assert np.linalg.norm(profile - wanted) < 0.02 * np.linalg.norm(wanted)
