"""Counts, memory and steps, known before anything is built."""

import math

import pytest

from workbench.design import parametrisation
from workbench.design.parametrisation import (
    check_memory,
    link_count,
    memory_bytes,
    parameter_count,
)
from workbench.design.run import run
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.scene import PaperRun, Scene
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


def test_without_a_network_every_height_is_one_parameter(paper_scene, make_scene):
    assert parameter_count(paper_scene("none")) == 64 * 64
    assert memory_bytes(paper_scene("none")) == 64 * 64 * 8 * 4
    assert parameter_count(make_scene({"run": {"method": "auto"}})) == 12 * 10


def test_a_dense_net_of_64_by_64_has_some_33_million_parameters(paper_scene):
    assert parameter_count(paper_scene("dense")) == 2 * 4096**2 + 4 * 4096 == 33_570_816
    assert memory_bytes(paper_scene("dense")) == 33_570_816 * 4 * 4


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


def test_the_size_of_the_largest_net_is_known_without_building_it(paper_scene):
    scene = paper_scene("dense", (1024, 1024))
    assert parameter_count(scene) == 2 * 2**40 + 4 * 2**20
    with pytest.raises(Refused, match=r"'dense' has 2,199,027,449,856 parameters .* 35\.2 TB"):
        check_memory(scene)


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


def test_a_net_that_fits_is_not_refused(paper_scene, monkeypatch):
    scene = paper_scene("sparse")
    monkeypatch.setattr(parametrisation, "available_memory", lambda _: memory_bytes(scene))
    check_memory(scene)


def test_a_learning_rate_left_out_suits_the_parametrisation(paper_scene):
    rates = {kind: paper_scene(kind).run.rate for kind in ("none", "sparse", "dense")}
    assert rates["dense"] < rates["none"]
    assert all(rate > 0 for rate in rates.values())
    assert PaperRun(parametrisation="dense", learning_rate=0.25).rate == 0.25


def test_a_rate_left_out_stays_left_out_in_the_file(paper_scene):
    text = paper_scene("sparse").to_json()
    assert "learning_rate" not in text
    assert Scene.from_json(text).run.learning_rate is None
