"""Long work that one does not wait for to its end."""

from threading import Event, current_thread

import numpy as np
import pytest

from workbench.analysis.manufacture import manufacture
from workbench.design.limits import undesigned
from workbench.design.transport import transport_start
from workbench.extended.blur import Blur
from workbench.extended.deblur import spread_light
from workbench.optics.kernels.threads import run as run_parts
from workbench.progress import (
    Interrupted,
    check_given_up,
    check_interruption,
    given_up_when,
    interrupted_when,
)

WORK = {
    "manufacture": lambda scene: manufacture(scene.optic, undesigned(scene.optic)),
    "first design": lambda scene: transport_start(scene, np.eye(16)),
    "light to be blurred": lambda scene: spread_light(np.eye(16), Blur((3.0, 3.0)).spread()),
}


@pytest.fixture
def scene(make_scene):
    return make_scene({"screen.pixels": [16, 16]})


@pytest.mark.parametrize("work", WORK.values(), ids=WORK)
def test_long_work_ends_when_it_is_interrupted(scene, work):
    asked = []

    def second_time():
        asked.append(None)
        return len(asked) == 2

    with pytest.raises(Interrupted), given_up_when(second_time):
        work(scene)
    check_interruption()  # nothing is given up any more


def test_kernels_end_between_two_parts():
    caller, done, ended = current_thread(), [], Event()

    def given_up():
        if len(done) >= 3:
            ended.set()
        return ended.is_set()

    def work(part):
        done.append(part)
        if current_thread() is not caller:  # that one alone is asked; the rest would take all parts
            ended.wait(timeout=10)

    with pytest.raises(Interrupted), given_up_when(given_up):
        run_parts(work, 1000)
    assert 3 <= len(done) < 1000


def test_a_first_lens_is_found_though_its_run_is_to_end(scene):
    with interrupted_when(lambda: True):
        assert WORK["first design"](scene) is not None
        with pytest.raises(Interrupted):
            check_interruption()
        check_given_up()
