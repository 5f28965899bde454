"""How much there is to optimise in the paper's method, known before any of it is built.

Here is arithmetic alone, quick to import; `workbench.design.networks` builds the networks.
"""

import math
import os
from pathlib import Path

from workbench.errors import Refused
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.scene import Scene

# A parameter, its gradient and Adam's two moments.
_COPIES = 4

# Where the system does not say how much memory is there: what any desktop has.
_USUAL_MEMORY = 4 << 30


def parameter_count(scene: Scene) -> int:
    """How many numbers a run optimises.

    Networks have three layers of as many neurons as there are control heights. The first hangs
    on the input 1; the two others are linked to the layer before, fully or within the
    neighbourhood. Every link has a weight and every neuron a bias.
    """
    return sum(_parameters_of_face(scene, net) for net in freeform_nets(scene.optic).values())


def _parameters_of_face(scene: Scene, net: ControlNet) -> int:
    neurons = math.prod(net.shape)
    match scene.run.parametrisation:
        case "sparse":
            links = link_count(net)
        case "dense":
            links = neurons**2
        case _:
            return neurons
    return 2 * neurons + 2 * (links + neurons)


def link_count(net: ControlNet) -> int:
    """Links into a layer whose neurons see (2p + 1) × (2q + 1) neighbours, less at the border."""
    return math.prod(
        n * (2 * p + 1) - p * (p + 1) for n, p in zip(net.shape, net.degree, strict=True)
    )


def memory_bytes(scene: Scene) -> int:
    """Memory of all parameters with their gradients and both of Adam's moments."""
    bytes_each = 8 if scene.run.parametrisation == "none" else 4
    return parameter_count(scene) * bytes_each * _COPIES


def check_memory(scene: Scene) -> None:
    """Refuse what would not fit, before it is built.

    Raises
    ------
    Refused
        With the memory that is needed and that is there.
    """
    needed, available = memory_bytes(scene), available_memory(scene.run.device)
    if needed > available:
        raise Refused(
            "run.parametrisation",
            f"{scene.run.parametrisation!r} has {parameter_count(scene):,} parameters here and "
            f"needs {as_bytes(needed)} for them, their gradient and Adam's moments; "
            f"{as_bytes(available)} are free",
        )


def available_memory(device: str = "cpu") -> int:
    """Bytes that a device could still give; a guess where its system does not say."""
    if device == "cuda":
        import torch

        return torch.cuda.mem_get_info()[0]
    # The pages that sysconf calls free leave out the file cache, which gives way when asked.
    account = Path("/proc/meminfo")
    if account.exists():
        sizes = dict(line.split(":", 1) for line in account.read_text("ascii").splitlines())
        return int(sizes["MemAvailable"].split()[0]) * 1024
    if hasattr(os, "sysconf"):
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return _USUAL_MEMORY


def as_bytes(count: float) -> str:
    """A number of bytes for people: three digits and a decimal prefix."""
    for unit in ("B", "kB", "MB", "GB"):
        if count < 999.5:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} TB"
