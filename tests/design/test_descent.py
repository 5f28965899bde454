"""The descent: L-BFGS, and trials whose light does not add up."""

from itertools import islice
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from scipy.fft import dctn

from workbench.design.descent import Descent, Evaluation, descend, minimise
from workbench.design.waves import FaceWaves
from workbench.optics.account import Account, UnbalancedAccount

SHAPE = 16, 12


ALL = Descent(1.0, 0.01, 0.0)


LONG = Descent(1.0, 0.01, 0.0, longest=0.25)


@pytest.fixture
def wanted(rng):
    """A net of long and of short waves."""
    return torch.as_tensor(rng.normal(size=SHAPE))


def _descended(wanted, *descents, left=200):
    """Nets of all steps from zeros to a wanted net, and why they ended."""

    def evaluated(x, nets):
        off = nets["lens.back"] - wanted
        value = off.square().sum() / wanted.square().sum()
        seen = nets["lens.back"].detach().numpy().copy()
        return Evaluation(value.item(), lambda: torch.autograd.grad(value, [x])[0], seen)

    begin = {"lens.back": torch.zeros_like(wanted)}

    def waves_of(descent):
        return FaceWaves(begin, descent.power, (False, False), longest=descent.longest)

    # It costs so much that few steps show whether they gain something.
    image = SimpleNamespace(effort=768**2)
    steps, nets = descend(image, evaluated, begin, waves_of, descents, left), []
    while True:
        try:
            nets.append(next(steps))
        except StopIteration as end:
            return nets, str(end.value)


def _short(net):
    """What a net has of waves that are not among the longest quarter along each axis."""
    amplitudes = dctn(net, norm="ortho")
    amplitudes[:4, :3] = 0.0
    return np.linalg.norm(amplitudes)


def test_long_waves_come_first_then_all(wanted):
    nets, ended = _descended(wanted, LONG, ALL)
    short = [_short(net) for net in nets]
    alone, _ = _descended(wanted, LONG)
    count = len(alone)
    assert max(short[:count]) < 1e-12 < short[count]
    np.testing.assert_allclose(nets[count - 1], alone[-1], atol=1e-12)
    # The next one begins where the first has ended, without a step that changes nothing.
    assert not np.array_equal(nets[count], nets[count - 1])
    assert np.linalg.norm(nets[-1] - wanted.numpy()) < 0.01 * wanted.norm()
    assert ended.startswith("converged")


class _Unbalanced:
    """An objective whose light does not add up beyond some distance, or at some evaluation."""

    def __init__(self, wanted, most=np.inf, at=-1):
        self.wanted, self.most, self.at, self.count, self.refused = wanted, most, at, -1, 0

    def __call__(self, x, nets):
        self.count += 1
        net = nets["lens.back"]
        if self.count == self.at or net.detach().abs().max() > self.most:
            self.refused += 1
            raise UnbalancedAccount(Account(1.2, {"left_side": -0.2}))
        value = (net - self.wanted).square().sum() / self.wanted.square().sum()
        return Evaluation(value.item(), lambda: torch.autograd.grad(value, [x])[0], net.detach())


def _run(wanted, objective, left=40):
    begin = {"lens.back": torch.zeros_like(wanted)}
    waves = FaceWaves(begin, ALL.power, (False, False))
    return list(
        descend(SimpleNamespace(effort=768**2), objective, begin, lambda _: waves, [ALL], left)
    )


def test_a_trial_whose_light_does_not_add_up_makes_its_step_shorter(wanted):
    most = 0.5 * wanted.abs().max().item()
    objective = _Unbalanced(wanted, most)
    nets = _run(wanted, objective)
    assert objective.refused > 0
    assert all(net.abs().max() <= most for net in nets)
    assert (nets[-1] - wanted).norm() < 0.9 * wanted.norm()


def test_a_beginning_whose_light_does_not_add_up_is_a_defect(wanted):
    with pytest.raises(UnbalancedAccount, match="left_side"):
        _run(wanted, _Unbalanced(wanted, at=0))


def objective(function):
    def evaluate(x):
        x = x.detach().requires_grad_()
        value = function(x)
        return Evaluation(value.item(), lambda: torch.autograd.grad(value, x)[0], None)

    return evaluate


def of_one_size(count):
    """Waves of one size, by which a descent is one in the numbers themselves."""
    return FaceWaves({"lens.back": torch.zeros(1, count).double()}, 0.0, (False, False))


def rosenbrock(x):
    return (100 * (x[1:] - x[:-1].square()).square() + (1 - x[:-1]).square()).sum()


def test_the_minimum_of_a_curved_valley_is_found():
    points = list(
        islice(minimise(objective(rosenbrock), torch.zeros(6).double(), of_one_size(6)), 200)
    )
    assert (points[-1][0] - 1).abs().max() < 1e-6


@pytest.mark.parametrize("scale", [1e-12, 1.0, 1e12])
def test_the_scale_of_the_problem_does_not_matter(scale):
    found = islice(
        minimise(
            objective(lambda x: scale * rosenbrock(x)), torch.zeros(4).double(), of_one_size(4)
        ),
        60,
    )
    assert list(found)[-1][1].value < 1e-3 * scale


def test_points_without_a_step_from_them_have_no_gradient():
    evaluate, evaluated, differentiated = objective(rosenbrock), [], []

    def counted(x):
        found = evaluate(x)
        evaluated.append(x)

        def differentiate():
            differentiated.append(x)
            return found.differentiate()

        return Evaluation(found.value, differentiate, None)

    accepted = list(islice(minimise(counted, torch.zeros(6).double(), of_one_size(6)), 20))
    assert len(differentiated) == len(accepted) - 1 < len(evaluated)


@pytest.mark.parametrize("width", [0.1, 1.0, 10.0])
def test_the_minimum_within_ends_fulfils_the_conditions_of_one(width, rng):
    matrix, aim = (torch.as_tensor(rng.normal(size=size)) for size in ((12, 12), 12))
    matrix = matrix @ matrix.T + 0.1 * torch.eye(12)
    low = torch.as_tensor(rng.normal(size=12))
    high = low + width * torch.as_tensor(rng.integers(0, 2, 12))  # locked where both are the same

    def bowl(x):
        return (x - aim) @ matrix @ (x - aim)

    points = list(islice(minimise(objective(bowl), low, of_one_size(12), (low, high)), 100))
    assert all(((low <= x) & (x <= high)).all() for x, _ in points)
    x, gradient = points[-1][0], points[-1][1].gradient
    falls = torch.where(gradient > 0, x > low, x < high)  # towards there it could still fall
    assert (gradient.abs() * falls).max() < 1e-5 * (matrix @ aim).norm()
