"""How much there is to optimise in the paper's method, known before any of it is built.

Here is arithmetic alone, quick to import; `workbench.design.paper` builds the networks.
"""

import math

from workbench.errors import Refused
from workbench.geometry.surface import ControlNet, nets_of
from workbench.messages import Message
from workbench.process import as_bytes, available_memory
from workbench.scene import Scene

# A parameter, its gradient and Adam's two moments.
_COPIES = 4


def parameter_count(scene: Scene) -> int:
    """How many numbers a run optimises.

    Networks have three layers of as many neurons as there are control heights. The first hangs
    on the input 1; the two others are linked to the layer before, fully or within the
    neighbourhood. Every link has a weight and every neuron a bias.
    """
    return sum(_parameters_of_face(scene, net) for net in nets_of(scene).values())


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

    Raises `Refused` with the memory that is needed and that is there.
    """
    needed, available = memory_bytes(scene), available_memory(scene.run.device)
    if needed > available:
        raise Refused(
            "run.parametrisation",
            Message(
                "'{name}' has {count:,} parameters here and needs {needed} for them, their "
                "gradient and Adam's moments; {available} are free",
                name=scene.run.parametrisation,
                count=parameter_count(scene),
                needed=as_bytes(needed),
                available=as_bytes(available),
            ),
        )
