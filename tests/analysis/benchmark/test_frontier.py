from dataclasses import replace

import numpy as np
import pytest

from workbench.analysis.benchmark import frontier
from workbench.analysis.benchmark.frontier import METHODS, Effort, MethodLens, courses, verified
from workbench.analysis.benchmark.machine import FreshRun
from workbench.errors import RunFailed


@pytest.fixture
def effort(make_example):
    example = make_example({"source.rays": [48, 48], "screen.pixels": [24, 24]})
    return Effort((example,), tuple(METHODS), iterations=4, step=1.01, processes=1)


@pytest.fixture
def processes(monkeypatch):
    """What is asked of fresh processes, none of which is started."""
    asked = []

    def fresh_design(example, iterations, times):
        asked.append((example.name, iterations, times))
        return FreshRun(7.5, 9.0, 300_000_000, 0.5, iterations, np.zeros((2, 2)), np.ones((2, 2)))

    monkeypatch.setattr(frontier, "fresh_design", fresh_design)
    return asked


@pytest.fixture
def scripted(monkeypatch, make_example):
    """Methods whose lenses and times are known: ``scripted({"slow": [(t, waviness), ...]})``.

    Each lens says that its own error is its waviness.
    """
    example = make_example()
    rise = np.outer(np.cos(np.linspace(0, 3, 12)), np.cos(np.linspace(0, 3, 10)))

    def lens(waviness):
        return 0.5 + waviness * rise

    def put(scripts):
        methods = {
            name: lambda example, iterations, script=script: (
                MethodLens(seconds, lens(waviness), waviness) for seconds, waviness in script
            )
            for name, script in scripts.items()
        }
        monkeypatch.setattr(frontier, "METHODS", methods)
        effort = Effort((example,), tuple(methods), None, step=2.0, processes=1)
        return effort, lambda waviness, accuracy: verified(example, lens(waviness), accuracy)

    return put


def test_errors_are_those_of_the_independent_check(scripted, progress):
    script = [(0.01, 0.0), (0.02, 0.3), (0.3, 0.02), (0.4, 0.3), (0.9, 0.04), (1.0, 0.05)]
    effort, verified = scripted({"one": script})
    (course,) = courses(effort, progress)
    # From 0.05 s on in steps of two, and the last one.
    assert course.times == (0.01, 0.3, 0.9, 1.0)
    last = verified(0.05, 1e-3)
    errors = [verified(waviness, 1e-2).error for waviness in (0.0, 0.02, 0.04)]
    assert course.errors == (*errors, last.error)
    assert (course.error, course.bound, course.efficiency) == last[:3]
    assert 0 < course.bound < 1e-2
    assert course.seconds == 1.0 and course.failure == ""
    assert course.own_curve == tuple(script)
    assert course.own == 0.05 and course.own_over_verified == 0.05 / course.error
    assert course.sooner == 1.0
    assert progress.lines[-1] == ("small, one", "verifying 4 of 4")


def test_every_method_runs_and_gets_better(effort, progress, processes):
    found = list(courses(effort, progress))
    assert [course.method for course in found] == list(METHODS)
    assert found[0].method == "paper on torch"
    for course in found:
        assert course.failure == ""
        assert list(course.times) == sorted(course.times)
        if len(course.errors) > 1:
            assert course.errors[-1] < course.errors[0]
        assert course.times[-1] == course.seconds


def test_a_failed_method_is_reported_and_the_others_run(scripted, progress, monkeypatch):
    effort, _ = scripted({"fine": [(1.0, 0.0)]})

    def dark(example, iterations):
        yield MethodLens(0.1, np.full(example.scene.optic.net_shape, 0.5))
        raise RunFailed("no light")

    methods = {"first": dark, **frontier.METHODS}
    monkeypatch.setattr(frontier, "METHODS", methods)
    effort = replace(effort, methods=tuple(methods))
    failed, fine = courses(effort, progress)
    assert failed.failure == "no light"
    assert failed.error is None and failed.sooner is None
    assert fine.failure == "" and fine.error > 0 and fine.sooner is None
