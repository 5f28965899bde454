import numpy as np
import pytest

from workbench.analysis.benchmark import frontier
from workbench.analysis.benchmark.frontier import Course, Effort, courses, table
from workbench.analysis.benchmark.methods import METHODS
from workbench.analysis.validation import validate
from workbench.errors import RunFailed


@pytest.fixture
def effort(make_example):
    return Effort((make_example(),), iterations=4, rays=4000, final_rays=9000, step=1.01)


@pytest.fixture
def scripted(monkeypatch, make_example):
    """Methods whose lenses and times are known: ``scripted({"slow": [(t, waviness), ...]})``."""
    example = make_example()
    rise = np.outer(np.cos(np.linspace(0, 3, 12)), np.cos(np.linspace(0, 3, 10)))

    def lens(waviness):
        return 0.5 + waviness * rise

    def put(scripts):
        methods = {
            name: lambda example, iterations, script=script: (
                (seconds, lens(waviness)) for seconds, waviness in script
            )
            for name, script in scripts.items()
        }
        monkeypatch.setattr(frontier, "METHODS", methods)
        effort = Effort((example,), None, rays=4000, final_rays=9000, step=2.0)
        return effort, lambda waviness, rays: validate(
            example.scene, example.target, {"exit": lens(waviness)}, rays
        )

    return put


def test_errors_are_those_of_the_independent_check(scripted, told):
    script = [(0.01, 0.0), (0.02, 0.3), (0.3, 0.02), (0.4, 0.3), (0.9, 0.04), (1.0, 0.05)]
    effort, verified = scripted({"one": script})
    (course,) = courses(effort, told)
    # From 0.05 s on in steps of two, and the last one.
    assert course.times == (0.01, 0.3, 0.9, 1.0)
    errors = [verified(waviness, 4000).relative_l2 for waviness in (0.0, 0.02, 0.04, 0.05)]
    assert course.errors == tuple(errors)
    last = verified(0.05, 9000)
    assert (course.error, course.noise) == (last.relative_l2, last.noise)
    assert course.efficiency == last.efficiency
    assert course.seconds == 1.0 and course.memory > 0 and course.failure == ""
    assert course.sooner == 1.0
    assert told.lines[-1] == ("small, one", "verifying 4 of 4")


def test_speed_up_counts_from_the_slowest_method(scripted, told):
    slow = [(1.0, 0.02), (8.0, 0.0)]
    fast = [(0.5, 0.02), (1.0, 0.0), (2.0, 0.001)]
    never = [(0.5, 0.02)]
    effort, verified = scripted({"slow": slow, "fast": fast, "never": never})
    assert verified(0.0, 4000).relative_l2 < verified(0.02, 4000).relative_l2
    assert [course.sooner for course in courses(effort, told)] == [1.0, 8.0, None]


def test_every_method_runs_and_gets_better(effort, told):
    found = list(courses(effort, told))
    assert [course.method for course in found] == list(METHODS)
    assert found[0].method == "paper on torch"
    for course in found:
        assert course.failure == ""
        assert list(course.times) == sorted(course.times)
        if len(course.errors) > 1:
            assert course.errors[-1] < course.errors[0]
        assert course.times[-1] == course.seconds


def test_a_failed_method_is_reported_and_the_others_run(scripted, told, monkeypatch):
    effort, _ = scripted({"fine": [(1.0, 0.0)]})

    def dark(example, iterations):
        yield 0.1, np.full(example.scene.lens.control_points, 0.5)
        raise RunFailed("no light")

    methods = {"first": dark, **frontier.METHODS}
    monkeypatch.setattr(frontier, "METHODS", methods)
    failed, fine = courses(effort, told)
    assert failed.failure == "no light"
    assert failed.error is None and failed.sooner is None
    assert fine.failure == "" and fine.error > 0 and fine.sooner is None


def test_table_agrees_with_the_courses():
    course = Course("flame", "auto", (0.1, 1.0), (0.5, 0.25), 1.0, 0.125, 0.001, 0.9, 2_000_000)
    made = table([course])
    (data,) = made.to_data()
    assert data["curve"] == [(0.1, 0.5), (1.0, 0.25)]
    assert data["megabytes"] == 2.0 and data["sooner"] is None
    row = made.to_markdown().splitlines()[4]
    assert row == "| flame | auto | 12.50% | 0.10% | 90.0% | 1.0 | – | 2 |  |"


def test_time_to_an_error():
    course = Course("flame", "auto", (0.1, 1.0, 2.0), (0.5, 0.25, 0.3))
    assert course.time_to(0.25) == 1.0
    assert course.time_to(0.6) == 0.1
    assert course.time_to(0.2) is None


@pytest.mark.parametrize("make", [frontier.quick, frontier.frontier])
def test_an_effort_limits_iterations_and_has_scenes(make):
    assert make(7).iterations == 7
    scenes = [example.name for example in make(None).examples]
    assert len(set(scenes)) == len(scenes) >= 2
