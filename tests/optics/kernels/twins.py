"""What comparisons of a fused trace with its twin start from."""

import numpy as np
import torch


def lens(scene, seed, amplitude):
    """Heights that are wild from an amplitude of 0.3 on: folds, total reflection, stray light."""
    noise = np.random.default_rng(seed).normal(size=scene.optic.net_shape)
    return torch.tensor(scene.optic.base.height + amplitude * noise)


def account(light):
    """Where all light went, by name."""
    return light.account.to_data()


def with_gradient(tracer, heights, scene, cotangent):
    """Light, and the gradient of the weighed image; zeros where no light depends on the lens."""
    leaf = heights.clone().requires_grad_()
    light = tracer.image({"lens.back": leaf}, scene.filter)
    if not light.flux.requires_grad:
        return light, torch.zeros_like(heights)
    weighed = (light.flux * cotangent.to(light.flux.dtype)).sum()
    (gradient,) = torch.autograd.grad(weighed, leaf, allow_unused=True)
    return light, torch.zeros_like(heights) if gradient is None else gradient
