"""Counts, memory and steps, known before anything is built."""

import math

import pytest

from workbench.design import parametrisation
from workbench.design.parametrisation import (
    link_count,
    parameter_count,
)
from workbench.design.run import run
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
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
    monkeypatch.setattr(parametrisation, "available_memory", lambda _: 6_000_000)
    monkeypatch.setattr("workbench.design.paper.build", lambda *_: pytest.fail("was built"))
    scene = paper_scene("sparse")
    with pytest.raises(Refused) as refused:
        next(run(scene, load_target(scene, None)))
    assert refused.value.path == "run.parametrisation"
    assert refused.value.reason == (
        "'sparse' has 396,576 parameters here and needs 6.35 MB for them, their gradient and "
        "Adam's moments; 6 MB are free"
    )
