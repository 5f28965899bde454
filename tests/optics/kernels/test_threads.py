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
    assert threads.parts(10**9) == torch.get_num_threads()


def test_all_parts_run_and_at_the_same_time():
    meet = threading.Barrier(3, timeout=30)
    done = []

    def work(part):
        meet.wait()
        done.append(part)

    threads.run(work, 3)
    assert sorted(done) == [0, 1, 2]


@pytest.mark.parametrize("failing", [0, 1])
def test_a_failure_in_any_part_is_raised_after_all_have_ended(failing):
    done = []

    def work(part):
        if part == failing:
            raise ZeroDivisionError
        done.append(part)

    with pytest.raises(ZeroDivisionError):
        threads.run(work, 2)
    assert done == [1 - failing]
