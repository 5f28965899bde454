"""Damaged picture files."""

import numpy as np

from workbench.errors import Refused
from workbench.targets.image import read_picture


def check_damaged(whole, path, rng, times, first):
    """Files with three wrong bytes from ``first`` on are read as light, or refused."""
    for _ in range(times):
        damaged = np.frombuffer(whole, np.uint8).copy()
        damaged[rng.integers(first, len(whole), 3)] = rng.integers(0, 256, 3)
        path.write_bytes(damaged.tobytes())
        try:
            light = read_picture(path).light
        except Refused as refused:
            assert refused.path == "target.image"
        else:
            assert np.isfinite(light).all() and light.min() >= 0
