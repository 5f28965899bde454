import ctypes
import subprocess
import sys
from pathlib import Path

import pytest

from workbench import system_memory
from workbench.system_memory import as_bytes, available_memory, release_freed_memory


def test_memory_is_known_with_and_without_the_kernels_account(monkeypatch, tmp_path):
    assert 1e8 < available_memory() < 1e15
    monkeypatch.setattr(system_memory, "Path", lambda _: tmp_path / "none")
    assert 1e8 < available_memory() < 1e15
    monkeypatch.delattr(system_memory.os, "sysconf")
    assert available_memory() == 4 << 30


@pytest.mark.parametrize(
    ("count", "text"),
    [
        (0, "0 B"),
        (999, "999 B"),
        (1000, "1 kB"),
        (6_345_216, "6.35 MB"),
        (537_133_056, "537 MB"),
        (999_600_000, "1 GB"),
        (35_184_439_197_696, "35.2 TB"),
        (3.5e16, "3.5e+04 TB"),
    ],
)
def test_bytes_are_written_with_three_digits(count, text):
    assert as_bytes(count) == text


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


_PAGES = """
import ctypes, resource, sys
import numpy as np
from workbench.system_memory import keep_freed_memory
if sys.argv[1] == "kept":
    keep_freed_memory()
def faults():
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt
for size in (2_000_000, 3_000_000):  # bytes of what is made and freed together
    arrays = [np.ones(size // 8) for _ in range(12)]
    del arrays
before = faults()
for _ in range(10):
    arrays = [np.ones(2_000_000 // 8) for _ in range(12)]
    del arrays
print(faults() - before)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="needs the account of Linux's kernel")
def test_memory_that_is_kept_is_used_again_without_new_pages():
    kept, given_back = (
        int(subprocess.run([sys.executable, "-c", _PAGES, how], capture_output=True).stdout)
        for how in ("kept", "given back")
    )
    assert kept < 100
    assert given_back > 10 * kept
