"""Parts of the work: all of it, once, and no failure is lost."""

import itertools
import threading

import pytest
import torch

from workbench.optics.kernels import threads


@pytest.mark.parametrize("items", [0, 1, 7, 512])
@pytest.mark.parametrize("parts", [1, 2, 3, 16])
def test_parts_cover_everything_once_and_evenly(items, parts):
    ends = threads.bounds(items, parts)
    assert ends[0] == 0
    assert ends[-1] == items
    sizes = [b - a for a, b in itertools.pairwise(ends)]
    assert len(sizes) == parts
    assert max(sizes) - min(sizes) <= 1


def test_few_rays_are_left_to_one_thread():
    assert threads.parts(1) == 1
    assert threads.parts(10**9) > 1
    assert threads.workers(1) == 1


def test_parts_do_not_depend_on_the_number_of_threads(three_threads, monkeypatch):
    """Their sums would be rounded otherwise: the same task would have another lens."""
    with_three = threads.parts(50_000), threads.parts(10**9), threads.images(100)
    monkeypatch.setattr(torch, "get_num_threads", lambda: 1)
    assert (threads.parts(50_000), threads.parts(10**9), threads.images(100)) == with_three


def test_large_images_have_fewer_parts():
    assert threads.images(4096 * 4096) == 2 < threads.images(256 * 256)


@pytest.mark.parametrize("lines", [1, 2, 100])
def test_parts_of_lines_have_each_of_them_once(lines):
    found = []
    threads.run_lines(lambda begin, end: found.extend(range(begin, end)), lines, 10**6)
    assert sorted(found) == [*range(lines)]


@pytest.fixture
def three_threads(monkeypatch):
    monkeypatch.setattr(torch, "get_num_threads", lambda: 3)


def test_as_many_parts_as_threads_run_at_the_same_time(three_threads):
    meet = threading.Barrier(3, timeout=30)
    done = []

    def work(part):
        meet.wait()
        done.append(part)

    threads.run(work, 3)
    assert sorted(done) == [0, 1, 2]


def test_a_part_that_takes_long_leaves_the_others_to_other_threads(three_threads):
    others = threading.Semaphore(0)

    def work(part):
        if part == 0:
            assert all(others.acquire(timeout=30) for _ in range(7))
        else:
            others.release()

    threads.run(work, 8)


def test_a_thread_that_has_other_work_is_not_waited_for():
    busy, free = threading.Event(), threading.Event()
    done = []

    def hold(part):
        busy.set()
        assert free.wait(timeout=30)

    other = threading.Thread(target=threads.run, args=(hold, torch.get_num_threads()))
    other.start()
    assert busy.wait(timeout=30)
    threads.run(done.append, 4)
    free.set()
    other.join()
    assert sorted(done) == [0, 1, 2, 3]


@pytest.mark.parametrize("failing", [0, 1])
def test_a_failure_in_any_part_is_raised_after_those_at_work_have_ended(failing, three_threads):
    meet = threading.Barrier(2, timeout=30)
    done = []

    def work(part):
        meet.wait()
        if part == failing:
            raise ZeroDivisionError
        done.append(part)

    with pytest.raises(ZeroDivisionError):
        threads.run(work, 2)
    assert done == [1 - failing]
