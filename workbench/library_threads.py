"""How threads of numerical libraries behave, said before these are loaded."""

import os


def calm_library_threads() -> None:
    """Let threads of libraries that wait sleep, and have small matrices done by one thread.

    Spinning, they take the cores from threads that trace. OpenBLAS, which numpy and scipy bring,
    has further threads spin while they wait: with a top hat of 256 × 256 pixels 1.3 of 9.3 s of the
    processor, with a flame 1.8 of 16, where others worked on the same cores. Its largest
    matrices are those of a first lens, of as many rows as there are control points along an axis.
    """
    os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
