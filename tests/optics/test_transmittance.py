"""Fresnel's equations, Schlick's approximation and constant reflectances, in closed form."""

import math

import numpy as np
import pytest
import torch

from workbench.compiled import jit
from workbench.optics.interfaces import TransmittanceLaw, normal_reflectance
from workbench.optics.kernels.refraction import transmittance, transmittance_slopes

INDICES = [1.0003, 1.5, 3.5]
LAWS = {
    "fresnel": TransmittanceLaw.fresnel,
    "schlick": TransmittanceLaw.schlick,
    "constant": lambda ratio: TransmittanceLaw.constant(ratio, 0.02),
}


def cosines(ratio, angles):
    """Cosines of the angles of incidence and refraction."""
    sine = ratio * np.sin(angles)
    return np.cos(angles), np.sqrt((1 - sine) * (1 + sine))


def angles_of(ratio, count=101):
    """Angles of incidence from the normal to nearly grazing, or nearly critical."""
    return np.linspace(0, math.asin(min(1, 1 / ratio)) - 1e-4, count)


class TestFresnel:
    @pytest.mark.parametrize("index", INDICES)
    def test_normal_incidence(self, index):
        for ratio in (index, 1 / index):
            wanted = 1 - ((index - 1) / (index + 1)) ** 2
            assert TransmittanceLaw.fresnel(ratio).at(1.0, 1.0) == pytest.approx(wanted, rel=1e-14)

    @pytest.mark.parametrize("ratio", [1 / 1.5, 1.5])
    def test_both_polarisations_reflect_what_is_not_refracted(self, ratio):
        cos_in, cos_out = cosines(ratio, angles_of(ratio))
        across = (ratio * cos_in - cos_out) / (ratio * cos_in + cos_out)
        within = (cos_in - ratio * cos_out) / (cos_in + ratio * cos_out)
        refracted = TransmittanceLaw.fresnel(ratio).at(cos_in, cos_out)
        assert refracted + (across**2 + within**2) / 2 == pytest.approx(1, abs=1e-14)


@pytest.mark.parametrize("ratio", [1.5, 1 / 1.5])
def test_schlick_at_its_two_ends(ratio):
    law = TransmittanceLaw.schlick(ratio)
    grazing = (0.0, 0.7) if ratio < 1 else (0.7, 0.0)
    assert [law.at(1.0, 1.0), law.at(*grazing)] == pytest.approx([0.96, 0.0], abs=1e-15)
    assert normal_reflectance(1.5) == pytest.approx(0.04)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("ratio", [1 / 1.5, 1.5, 1.0003])
def test_gradients_are_finite_up_to_the_limit_and_right(law, ratio):
    law = LAWS[law](ratio)
    angles = torch.tensor(angles_of(ratio, 21)[1:-1], requires_grad=True)
    sine = ratio * angles.sin()
    light = law.at(angles.cos(), ((1 - sine) * (1 + sine)).sqrt())
    (gradient,) = torch.autograd.grad(light.sum(), angles)
    step = 1e-6
    there, back = (law.at(*cosines(ratio, angles.detach().numpy() + h)) for h in (step, -step))
    assert gradient.numpy() == pytest.approx((there - back) / (2 * step), rel=1e-5, abs=1e-8)


@jit(error_model="numpy")
def _along(law, cos_in, cos_out, values, slopes):
    for k in range(len(cos_in)):
        values[k] = transmittance(law, cos_in[k], cos_out[k])
        slopes[0, k], slopes[1, k] = transmittance_slopes(law, cos_in[k], cos_out[k])


@pytest.mark.parametrize("kind, close", [(np.float64, 1e-13), (np.float32, 2e-6)])
@pytest.mark.parametrize("ratio", [1 / 1.5, 1.5])
def test_the_kernels_twin_has_the_same_values_and_slopes(kind, close, ratio):
    cos_in, cos_out = cosines(ratio, angles_of(ratio))
    for make in LAWS.values():
        law = make(ratio)
        torn = [torch.tensor(cosine, requires_grad=True) for cosine in (cos_in, cos_out)]
        wanted = law.at(*torn)
        gradients = torch.autograd.grad(wanted.sum(), torn, allow_unused=True)
        values, slopes = np.empty(len(cos_in), kind), np.empty((2, len(cos_in)), kind)
        _along(law.cast(kind), cos_in.astype(kind), cos_out.astype(kind), values, slopes)
        assert values == pytest.approx(wanted.detach().numpy(), abs=close)
        for found, gradient in zip(slopes, gradients, strict=True):
            expected = np.zeros(1) if gradient is None else gradient.numpy()
            assert found == pytest.approx(np.broadcast_to(expected, found.shape), abs=10 * close)
