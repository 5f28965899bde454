"""Designs one scene and prints its figures: ``python -m tests.benchmarks.measure NAME``.

`tests.benchmarks.record` runs this once a scene, so that each has a process of its own.
"""

import json
import resource
import sys
from itertools import pairwise
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from tests.benchmarks.scenes import write_scene
from workbench import DesignRun, Session, check, load

# With so few rays the longest check, that of two faces near an LED, took 17 s of the processor.
_RAYS, _SEED = 400_000, 1
# A first run of so few iterations loads compiled kernels, or compiles them.
_WARM_UP = 2


def measure(name: str) -> dict[str, Any]:
    """Design a scene and check its lens.

    Parameters
    ----------
    name : str
        One of `tests.benchmarks.scenes.SCENES`.

    Returns
    -------
    dict
        Figures by name, see `tests.benchmarks.record.FIGURES`.
    """
    with TemporaryDirectory(prefix="freeform-") as folder:
        session = load(write_scene(name, Path(folder)))
        _design(session, _WARM_UP)
        lens, steps = _design(session)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        found = check(lens, rays=_RAYS, seed=_SEED).verified
    result = lens.result
    assert result is not None
    return {
        "error": found.relative_l2_corrected,
        "iterations": result.iterations,
        "seconds": result.seconds,
        "step": median(steps),
        "memory": memory,
        "efficiency": found.efficiency,
    }


def _design(session: Session, iterations: int | None = None) -> tuple[Session, list[float]]:
    """Run a design; returns its session, and the seconds of each step."""
    run = DesignRun(session, iterations)
    seconds = [snapshot.seconds for snapshot in run]
    return run.session, [after - before for before, after in pairwise(seconds)]


if __name__ == "__main__":
    print(json.dumps(measure(sys.argv[1])))
