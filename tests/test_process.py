import ctypes
import sys
from pathlib import Path

import pytest

from workbench.process import release_freed_memory


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
