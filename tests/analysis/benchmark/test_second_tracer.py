"""The check beside Mitsuba, case by case."""

from itertools import product
from typing import get_args

import pytest

from workbench.analysis.benchmark import second_tracer
from workbench.analysis.benchmark.second_tracer import (
    OUTLINES,
    RECEIVERS,
    SOURCES,
    bent,
    cases,
    comparisons,
    scene_of,
    table,
    train_examples,
    trains,
)
from workbench.geometry.body import check_body
from workbench.scene import Source

pytestmark = pytest.mark.full


def test_every_source_meets_every_receiver_within_every_outline():
    found = list(cases())
    assert len(found) == len(set(found))
    one_face = {case[1:] for case in found if case[0] == "one face"}
    assert one_face == set(product(SOURCES, RECEIVERS, OUTLINES))


def test_every_kind_of_source_is_there():
    kinds = {kind.model_fields["kind"].annotation for kind in get_args(get_args(Source)[0])}
    assert {source["kind"] for source in SOURCES.values()} == {get_args(k)[0] for k in kinds}


@pytest.mark.parametrize("case", list(cases()), ids=", ".join)
def test_the_optic_of_each_case_is_a_body(case):
    scene = scene_of(*case)
    check_body(scene, bent(scene))


def test_both_see_the_same_light(monkeypatch):
    pytest.importorskip("mitsuba")
    monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 96)  # made sooner
    few = [
        ("one face", "photometric file", "far field", "ellipse"),
        ("two faces", "parallel", "upright", "rectangle"),
        ("mirror", "point", "tilted", "ellipse"),
    ]
    monkeypatch.setattr(second_tracer, "cases", lambda: iter(few))
    stated = []
    rows = list(comparisons(lambda case, state: stated.append((case, state)), rays=60_000))
    assert [(row.optic, row.source, row.receiver, row.outline) for row in rows] == few
    for row in rows:
        assert row.deviations < 4 and row.difference < 1.3 * row.noise
        assert row.found.ours.efficiency > 0.01
    assert stated[-1] == (", ".join(few[-1]), "100%")
    assert "| mirror | point | tilted | ellipse | " in table(rows).to_markdown()


def test_trains_are_designed_and_seen_by_both(monkeypatch):
    pytest.importorskip("mitsuba")
    monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 96)  # made sooner
    assert {"dome-cover", "diffuser-lens", "tilted-lens", "white-light"} <= set(train_examples())
    monkeypatch.setattr(second_tracer, "train_examples", lambda: iter(["tilted-lens"]))
    (row,) = trains(lambda case, state: None, iterations=1, rays=60_000)
    assert abs(row.light_deviations) < 4 and row.difference < 1.3 * row.noise
    assert "| tilted-lens (lens) | collimated | plane | rectangle | " in table([row]).to_markdown()
