"""How threads of numerical libraries behave, said before these are loaded."""

import os


def calm_library_threads() -> None:
    """Let threads of libraries that wait sleep, and have small matrices done by one thread.

    Spinning, they take the cores from threads that trace. OpenBLAS, which numpy and scipy bring,
    has two threads spin for 25 ms after each product: of a design of 256 × 256 pixels that was 0.9
    of 9.3 s of the processor, and 1.8 of 16 where others worked on the same cores. Its largest
    matrices are those of a first lens, of as many rows as there are control points along an axis.
    """
    os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
