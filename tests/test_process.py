import ctypes
import os
import sys
from pathlib import Path

import pytest

from workbench.process import calm_library_threads, release_freed_memory, usable_threads


def resident():
    """Bytes of this process that are in memory."""
    text = Path("/proc/self/status").read_text("ascii")
    return 1024 * int(text.split("VmRSS:")[1].split()[0])


@pytest.mark.skipif(sys.platform != "linux", reason="needs the account of Linux's kernel")
def test_freed_pieces_between_others_are_given_back():
    libc, size, count = ctypes.CDLL(None), 100_000, 2000  # below what is mapped by itself
    libc.malloc.restype, libc.malloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t]
    libc.free.argtypes = [ctypes.c_void_p]
    pieces = [libc.malloc(size) for _ in range(count)]
    for piece in pieces:
        ctypes.memset(piece, 1, size)
    for piece in pieces[::2]:  # those between stay, so that the heap cannot shrink
        libc.free(piece)
    before = resident()
    release_freed_memory()
    assert before - resident() > 0.8 * size * count / 2
    for piece in pieces[1::2]:
        libc.free(piece)


@pytest.fixture
def own_threads(monkeypatch):
    """No settings of threads in the environment; those that the program makes are put back."""
    for name in ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS", "OMP_WAIT_POLICY", "OPENBLAS_NUM_THREADS"):
        monkeypatch.setenv(name, "1")
        monkeypatch.delenv(name)


@pytest.mark.usefixtures("own_threads")
def test_settings_of_the_user_stay(monkeypatch):
    monkeypatch.setenv("OMP_WAIT_POLICY", "ACTIVE")
    calm_library_threads()
    assert os.environ["OMP_WAIT_POLICY"] == "ACTIVE"
    assert os.environ["OPENBLAS_NUM_THREADS"] == "1"


@pytest.mark.usefixtures("own_threads")
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
