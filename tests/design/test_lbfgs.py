"""The quasi-Newton method on functions whose minimum is known."""

from itertools import islice, pairwise

import pytest
import torch

from workbench.design.lbfgs import Evaluation, minimise, remembered


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


def test_the_value_never_rises(rng):
    matrix = torch.as_tensor(rng.normal(size=(30, 30)))
    start = torch.as_tensor(rng.normal(size=30))
    found = islice(minimise(objective(lambda x: (matrix @ x).square().sum()), start), 100)
    values = [here.value for _, here in found]
    assert all(later < earlier for earlier, later in pairwise(values))
    assert values[-1] < 1e-6 * values[0]


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


def test_the_search_stops_at_the_minimum():
    at_rest = objective(lambda x: 0 * x.sum() + 3)
    assert len(list(islice(minimise(at_rest, torch.ones(3).double()), 50))) == 1


def test_no_step_is_longer_than_its_limit():
    points = [
        x for x, _ in islice(minimise(objective(rosenbrock), torch.zeros(6).double(), 0.01), 40)
    ]
    steps = [(later - earlier).abs().max().item() for earlier, later in pairwise(points)]
    assert max(steps) == pytest.approx(0.01)


def test_an_eased_descent_is_one_in_other_coordinates(rng):
    way = torch.as_tensor(rng.normal(size=(6, 6)))
    there = minimise(objective(lambda a: rosenbrock(way @ a)), torch.zeros(6).double())
    here = minimise(objective(rosenbrock), torch.zeros(6).double(), eased=(way @ way.T).__matmul__)
    for (amplitudes, _), (x, _) in islice(zip(there, here, strict=True), 12):
        assert torch.allclose(way @ amplitudes, x, rtol=0, atol=1e-9)


def test_as_much_curvature_is_remembered_as_fits_into_some_memory():
    assert [remembered(count) for count in (100, 8_000, 100_000, 1_000_000)] == [150, 150, 62, 20]


def test_more_remembered_steps_go_further_down_where_curvatures_differ(monkeypatch):
    scale = torch.logspace(-2, 0, 60).double()

    def lowest(most):
        monkeypatch.setattr("workbench.design.lbfgs._MOST", most)
        monkeypatch.setattr("workbench.design.lbfgs._FEWEST", 1)
        start = torch.ones(60).double() / scale
        found = islice(minimise(objective(lambda x: (scale * x).square().sum()), start), 80)
        return [here.value for _, here in found][-1]

    assert lowest(150) < 0.1 * lowest(5)
