"""The quasi-Newton method on functions whose minimum is known."""

from itertools import islice, pairwise

import pytest
import torch

from workbench.design.lbfgs import Evaluation, minimise


def objective(function):
    def evaluate(x):
        x = x.detach().requires_grad_()
        value = function(x)
        return Evaluation(value.item(), lambda: torch.autograd.grad(value, x)[0], None)

    return evaluate


def rosenbrock(x):
    return (100 * (x[1:] - x[:-1].square()).square() + (1 - x[:-1]).square()).sum()


def test_the_minimum_of_a_curved_valley_is_found():
    points = list(islice(minimise(objective(rosenbrock), torch.zeros(6).double()), 200))
    assert (points[-1][0] - 1).abs().max() < 1e-6


@pytest.mark.parametrize("scale", [1e-12, 1.0, 1e12])
def test_the_scale_of_the_problem_does_not_matter(scale):
    found = islice(
        minimise(objective(lambda x: scale * rosenbrock(x)), torch.zeros(4).double()), 60
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

    accepted = list(islice(minimise(counted, torch.zeros(6).double()), 20))
    assert len(differentiated) == len(accepted) - 1 < len(evaluated)


def test_no_step_is_longer_than_its_limit():
    points = [
        x for x, _ in islice(minimise(objective(rosenbrock), torch.zeros(6).double(), 0.01), 40)
    ]
    steps = [(later - earlier).abs().max().item() for earlier, later in pairwise(points)]
    assert max(steps) == pytest.approx(0.01)
