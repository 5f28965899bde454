"""What a user waits for: ``freeform design`` in a process of its own."""

import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import NamedTuple

from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.analysis.benchmark.machine import peak_memory
from workbench.errors import RunFailed

_POLL = 0.05  # s


class FreshRun(NamedTuple):
    """What processes took."""

    seconds: float  # median time from the start of a process to its end
    memory: int | None  # peak of the largest one, bytes; None where the system does not say


def fresh_design(example: BenchmarkTask, iterations: int, times: int) -> FreshRun:
    """Design an example from the command line, so many times.

    Raises `RunFailed` if a process fails.
    """
    with TemporaryDirectory(prefix="freeform-") as folder:
        scene = example.save(Path(folder))
        found = [_process(scene, iterations) for _ in range(times)]
    peaks = [each.memory for each in found if each.memory is not None]
    return FreshRun(median(each.seconds for each in found), max(peaks, default=None))


def _process(scene: Path, iterations: int) -> FreshRun:
    output = str(scene.with_name("lens.freeform"))
    command = [sys.executable, "-m", "workbench", "design", str(scene), "-o", output]
    memory = None
    begun = time.perf_counter()
    with (
        scene.with_name("said.txt").open("w+b") as said,
        subprocess.Popen(
            [*command, "--iterations", str(iterations)], stdout=subprocess.DEVNULL, stderr=said
        ) as process,
    ):
        try:
            while process.poll() is None:
                memory = peak_memory(process.pid) or memory
                with suppress(subprocess.TimeoutExpired):
                    process.wait(_POLL)
        finally:
            process.terminate()  # if this was interrupted
        seconds = time.perf_counter() - begun
        said.seek(0)
        lines = said.read().decode(errors="replace").strip().splitlines()
    if process.returncode != 0:
        raise RunFailed(lines[-1] if lines else f"exit status {process.returncode}")
    return FreshRun(seconds, memory)
