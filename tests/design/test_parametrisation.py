"""Networks of the paper that give control heights."""

import math

import pytest
import torch

from workbench.design import net as sizes
from workbench.design.bounds import HeightRange
from workbench.design.limits import HeightLimits
from workbench.design.loss import paper_loss, share
from workbench.design.net import (
    link_count,
    parameter_count,
)
from workbench.design.paper import Network, build
from workbench.design.run import run
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan
from workbench.scene import PaperRun
from workbench.targets import load_target


@pytest.fixture
def paper_scene(make_scene):
    def make(kind, size=(64, 64), degree=(3, 3)):
        return make_scene(
            {
                "lens.control_points": list(size),
                "lens.degree": list(degree),
                "run": {"method": "paper", "parametrisation": kind},
            }
        )

    return make


@pytest.mark.parametrize(
    ("size", "degree"),
    [((64, 64), (3, 3)), ((5, 7), (1, 3)), ((4, 4), (3, 3)), ((3, 9), (2, 5)), ((2, 2), (1, 1))],
)
def test_links_of_the_sparse_net_are_the_pairs_of_neighbours(paper_scene, size, degree):
    scene = paper_scene("sparse", size, degree)
    pairs = math.prod(
        sum(abs(i - j) <= p for i in range(n) for j in range(n))
        for n, p in zip(size, degree, strict=True)
    )
    neurons = math.prod(size)
    assert link_count(ControlNet.of(scene.optic)) == pairs
    assert parameter_count(scene) == 2 * neurons + 2 * (pairs + neurons)


def test_a_net_that_does_not_fit_is_refused_before_it_is_built(paper_scene, monkeypatch):
    monkeypatch.setattr(sizes, "available_memory", lambda _: 6_000_000)
    monkeypatch.setattr("workbench.design.paper.build", lambda *_: pytest.fail("was built"))
    scene = paper_scene("sparse")
    with pytest.raises(Refused) as refused:
        next(run(scene, load_target(scene, None)))
    assert refused.value.path == "run.parametrisation"
    assert refused.value.reason == (
        "'sparse' has 396,576 parameters here and needs 6.35 MB for them, their gradient and "
        "Adam's moments; 6 MB are free"
    )


KINDS = ["none", "sparse", "dense"]


def paper(make_scene, **settings):
    """The small scene under the paper's method."""
    return make_scene(
        {
            "lens.control_points": [9, 7],
            "lens.degree": [3, 2],
            "lens.height_range": [-0.1, 0.1],
            "run": {"method": "paper", "iterations": 3, "learning_rate": 1e-3, **settings},
        }
    )


@pytest.mark.parametrize("kind", KINDS)
def test_the_number_of_parameters_is_the_predicted_one(make_scene, kind):
    scene = paper(make_scene, parametrisation=kind)
    module = build(ControlNet.of(scene.optic), scene.run)
    assert sum(p.numel() for p in module.parameters()) == parameter_count(scene)
    assert module().shape == (9, 7)


@pytest.mark.parametrize("kind", KINDS)
def test_starts_have_the_distributions_of_the_paper(kind):
    size = (40, 30)
    net = ControlNet(size, (3, 3), (1.0, 1.0))

    def parameters(start):
        return list(build(net, PaperRun(parametrisation=kind, start=start)).parameters())

    assert all((p == 0).all() for p in parameters("zeros"))
    for parameter in parameters("uniform"):
        assert 0.95e-4 < parameter.abs().max().item() <= 1e-4
        assert parameter.std().item() == pytest.approx(1e-4 / 3**0.5, rel=0.1)


@pytest.mark.parametrize("kind", ["sparse", "dense"])
def test_the_gradient_is_that_of_central_differences(make_scene, kind):
    scene = paper(make_scene)
    net = ControlNet.of(scene.optic)
    free = HeightRange.within(HeightLimits.of(scene.optic, net))
    plan = Plan(scene, dtype=torch.float64)
    wanted = torch.as_tensor(share(load_target(scene, None)))
    module = Network(net, kind, torch.float64)
    generator = torch.Generator().manual_seed(3)
    with torch.no_grad():
        for parameter in module.parameters():
            parameter.uniform_(-0.1, 0.1, generator=generator)

    def loss():
        return paper_loss(
            plan.trace({"lens.back": free.heights(free.rest + module())}).flux, wanted
        )

    gradients = torch.autograd.grad(loss(), list(module.parameters()))
    for parameter, gradient in zip(module.parameters(), gradients, strict=True):
        along = torch.randn(parameter.shape, generator=generator, dtype=torch.float64)
        along /= along.norm()
        with torch.no_grad():
            parameter += 1e-6 * along
            ahead = loss()
            parameter -= 2e-6 * along
            behind = loss()
            parameter += 1e-6 * along
        difference = float(ahead - behind) / 2e-6
        assert float((gradient * along).sum()) == pytest.approx(difference, rel=1e-4, abs=1e-9)
