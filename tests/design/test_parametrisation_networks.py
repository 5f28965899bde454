"""The networks: which neuron sees which, where they begin, and that they keep to the range."""

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from workbench.design.heights import HeightRange
from workbench.design.loss import paper_loss, share
from workbench.design.networks import LocalLinks, Network, build
from workbench.design.parametrisation import parameter_count
from workbench.design.run import run
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import Plan
from workbench.scene import FlatBase, Lens, PaperRun
from workbench.targets import load_target

NET = ControlNet((9, 7), (3, 2), (1.0, 1.0))
KINDS = ["none", "sparse", "dense"]
STARTS = ["zeros", "uniform", "random"]


@pytest.fixture(scope="module")
def low_lens():
    return Lens(
        half_width=(1.0, 1.0),
        refractive_index=1.5,
        control_points=(9, 7),
        base=FlatBase(height=0.5),
        height_range=(-0.6, 0.3),
        min_thickness=0.05,
    )


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


def lenses(scene, start=None):
    target = load_target(scene, None)
    begun = None if start is None else {"exit": start}
    return [snapshot.state.heights["exit"] for snapshot in run(scene, target, begun)]


@pytest.mark.parametrize("kind", KINDS)
def test_the_number_of_parameters_is_the_predicted_one(make_scene, kind):
    scene = paper(make_scene, parametrisation=kind)
    module = build(ControlNet.of(scene.optic), scene.run)
    assert sum(p.numel() for p in module.parameters()) == parameter_count(scene)
    assert module().shape == (9, 7)


@pytest.mark.parametrize("neuron", [(0, 0), (4, 3), (8, 2), (1, 6)])
def test_a_neuron_reaches_its_neighbourhood_and_no_further(neuron):
    layer = LocalLinks(NET, torch.float64)
    torch.nn.init.uniform_(layer.weight, 1, 2)
    signal = torch.zeros(9, 7, dtype=torch.float64)
    signal[neuron] = 1
    reached = layer(signal.ravel()).view(9, 7).detach().numpy() != 0
    i, j = np.indices((9, 7))
    near = (abs(i - neuron[0]) <= 3) & (abs(j - neuron[1]) <= 2)
    assert (reached == near).all()


def test_a_sparse_layer_is_a_padded_convolution_where_all_weights_are_equal(rng):
    layer = LocalLinks(NET, torch.float64)
    torch.nn.init.constant_(layer.weight, 0.3)
    torch.nn.init.constant_(layer.bias, -0.2)
    signal = torch.as_tensor(rng.normal(size=(9, 7)))
    kernel = torch.full((1, 1, 7, 5), 0.3, dtype=torch.float64)
    expected = torch.nn.functional.conv2d(signal[None, None], kernel, padding=(3, 2))[0, 0] - 0.2
    assert torch.allclose(layer(signal.ravel()).view(9, 7), expected, atol=1e-14)


def test_every_link_has_its_own_weight_and_every_neuron_its_own_bias(rng):
    layer = LocalLinks(NET, torch.float64)
    weights = torch.as_tensor(rng.normal(size=layer.weight.shape))
    bias = torch.as_tensor(rng.normal(size=layer.bias.shape))
    layer.load_state_dict({"weight": weights, "bias": bias})
    matrix = np.zeros((63, 63))
    matrix[layer.target.numpy(), layer.source.numpy()] = weights.numpy()
    assert np.count_nonzero(matrix) == len(weights)
    signal = rng.normal(size=63)
    expected = matrix @ signal + bias.numpy()
    assert layer(torch.as_tensor(signal)).detach().numpy() == pytest.approx(expected, abs=1e-13)


@pytest.mark.parametrize("kind", ["sparse", "dense"])
def test_a_net_is_three_layers_of_tanh_on_the_input_1(kind):
    module = build(NET, PaperRun(parametrisation=kind, start="random"))
    signal = torch.tanh(module.first.weight[:, 0] + module.first.bias)
    expected = module.third(torch.tanh(module.second(signal)))
    assert torch.allclose(module().ravel(), expected, atol=1e-6)


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


@pytest.mark.parametrize(("kind", "inputs"), [("sparse", 49), ("dense", 1200)])
def test_a_random_net_is_drawn_as_torch_does_but_for_the_scale_of_its_output(kind, inputs):
    net = ControlNet((40, 30), (3, 3), (1.0, 1.0))
    *hidden, weight, bias = build(net, PaperRun(parametrisation=kind, start="random")).parameters()
    for parameter, width in zip(hidden, [1, 1, inputs**-0.5, inputs**-0.5], strict=True):
        assert 0.95 * width < parameter.abs().max().item() <= width * (1 + 1e-6)
        assert parameter.std().item() == pytest.approx(width / 3**0.5, rel=0.1)
    assert weight.std().item() == pytest.approx(bias.std().item(), rel=0.1)


@pytest.mark.parametrize("kind", KINDS)
def test_random_lenses_have_the_same_deviation_on_any_network(kind):
    module = build(NET, PaperRun(parametrisation=kind, start="random"))
    assert module().std().item() == pytest.approx(0.01, rel=1e-5)


@pytest.mark.parametrize("kind", ["sparse", "dense"])
def test_a_net_of_zeros_is_optimised_as_if_there_were_none(make_scene, kind):
    alone = lenses(paper(make_scene, parametrisation="none"))
    through = lenses(paper(make_scene, parametrisation=kind))
    assert np.ptp(alone[-1]) > 1e-4
    for one, other in zip(alone, through, strict=True):
        assert other == pytest.approx(one, abs=1e-7)


@pytest.mark.parametrize("kind", ["sparse", "dense"])
def test_only_the_last_biases_of_a_net_of_zeros_get_a_gradient(kind, rng):
    module = build(NET, PaperRun(parametrisation=kind))
    *others, last = module.parameters()
    with torch.no_grad():
        last.copy_(torch.as_tensor(rng.normal(size=63)))  # and so it stays once they have moved
    module().backward(torch.as_tensor(rng.normal(size=(9, 7)), dtype=torch.float32))
    assert (last.grad != 0).all()
    assert all((parameter.grad == 0).all() for parameter in others)


@given(
    kind=st.sampled_from(KINDS),
    seed=st.integers(0, 1000),
    size=st.sampled_from([1e-3, 1.0, 1e4]),
)
def test_no_network_leaves_the_range(low_lens, kind, seed, size):
    free = HeightRange.of(low_lens, ControlNet.of(low_lens))
    module = build(ControlNet.of(low_lens), PaperRun(parametrisation=kind))
    generator = torch.Generator().manual_seed(seed)
    with torch.no_grad():
        for parameter in module.parameters():
            parameter.normal_(0, size, generator=generator)
        heights = free.heights(free.rest + module())["exit"]
    assert (heights >= free.lower).all() and (heights <= free.upper).all()


@pytest.mark.parametrize("kind", ["sparse", "dense"])
@pytest.mark.parametrize("start", STARTS)
def test_every_lens_of_a_run_is_possible(make_scene, kind, start):
    scene = paper(make_scene, parametrisation=kind, start=start, learning_rate=10.0)
    for heights in lenses(scene):
        assert heights.min() >= 0.4 and heights.max() <= 0.6


@pytest.mark.parametrize("kind", ["sparse", "dense"])
def test_the_same_seed_repeats(make_scene, kind):
    def heights(seed):
        return lenses(paper(make_scene, parametrisation=kind, start="random", seed=seed))

    assert all((a == b).all() for a, b in zip(heights(1), heights(1), strict=True))
    assert (heights(1)[0] != heights(2)[0]).any()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("start", STARTS)
def test_a_run_goes_on_from_given_heights(make_scene, rng, kind, start):
    heights = 0.5 + rng.uniform(-0.09, 0.09, (9, 7))
    first, second, *_ = lenses(paper(make_scene, parametrisation=kind, start=start), heights)
    assert first == pytest.approx(heights, abs=1e-12)
    assert 0 < abs(second - heights).max() < 0.03


@pytest.mark.parametrize("kind", ["sparse", "dense"])
def test_the_gradient_is_that_of_central_differences(make_scene, kind):
    scene = paper(make_scene)
    net = ControlNet.of(scene.optic)
    free = HeightRange.of(scene.optic, net)
    plan = Plan(scene, dtype=torch.float64)
    wanted = torch.as_tensor(share(load_target(scene, None)))
    module = Network(net, kind, torch.float64)
    generator = torch.Generator().manual_seed(3)
    with torch.no_grad():
        for parameter in module.parameters():
            parameter.uniform_(-0.1, 0.1, generator=generator)

    def loss():
        return paper_loss(plan.trace(free.heights(free.rest + module())).flux, wanted)

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


@pytest.mark.parametrize("fresh", [False, True])
def test_a_source_with_fresh_rays_draws_them_each_iteration(make_scene, fresh):
    scene = make_scene(
        {
            "source": {"kind": "point", "position": [0, 0, -5], "rays": 2000, "fresh": fresh},
            "run": {"method": "paper", "iterations": 2, "learning_rate": 1e-30},
        }
    )
    images = [snapshot.state.irradiance for snapshot in run(scene, load_target(scene, None))]
    assert all((image != images[0]).any() == fresh for image in images[1:])
