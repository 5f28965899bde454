"""How threads of numerical libraries behave, said before these are loaded."""

import os


def usable_threads() -> int:
    """How many threads work at most: those of ``OMP_NUM_THREADS``, or the cores of this process."""
    given = os.environ.get("OMP_NUM_THREADS", "").partition(",")[0].strip()
    return int(given) if given.isdecimal() and int(given) else _cores()


def _cores() -> int:
    if hasattr(os, "sched_getaffinity"):  # which Linux alone has
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def calm_library_threads() -> None:
    """Let threads of libraries that wait sleep, and have small matrices done by one thread.

    Spinning, they take the cores from threads that trace. OpenBLAS, which numpy and scipy bring,
    has further threads spin while they wait: with a top hat of 256 × 256 pixels 1.3 of 9.3 s of the
    processor, with a flame 1.8 of 16, where others worked on the same cores. Its largest
    matrices are those of a first lens, of as many rows as there are control points along an axis.
    """
    if threads := os.environ.get("NUMBA_NUM_THREADS"):  # who limits these limits the program
        os.environ.setdefault("OMP_NUM_THREADS", threads)
    os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
