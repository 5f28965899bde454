"""What was measured on."""

import os
import platform
import sys
from contextlib import suppress
from dataclasses import asdict, dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import torch

_PACKAGES = ("freeform-lens-workbench", "torch", "numba", "numpy", "scipy")


@dataclass(frozen=True)
class Machine:
    """A machine and the software on it."""

    cpu: str  # what the CPU calls itself
    cores: int  # cores that this process may use
    threads: int  # threads that the tracer uses
    memory: int | None  # bytes; None where the system does not say
    gpu: str | None  # the first CUDA device
    system: str  # operating system
    versions: dict[str, str]  # of Python and the packages that matter

    @classmethod
    def here(cls) -> "Machine":
        """The machine of this process."""
        return cls(
            cpu=_cpu(),
            cores=_cores(),
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
    """The most memory that this process has held since this object was made.

    Where the system cannot forget an earlier peak, since the process began.
    """

    def __init__(self) -> None:
        with suppress(OSError):
            Path("/proc/self/clear_refs").write_text("5", "ascii")

    def bytes(self) -> int | None:
        """The peak so far; None where the system does not say."""
        if found := peak_memory("self"):
            return found
        if sys.platform == "win32":
            return None
        import resource  # not there on Windows

        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        return peak if sys.platform == "darwin" else peak * 1024


def peak_memory(process: int | str) -> int | None:
    """The most memory that a process has held, bytes; None where the system does not say."""
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


def _cores() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


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
