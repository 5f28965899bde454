"""The memory of a run of ``auto``, from the sizes of its arrays, before any of them is made.

Two parts of a run take turns: the first design by transport, on grids of cells, and the descent on
the finest image. Computed values are 0.95 to 1.15 times the measured ones, for nets of 256 to 4096
pixels, light along the axis, of a point and of the sun, and two faces: 2.01 GB measured, 2.23 GB
computed for a photograph of 1024 x 1024 pixels.
"""

import math

from workbench.design.descent import remembered
from workbench.design.images import MARGINS
from workbench.design.levels import Level, cells_of, fine_level, source_cells
from workbench.design.transport.one_face import cells_for
from workbench.design.transport.two_faces import cells_of_faces
from workbench.design.waves import float_type
from workbench.errors import Refused
from workbench.extended.blur import Blur, one_over_the_lens
from workbench.geometry.surface import ControlNet, freeform_nets, nets_of
from workbench.messages import Message
from workbench.optics.path import Path
from workbench.optics.plan import precision_of
from workbench.optics.samples import Corners
from workbench.optics.train.compiled import CompiledTrain
from workbench.process import as_bytes, available_memory
from workbench.scene import Scene

# Compiled kernels, and libraries that a run is the first to need.
_PROGRAM = 120e6
_REAL = 8  # bytes of a float64
# Arrays of all cells of a first design that are there at the same time, as measured: below 32 MB,
# where they are cut out of one heap and leave pieces there, and from 32 MB on, where they are not.
# Of light from far away, of that of a near source, and with two faces.
_MAPPED = 32 << 20
_FAR, _NEAR, _BOTH = (26, 26), (58, 76), (122, 76)
# Numbers of a node: those of hits and flux, and their cotangents, in the precision of the trace;
# and in float64 what rows of nodes and images of parts take, measured.
_TRACED, _DRAWN = 6, 1
# Those of a node where beams run between origins: hits and flux in the order of the trace and in
# that of the samples, which are drawn in small batches.
_OF_SAMPLES = 8
# More of them in the precision of the trace: areas, depths and distances to the rim on two faces;
# and all that torch keeps where no kernel traces.
_OF_TWO_FACES, _WITHOUT_KERNEL = 6, 60
# Images that there are at the same time: steps and slivers of each thread, sums, cotangents.
_IMAGES = 4
# More of them where light is blurred: waves of the image, of the blur and its changes, in float32.
_BLURRED = 2
# Vectors of L-BFGS besides the two of each step that it remembers.
_VECTORS = 12
# Over a run, pieces that are freed between others take more than what is in use.
_SCATTERED = 1.15
# Cells of a path that is only to be looked at.
_A_FEW = Corners(4, 4)
# From here on a log says it.
_LARGE = 1e9


def auto_memory(scene: Scene) -> int:
    """Bytes that a run of ``auto`` takes beyond what the program has, about.

    `scene`: the design task, without stages, on a definite net.
    """
    return round(_PROGRAM + max(_of_start(scene), _of_descent(scene)))


def memory_notes(scene: Scene) -> tuple[str, ...]:
    """What the log of a run says of its memory, if it needs much."""
    needed = auto_memory(scene) if scene.run.device == "cpu" else 0
    if needed < _LARGE:
        return ()
    return (Message("memory: about {needed}", needed=as_bytes(needed)),)


def check_auto(scene: Scene) -> None:
    """Refuse a run that would not fit into memory, before it begins.

    Raises `Refused` with what takes it, what is needed, what is there, and what would fit.
    """
    if scene.run.device != "cpu":
        return  # what a run takes there has not been measured
    needed, available = auto_memory(scene), available_memory()
    if needed <= available:
        return
    (n_x, n_y), (n_u, n_v) = scene.receiver.pixels, scene.optic.net_shape
    raise Refused(
        "images[0].receiver.pixels",
        Message(
            "{n_x} × {n_y} pixels with {n_u} × {n_v} control points need about {needed} of memory, "
            "and {available} are free; take fewer of both, or close other programs",
            n_x=n_x,
            n_y=n_y,
            n_u=n_u,
            n_v=n_v,
            needed=as_bytes(needed),
            available=as_bytes(available),
        ),
    )


def _of_start(scene: Scene) -> float:
    """Bytes of a first design by transport."""
    nets, far = freeform_nets(scene.optic), scene.source.place is None
    both = len(nets) > 1
    cells = cells_of_faces(nets) if both else cells_for(nets[scene.optic.designed_face])
    array = _REAL * cells**2
    arrays = _BOTH if both else _FAR if far else _NEAR
    return float(arrays[array >= _MAPPED] * array)


def _of_descent(scene: Scene) -> float:
    """Bytes of a step on the finest images, all of which are there at the same time."""
    heights = sum(math.prod(net.shape) for net in nets_of(scene).values())
    pairs = 2 * remembered(heights) * float_type(heights).itemsize
    level = fine_level(scene)
    images = sum(_of_image(each, level) for each in scene.single)
    return _SCATTERED * (heights * (pairs + _REAL * _VECTORS) + images)


def _of_image(scene: Scene, level: Level) -> float:
    """Bytes of one evaluation of a lens in an image, with its gradient."""
    blur = Blur.of(scene)
    # Only a trace shows whether all parts of the lens blur the source alike.
    even = not blur.within_a_pixel and one_over_the_lens(scene)
    by_origins = _of_nodes(scene, cells_of(level, scene))
    if even:
        middle = cells_of(level, scene, sharp=True, rays=True)
        return max(by_origins, _of_nodes(scene, middle, blur.parts))
    between = source_cells(scene)
    return by_origins if between is None else max(by_origins, _of_nodes(scene, between))


def _of_nodes(scene: Scene, cells: Corners, finer: int = 0) -> float:
    """The same by so many cells, with so many times finer pixels where light is blurred."""
    grids = cells.origins * scene.source.point_count
    nodes = (cells.x + 1) * (cells.y + 1) * grids * len(scene.lines)
    traced = _OF_SAMPLES if cells.of_source else _TRACED
    traced += _OF_TWO_FACES * (len(nets_of(scene)) > 1)
    if not CompiledTrain.matches(Path.of(scene, ControlNet.of(scene.optic), samples=_A_FEW)):
        traced += _WITHOUT_KERNEL
    drawn = _DRAWN if grids == 1 else 0  # several grids are drawn one after the other
    pixels = math.prod(max(finer, 1) * n * (1 + 2 * MARGINS[0]) for n in scene.receiver.pixels)
    numbers = traced * precision_of(scene).itemsize + drawn * _REAL
    images = _IMAGES + _BLURRED * (finer > 0)
    return nodes * numbers + images * _REAL * pixels
