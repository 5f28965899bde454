"""Numbers of threads and how they wait, by the environment."""

import os

import pytest

from workbench.library_threads import calm_library_threads, usable_threads


@pytest.fixture(autouse=True)
def environment(monkeypatch):
    """Put back all variables that the program sets."""
    for name in ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS", "OMP_WAIT_POLICY", "OPENBLAS_NUM_THREADS"):
        monkeypatch.setenv(name, "1")
        monkeypatch.delenv(name)


def test_settings_of_the_user_stay(monkeypatch):
    monkeypatch.setenv("OMP_WAIT_POLICY", "ACTIVE")
    calm_library_threads()
    assert os.environ["OMP_WAIT_POLICY"] == "ACTIVE"
    assert os.environ["OPENBLAS_NUM_THREADS"] == "1"


@pytest.mark.parametrize(
    ("given", "threads"),
    [
        ({"OMP_NUM_THREADS": "5", "NUMBA_NUM_THREADS": "3"}, 5),
        ({"NUMBA_NUM_THREADS": "3"}, 3),
        ({}, 7),
        ({"OMP_NUM_THREADS": "many"}, 7),
        ({"OMP_NUM_THREADS": "0"}, 7),
    ],
)
def test_variables_limit_the_threads_and_the_cores_otherwise(monkeypatch, given, threads):
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: set(range(7)), raising=False)
    for name, value in given.items():
        monkeypatch.setenv(name, value)
    calm_library_threads()
    assert usable_threads() == threads
