"""Photometric files as other programs write them, by the public descriptions of the formats."""

from collections.abc import Sequence

import numpy as np

GAMMA = np.linspace(0.0, 90.0, 19)


def candela(c: np.ndarray, gamma: np.ndarray) -> np.ndarray:
    """Something without any symmetry, shape (n_c, n_g)."""
    c, gamma = np.radians(c)[:, None], np.radians(gamma)
    uneven = 0.3 * np.sin(c) * np.sin(gamma) + 0.2 * np.cos(2 * c + 1) * np.sin(gamma)
    return np.asarray(1000 * np.cos(gamma) * (1 + uneven))


def words(values: Sequence[float] | np.ndarray) -> str:
    return " ".join(f"{value:.10g}" for value in values)


def ies(
    c: Sequence[float] | np.ndarray,
    gamma: Sequence[float] | np.ndarray,
    values: np.ndarray,
    version: str = "IESNA:LM-63-2002",
    tilt: str = "TILT=NONE",
    multiplier: float = 1.0,
    ballast: float = 1.0,
    kind: int = 1,
    keywords: str = "[TEST] 1\n[MANUFAC] nobody",
) -> str:
    head = f"1 1000 {multiplier} {len(gamma)} {len(c)} {kind} 2 0 0 0"
    planes = "\n".join(words(row) for row in values)
    first = f"{version}\n" if version else ""
    return (
        f"{first}{keywords}\n{tilt}\n{head}\n{ballast} 1 10\n{words(gamma)}\n{words(c)}\n{planes}\n"
    )


def ldt(
    symmetry: int,
    c: Sequence[float] | np.ndarray,
    gamma: Sequence[float] | np.ndarray,
    values: np.ndarray,
    lumens: float = 1000.0,
    factor: float = 1.0,
) -> str:
    n_c, n_gamma = len(c), len(gamma)
    head = ["nobody", 1, symmetry, n_c, 360 / n_c, n_gamma, gamma[1] - gamma[0]]
    names = ["report", "a lamp", "", "lamp.ldt", "today"]
    sizes = [100, 0, 50, 100, 0, 0, 0, 0, 0]
    rest = [100, 100, factor, 0, 1]
    lamps = [1, "LED", lumens, "3000", "1B", 10]
    lines = [*head, *names, *sizes, *rest, *lamps, *[0.5] * 10, *c, *gamma, *values.ravel()]
    return (
        "\r\n".join(f"{line:.10g}" if isinstance(line, float) else str(line) for line in lines)
        + "\r\n"
    )
