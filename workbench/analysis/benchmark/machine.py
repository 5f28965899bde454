"""The machine of a benchmark, and designs in fresh processes on it."""

import json
import os
import platform
import subprocess
import sys
import time
import zipfile
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np
import torch

from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.arrays import Array
from workbench.errors import RunFailed
from workbench.process import cores

_PACKAGES = ("freeform-lens-workbench", "torch", "numba", "numpy", "scipy")


@dataclass(frozen=True)
class Machine:
    """A machine and the software on it."""

    cpu: str
    cores: int  # usable by this process
    threads: int  # of the tracer
    memory: int | None  # bytes; None if unknown
    gpu: str | None  # the first CUDA device
    system: str  # operating system
    versions: dict[str, str]  # of Python and the main packages

    @classmethod
    def here(cls) -> "Machine":
        """The machine of this process."""
        return cls(
            cpu=_cpu(),
            cores=cores(),
            threads=torch.get_num_threads(),
            memory=_memory(),
            gpu=torch.cuda.get_device_name() if torch.cuda.is_available() else None,
            system=f"{platform.system()} {platform.release()}",
            versions={"python": platform.python_version(), **_versions()},
        )

    def to_data(self) -> dict[str, Any]:
        """The attributes by name, for JSON."""
        return asdict(self)

    def to_markdown(self) -> str:
        """One paragraph."""
        memory = "" if self.memory is None else f", {self.memory / 2**30:.0f} GiB"
        gpu = "no GPU" if self.gpu is None else self.gpu
        versions = ", ".join(f"{name} {number}" for name, number in self.versions.items())
        return (
            f"{self.cpu}, {self.cores} cores{memory}, {gpu}; {self.threads} threads; "
            f"{self.system}; {versions}.\n"
        )


class PeakMemory:
    """Peak memory of this process since the object was made, or since its start."""

    def __init__(self) -> None:
        with suppress(OSError):
            Path("/proc/self/clear_refs").write_text("5", "ascii")

    def bytes(self) -> int | None:
        """Return the peak so far; None if unknown."""
        if found := peak_memory("self"):
            return found
        if sys.platform == "win32":
            return None
        import resource  # not on Windows

        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        return peak if sys.platform == "darwin" else peak * 1024


def peak_memory(process: int | str) -> int | None:
    """Return the peak memory of a process in bytes; None if unknown."""
    with suppress(OSError):
        for line in Path(f"/proc/{process}/status").read_text("utf-8", "replace").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    return None


def _cpu() -> str:
    with suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text("utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def _memory() -> int | None:
    if hasattr(os, "sysconf"):
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return None


def _versions() -> dict[str, str]:
    found = {}
    for package in _PACKAGES:
        with suppress(PackageNotFoundError):
            found[package] = version(package)
    # Its build (CPU or CUDA) is not in the package's metadata.
    return found | {"torch": str(torch.__version__)}


_POLL = 0.05  # s
_SIDE, _TIMES = 1024, 10  # of the transforms that are timed before a design and after it
YARDSTICK = (
    f"A yardstick is the time of a Fourier transform of {_SIDE} × {_SIDE} complex numbers in as "
    "many threads as a design has, measured before and after the command."
)
"""What `yardstick` measures, for the notes of tables."""


class FreshRun(NamedTuple):
    """A design in a fresh process: its cost and its lens."""

    seconds: float  # from start to end of the process
    processor: float | None  # time of all its threads, s; None if unknown
    memory: int | None  # peak, bytes; None if unknown
    yardstick: float  # `yardstick` just before and after, s
    iterations: int
    heights: Array  # (n_u, n_v), control heights of the designed face
    irradiance: Array  # (n_y, n_x), the image as the run sees it

    @property
    def megabytes(self) -> float | None:
        """Peak memory in MB."""
        return None if self.memory is None else self.memory / 1e6

    @property
    def yardsticks(self) -> float:
        """Time as a multiple of the yardstick's: comparable between machines."""
        return self.seconds / self.yardstick


def fresh_design(example: BenchmarkTask, iterations: int | None, times: int) -> FreshRun:
    """Design an example from the command line ``times`` times; raise RunFailed if one fails.

    `iterations`: upper limit; None leaves it to the example. Returns the run of median time, with
    the largest peak of memory.
    """
    with TemporaryDirectory(prefix="freeform-") as folder:
        scene = example.save(Path(folder))
        face = example.scene.optic.designed_face
        found = [_fresh_run(scene, face, iterations) for _ in range(times)]
    peaks = [each.memory for each in found if each.memory is not None]
    middle = sorted(found, key=lambda each: each.seconds)[times // 2]
    return middle._replace(memory=max(peaks, default=None))


def _fresh_run(scene: Path, face: str, iterations: int | None) -> FreshRun:
    output = scene.with_name("lens.freeform")
    command = [sys.executable, "-m", "workbench", "design", str(scene), "-o", str(output), "--json"]
    if iterations is not None:
        command += ["--iterations", str(iterations)]
    before = yardstick()
    used = _processor_of_children()
    begun = time.perf_counter()
    printed, memory = _printed(command, scene.parent)
    seconds = time.perf_counter() - begun
    now_used = _processor_of_children()
    with zipfile.ZipFile(output) as session:
        heights = _array(session, f"faces/{face}.npy")
        irradiance = _array(session, "images/0/irradiance.npy")
    return FreshRun(
        seconds=seconds,
        processor=None if used is None or now_used is None else now_used - used,
        memory=memory,
        yardstick=median((before, yardstick())),
        iterations=json.loads(printed.splitlines()[-1])["iterations"],
        heights=heights,
        irradiance=irradiance,
    )


def _printed(command: Sequence[str], folder: Path) -> tuple[str, int | None]:
    """Run a command; return its standard output and its peak memory in bytes."""
    memory = None
    with (
        (folder / "output.txt").open("w+b") as output,
        (folder / "errors.txt").open("w+b") as errors,
        subprocess.Popen(command, stdout=output, stderr=errors) as process,
    ):
        try:
            while process.poll() is None:
                memory = peak_memory(process.pid) or memory
                with suppress(subprocess.TimeoutExpired):
                    process.wait(_POLL)
        finally:
            process.terminate()  # if this was interrupted
        output.seek(0)
        errors.seek(0)
        lines = errors.read().decode(errors="replace").strip().splitlines()
        if process.returncode != 0:
            raise RunFailed(lines[-1] if lines else f"exit status {process.returncode}")
        return output.read().decode(errors="replace"), memory


def _array(session: zipfile.ZipFile, name: str) -> Array:
    with session.open(name) as entry:
        return np.asarray(np.load(entry, allow_pickle=False))


def yardstick() -> float:
    """Return the time of a fixed task on this machine as it is now, in seconds.

    A design's time over it is comparable between machines. The task repeats: other programs would
    delay a short one less than a design.
    """
    from scipy.fft import fft2  # slow import

    values = np.random.default_rng(0).standard_normal((_SIDE, _SIDE)) + 0j
    begun = time.perf_counter()
    for _ in range(_TIMES):
        fft2(values, workers=torch.get_num_threads())
    return (time.perf_counter() - begun) / _TIMES


def _processor_of_children() -> float | None:
    """Return the processor time of all ended processes that this one started, in seconds."""
    if sys.platform == "win32":
        return None
    import resource  # not on Windows

    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
