"""The machine of a benchmark, and designs in fresh processes on it."""

import os
import platform
import subprocess
import sys
import time
from contextlib import suppress
from dataclasses import asdict, dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import torch

from workbench.analysis.benchmark.examples import BenchmarkTask
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


class FreshRun(NamedTuple):
    """Time and memory of fresh processes."""

    seconds: float  # median from start to end of a process
    memory: int | None  # peak of the largest process, bytes; None if unknown


def fresh_design(example: BenchmarkTask, iterations: int, times: int) -> FreshRun:
    """Design an example from the command line ``times`` times; raise RunFailed if one fails."""
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
        scene.with_name("errors.txt").open("w+b") as errors,
        subprocess.Popen(
            [*command, "--iterations", str(iterations)], stdout=subprocess.DEVNULL, stderr=errors
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
        errors.seek(0)
        lines = errors.read().decode(errors="replace").strip().splitlines()
    if process.returncode != 0:
        raise RunFailed(lines[-1] if lines else f"exit status {process.returncode}")
    return FreshRun(seconds, memory)
