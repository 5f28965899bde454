"""The torch reference on a graphics card: the same light, from tensors that are all there."""

import numpy as np
import pytest
import torch

from resources import path
from tests.graphics_card import EXAMPLES, NEEDED, computed_on
from tests.optics.cells_of_light import nodes_of, splits
from workbench.design.bounds import Bounds
from workbench.design.net import definite
from workbench.files.session import open_design
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.images.beams import reference_beam_image, reference_box_image
from workbench.optics.plan import Plan
from workbench.optics.samples import Corners


@pytest.mark.parametrize(
    "image", [reference_beam_image, reference_box_image], ids=["beams", "boxes"]
)
def test_images_are_made_of_tensors_where_the_rays_are(image):
    column, row = np.meshgrid(np.linspace(0.5, 3.5, 6), np.linspace(0.2, 2.8, 5))
    nodes = nodes_of(column, row).requires_grad_()
    true, _ = image(nodes, (4, 3), splits((5, 6)))
    # Tensors of no named device are now on another one, and torch does not mix them.
    with torch.device("meta"):
        found, _ = image(nodes, (4, 3), splits((5, 6)))
    assert torch.equal(found, true)


@NEEDED
@pytest.mark.parametrize("way", ["rays", "beams"])
@pytest.mark.parametrize("name", [*EXAMPLES, "flame-grid"])
def test_a_gpu_traces_what_the_processor_does(name, way):
    task = open_design(path("examples", f"{name}.json"))
    scene, rng = definite(task.scene, task.target), np.random.default_rng(1)
    begin = Bounds(scene, task.target).begin
    heights = {face: z + 2e-3 * rng.uniform(-1, 1, z.shape) for face, z in begin.items()}
    weights = rng.uniform(0, 1, scene.receiver.pixels[::-1])

    def seen(device, lens):
        there = computed_on(device, scene)
        if way == "rays":
            plan = Plan(there, dtype=torch.float64, fused=False)
        else:
            cells = Corners(48, 48, 16 if scene.source.continuous else 1)
            plan = BeamPlan(there, cells, dtype=torch.float64, fused=False)
        leaves = {
            face: torch.tensor(z, device=device, requires_grad=True) for face, z in lens.items()
        }
        flux = plan.trace(leaves).flux
        (flux * torch.tensor(weights, device=device)).sum().backward()
        gradients = [each.grad.cpu().numpy().ravel() for each in leaves.values()]
        return flux.detach().cpu().numpy(), np.concatenate(gradients)

    image, gradient = seen("cpu", heights)
    there_image, there_gradient = seen("cuda", heights)
    assert image.sum() > 0.01
    assert np.abs(there_image - image).sum() < 1e-12
    bound = 1e-6 * np.linalg.norm(gradient)
    if name == "flame-grid":
        # Gradients of narrow triangles are differences of great numbers. Of a million beams through
        # a rough lens, rounding of its heights changes them by 8e-5, on the processor alone.
        ulp = np.finfo(np.float64).eps
        near = {face: z * (1 + ulp * rng.integers(-1, 2, z.shape)) for face, z in heights.items()}
        bound += np.linalg.norm(seen("cpu", near)[1] - gradient)
    assert np.linalg.norm(there_gradient - gradient) < bound
