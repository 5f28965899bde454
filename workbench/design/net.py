"""Sizes of a run: control points that a lens is worth, and parameters of the paper's method.

Finer nets take longer. Of 256 x 256 pixels, a photograph is 1.03 % off with 624 x 624 control
points after 7 s of the processor and 0.98 % with 768 x 768 after 11 s; dots on black are 2.3 % off
with 768 x 768 after 7 s, and 1.9 % with 960 x 960 after 11 s. So 480 is the net for the usual
detail of 256 pixels, up to 960 that for sharp edges, and 1152 for the sharpest. A target is worth
the highest frequency of its detail, and nothing is worth more than the blur that a source of some
size lays over the screen.

Each axis is judged by itself, so that a slim screen, or stripes, get a slim net. A method that nets
of one size suit, as the paper's, gets such a one.
"""

import math

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet, nets_of
from workbench.measured.lamps import of_known_size
from workbench.messages import Message
from workbench.process import as_bytes, available_memory
from workbench.scene import Scene
from workbench.scene.faces import LARGEST_NET

_PER_PIXEL = 1.875
# Parts of that for targets with sharp edges, above all in dark places, and for targets and sources
# with less detail: steps, so that a stroke of a brush in the target seldom changes the net, and
# with it the locks.
_PARTS = (2.4, 2.0, 1.6, 1.3, 1.0, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125)
# Light has to be moved whatever the target shows.
_FEWEST = 96
# Relative L2 error of a target that is left out, and control points per period of the rest: dark
# places take little of the lens, and need as many as bright ones. A blurred photograph of 16
# periods is off by 0.84 % on 96 control points, 0.30 % on 192 and 0.13 % on 384.
_LEFT_OUT, _PER_PERIOD = 2e-3, 16.0
# Where a target has less than the mean irradiance, control points on the screen are farther apart
# by the root of that: what edges there are worth is their second differences over that root, as
# part of the target. Places darker than a tenth of the mean count as such a tenth. A portrait with
# a dark uniform is 2.2 % off on 480 x 480 control points and 1.6 % on 624 x 624; of 21 pictures of
# 256 x 256 pixels, errors on as many control points grow with it, and fall with the power -1.25 of
# control points along an axis.
_DARKEST, _PER_EDGE, _POWER = 0.1, 4.6, 0.8
# More pixels along an axis are averaged before: a photograph of 512 x 512 pixels has less of second
# differences than one of 256 x 256, and is as far off on as many control points for each pixel.
_SEEN = 256
# What edges are worth at most, for the root of the pixels along an axis: time.
_PER_ROOT = 67.0
# Control points per width of the blur that a source lays over the screen: of one that is near, and
# of one that is infinitely far. For the near one finer nets only take time: a torch whose blur is a
# seventeenth of the image is 15.3 % off with 64 x 64 after 37 s, and 18.5 % with 288 x 288 after
# 148 s. The blur of the sun is the same all over the lens, so that one trace stands for all of it,
# and spots and lines much narrower than the blur are what comes nearest to the target: three
# photographs, of which it blurs a forty-fourth, are 10 % above the lower bound with 480 x 480 and
# 7 to 8 % with up to 768 x 768 and longer descents.
_PER_BLUR, _PER_FAR_BLUR = 5.0, 15.0

# A parameter, its gradient and Adam's two moments.
_COPIES = 4


def definite(scene: Scene, target: Array) -> Scene:
    """The scene with a net that is chosen, if the program is to choose it and has not yet.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y. Returns the same object where
    there is nothing to choose.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> task = open_design(path("examples", "photo.json"))
    >>> task.scene.optic.control_points
    AutoNet(shape=(480, 480))
    """
    if scene.optic.known_shape is not None:
        return scene
    counts = (_chosen(image.scene, image.target) for image in scene.wanted(target))
    n_u, n_v = map(max, zip(*counts, strict=True))  # enough for each image
    return scene.with_net((n_u, n_v))


def _chosen(scene: Scene, target: Array) -> tuple[int, int]:
    if scene.run.usual_net is not None:
        n_u, n_v = (max(scene.run.usual_net, degree + 1) for degree in scene.optic.degree)
        return n_u, n_v
    scene = scene.alone
    source = of_known_size(scene.source, scene.optic)
    per_blur = _PER_FAR_BLUR if source.place is None else _PER_BLUR
    across, up = (
        min(_worth_of_target(target, axis), _worth_of_light(blur, half_width, per_blur))
        for axis, blur, half_width in zip(
            (1, 0),
            source.blur(scene.optic, scene.receiver),
            scene.receiver.half_extent,
            strict=True,
        )
    )
    pixels, degree = scene.receiver.pixels, scene.optic.degree
    return _count(pixels[0], across, degree[0]), _count(pixels[1], up, degree[1])


def _count(pixels: int, worth: float, degree: int) -> int:
    """Control points along an axis, for a task that is worth so many."""
    most = _PER_PIXEL * pixels
    needed = max(worth, min(_FEWEST, most))
    part = min((part for part in _PARTS if part * most >= needed), default=max(_PARTS))
    return min(max(math.ceil(part * most), degree + 1), LARGEST_NET)


def _worth_of_target(target: Array, axis: int) -> float:
    """Control points along an axis that the detail of a target is worth."""
    # Cosines do not mind that opposite borders differ: those of a mirrored image.
    drawn = target / target.max()
    mirrored = np.concatenate([drawn, np.flip(drawn, axis)], axis)
    waves = np.fft.rfft(mirrored, axis=axis, norm="ortho")
    energy = np.square(np.abs(waves)).sum(1 - axis)[:-1]
    energy[0] /= 2
    beyond = np.cumsum(energy[::-1])[::-1]  # from each frequency on
    half_periods = np.count_nonzero(beyond > _LEFT_OUT**2 * beyond[0])
    usual = _PER_PIXEL * len(energy)
    if _PER_PERIOD * int(half_periods) / 2 < usual:
        return _PER_PERIOD * int(half_periods) / 2
    most = max(usual, _PER_ROOT * math.sqrt(len(energy)))
    return min(usual * max(1.0, _worth_of_edges(drawn, axis)), most)


def _worth_of_edges(target: Array, axis: int) -> float:
    """How many times the usual control points along an axis edges of a target are worth."""
    density = np.moveaxis(_averaged(target / target.mean()), axis, 0)
    middle, difference = density[1:-1], np.diff(density, 2, axis=0)
    seen = difference / np.sqrt(middle.clip(_DARKEST))
    edges = float(np.linalg.norm(seen) / np.linalg.norm(density))
    return float((_PER_EDGE * edges) ** _POWER)


def _averaged(target: Array) -> Array:
    """Means of blocks of a target, so that about ``_SEEN`` are left along an axis, or more."""
    n_y, n_x = (max(1, count // _SEEN) for count in target.shape)
    m_y, m_x = target.shape[0] // n_y, target.shape[1] // n_x
    blocks = target[: m_y * n_y, : m_x * n_x].reshape(m_y, n_y, m_x, n_x)
    return np.asarray(blocks.mean((1, 3)))


def _worth_of_light(blur: float, half_width: float, per_blur: float) -> float:
    """Control points along an axis that are seen through a blur."""
    return math.inf if blur == 0 else per_blur * 2 * half_width / blur


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
