"""The independent check beside Mitsuba 3: every source, receiver and outline, and trains."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from resources import EXAMPLES, path
from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, Table, TableColumn
from workbench.analysis.cross_check import CrossCheck, cross_check
from workbench.arrays import Array
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene

RAYS = 16_000_000
_PIXELS = (64, 48)

_POINT = {"kind": "point", "position": [0.3, -0.2, -4.0]}
_AREA = {"kind": "area", "position": [0.2, -0.1, -3.0], "half_width": [0.3, 0.2]}
_SUN = {"kind": "collimated", "direction": [2.0, 3.0], "angular_diameter": 4.0}
_BEAM = {"profile": {"kind": "gaussian", "radius": 0.8}}

SOURCES: dict[str, dict[str, Any]] = {
    "parallel": {"kind": "collimated"},
    "parallel, tilted": {"kind": "collimated", "direction": [4.0, -6.0]},
    "Gaussian beam": {"kind": "collimated", "direction": [3.0, 2.0]} | _BEAM,
    "disc of the sky": _SUN,
    "beam from a disc": _SUN | _BEAM,
    "point": _POINT,
    "Lambertian point": _POINT | {"emission": "lambertian"},
    "grid of points": {
        "kind": "grid",
        "position": [0.1, 0.2, -4.0],
        "half_width": [0.5, 0.3],
        "points": [3, 2],
    },
    "rectangle": _AREA,
    "even rectangle": _AREA | {"emission": "uniform"},
    "ellipse": _AREA | {"outline": "ellipse"},
    "photometric file": {
        "kind": "photometric",
        "file": str(path("lights", "led.ies")),
        "position": [0.3, -0.2, -3.0],
        "rotation": [10.0, -20.0, 30.0],
    },
    "ray file": {
        "kind": "ray_file",
        "file": str(path("lights", "led.tm25ray")),
        "file_unit": "cm",
        "position": [0.1, 0.0, -2.0],
    },
}
_SCREEN = {"kind": "plane", "pixels": _PIXELS}
RECEIVERS: dict[str, dict[str, Any]] = {
    "upright": _SCREEN | {"position": [0.0, 0.0, 4.0], "half_width": [1.2, 0.9]},
    "tilted": _SCREEN
    | {"position": [0.6, 0.2, 5.0], "tilt": [10.0, 40.0, 0.0], "half_width": [1.6, 1.2]},
    "far field": {
        "kind": "far_field",
        "half_angle": [8.0, 6.0],
        "center": [1.4, -0.2],
        "pixels": _PIXELS,
    },
}
_OF_MIRROR = _SCREEN | {
    "position": [3.5, 0.5, -6.0],
    "tilt": [0.0, -30.0, 0.0],
    "half_width": [2.0, 1.5],
}
OUTLINES = "rectangle", "ellipse"

_FACE = {"shape": "bspline", "control_points": [12, 10]}
_FRONT = {"shape": "bspline", "control_points": [7, 9], "height_range": [-0.1, 0.3]}
_LENS = {
    "kind": "lens",
    "name": "lens",
    "half_width": [1.0, 0.8],
    "material": {"index": 1.5},
    "thickness": 0.5,
}
OPTICS: dict[str, dict[str, Any]] = {
    "one face": _LENS | {"faces": [{"shape": "plane"}, _FACE]},
    "two faces": _LENS | {"faces": [_FRONT, _FACE]},
    "mirror": {
        "kind": "mirror",
        "name": "mirror",
        "half_width": [1.0, 0.8],
        "reflectance": 0.8,
        "face": _FACE,
    },
}


@dataclass(frozen=True)
class SeenTwice:
    """A lens, a mirror or a train in both tracers."""

    optic: str
    source: str
    receiver: str
    outline: str
    found: CrossCheck

    @property
    def scene(self) -> str:
        """Name of the case."""
        return f"{self.optic}, {self.source}, {self.receiver}, {self.outline}"

    @property
    def difference(self) -> float:
        """See `CrossCheck`."""
        return self.found.difference

    @property
    def noise(self) -> float:
        """See `CrossCheck`."""
        return self.found.noise

    @property
    def without_noise(self) -> str:
        """The difference without noise, with its interval."""
        low, high = self.found.difference_corrected_interval
        return f"{self.found.difference_corrected:.2%} ({low:.2%} to {high:.2%})"

    @property
    def deviations(self) -> float:
        """Squared difference without noise in standard deviations; by noise one of 40 exceeds 2."""
        square = self.found.difference_corrected**2
        spread = self.found.difference_corrected_interval[1] ** 2 - square
        return 0.0 if spread == 0 else 1.96 * square / spread

    @property
    def light(self) -> str:
        """The light on the receiver in the check and in Mitsuba."""
        return f"{self.found.ours.efficiency:.3%} / {self.found.mitsuba.efficiency:.3%}"

    @property
    def light_deviations(self) -> float:
        """How much more light Mitsuba finds there, in standard deviations of its random paths."""
        ours, theirs = self.found.ours.efficiency, self.found.mitsuba.efficiency
        return (theirs - ours) / math.sqrt(ours * (1 - ours) / self.found.rays)

    @property
    def error(self) -> str:
        """The error of the image in the check and in Mitsuba, without noise."""
        ours, theirs = self.found.ours, self.found.mitsuba
        return f"{ours.relative_l2_corrected:.2%} / {theirs.relative_l2_corrected:.2%}"


def comparisons(notify: Notify, rays: int = RAYS) -> Iterator[SeenTwice]:
    """Trace a curved face with every source, receiver and outline; then two faces and a mirror."""
    for case in cases():
        scene = scene_of(*case)
        target = np.ones(scene.receiver.pixels[::-1])
        progress = _progress_of(notify, ", ".join(case))
        yield SeenTwice(*case, cross_check(scene, target, bent(scene), rays, progress=progress))


def trains(notify: Notify, iterations: int | None = None, rays: int = RAYS) -> Iterator[SeenTwice]:
    """Design the examples of several elements, tilted ones and white light; trace their lenses."""
    changes = {} if iterations is None else {"run.iterations": iterations}
    for name in train_examples():
        task = BenchmarkTask.of(name, changes=changes)
        progress = _progress_of(notify, name)
        lens = task.designed(partial(notify, name)).state.heights
        scene = task.scene
        kinds = ", ".join(each.kind for each in scene.elements)
        yield SeenTwice(
            f"{name} ({kinds})",
            scene.source.kind,
            scene.receiver.kind,
            scene.optic.outline,
            cross_check(scene, task.target, lens, rays, progress=progress),
        )


def train_examples() -> Iterator[str]:
    """Names of the examples that `trains` designs."""
    for example in EXAMPLES:
        scene = Scene.from_json(example.file.read_bytes())
        several = len(scene.elements) > 1 or len(scene.lines) > 1
        if len(scene.images) == 1 and (several or any(scene.optic.tilt)):
            yield example.name


def cases() -> Iterator[tuple[str, str, str, str]]:
    """Element, source, receiver and outline of each row."""
    lit = [("one face", source, receiver) for source in SOURCES for receiver in RECEIVERS]
    for source in ("parallel", "point"):
        lit += [("two faces", source, receiver) for receiver in RECEIVERS]
        lit += [("mirror", source, "tilted")]
    return ((*each, outline) for each in lit for outline in OUTLINES)


def _progress_of(notify: Notify, case: str) -> Callable[[float], None]:
    return lambda done: notify(case, f"{done:.0%}")


def scene_of(optic: str, source: str, receiver: str, outline: str) -> Scene:
    """The scene of a row."""
    seen_by = _OF_MIRROR if optic == "mirror" else RECEIVERS[receiver]
    return Scene.from_data(
        {
            "version": 3,
            "source": SOURCES[source],
            "elements": [OPTICS[optic] | {"outline": outline}],
            "images": [{"receiver": seen_by, "target": {"builtin": "tophat"}}],
        }
    )


def bent(scene: Scene) -> Mapping[str, Array]:
    """Return faces that focus light beside the axis, differently along x and y."""
    heights = {}
    for face, net in freeform_nets(scene.optic).items():
        x, y = net.positions[0][:, None], net.positions[1][None, :]
        rise = -0.05 * x**2 + 0.03 * y**2 + 0.04 * x + 0.03 * x * y**2 - 0.02 * y
        if face == "mirror.face":
            rise = 0.28 * x + 0.5 * rise
        heights[face] = (0.5 if face == "lens.back" else 0.0) + rise
    return heights


def table(found: Sequence[SeenTwice]) -> Table:
    """Cases as rows."""
    columns = (
        TableColumn("optic", "optic"),
        TableColumn("source", "source"),
        TableColumn("receiver", "receiver"),
        TableColumn("outline", "outline"),
        TableColumn("difference", "difference", ".2%"),
        TableColumn("noise", "by noise alone", ".2%"),
        TableColumn("without_noise", "without noise (95 %)"),
        TableColumn("deviations", "standard deviations", ".1f"),
        TableColumn("error", "error: check / Mitsuba"),
        TableColumn("light", "on the receiver: check / Mitsuba"),
        TableColumn("light_deviations", "standard deviations", "+.1f"),
    )
    note = (
        "Relative L2 distance of both images, each divided by its sum. Standard deviations: those "
        "of the square of the distance without noise, above none; and those of the light that "
        "random paths of Mitsuba bring to the receiver."
    )
    return Table("The check beside Mitsuba 3", columns, found, note)
