"""How threads of numerical libraries behave."""

import os

from workbench.library_threads import calm_library_threads, usable_threads


def test_thread_settings_of_the_user_stay(monkeypatch):
    monkeypatch.setenv("OMP_WAIT_POLICY", "ACTIVE")
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "2")  # so that it is put back in any case
    monkeypatch.delenv("OPENBLAS_NUM_THREADS")
    calm_library_threads()
    assert os.environ["OMP_WAIT_POLICY"] == "ACTIVE"
    assert os.environ["OPENBLAS_NUM_THREADS"] == "1"


def test_threads_of_numba_limit_all_unless_those_of_openmp_do(monkeypatch):
    monkeypatch.setenv("OMP_NUM_THREADS", "5")
    monkeypatch.setenv("NUMBA_NUM_THREADS", "3")
    calm_library_threads()
    assert usable_threads() == 5
    monkeypatch.delenv("OMP_NUM_THREADS")
    calm_library_threads()
    assert os.environ["OMP_NUM_THREADS"] == "3"
    assert usable_threads() == 3
