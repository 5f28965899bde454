"""Tolerance analysis: the error of lenses with random errors of shape, material and assembly.

Each perturbed lens is traced by the independent tracer with the same rays, so that results differ
by the perturbations alone.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field, replace
from typing import Any

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline
from scipy.ndimage import gaussian_filter

from workbench.analysis.manufacture import manufacture
from workbench.analysis.tolerance_fields import ABOUT, Tolerances
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.validation import validate
from workbench.arrays import Array
from workbench.errors import Refused, RunFailed
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.messages import Message
from workbench.scene import Element, Scene, SplineFace
from workbench.scene.turning import tilt_of, turned


@dataclass(frozen=True)
class ElementError:
    """Errors of one element of a train, in its own coordinates.

    ``tilt`` is a rotation vector in radians about the front vertex, ``decentre`` a shift in scene
    units, ``index`` that of the refractive index.
    """

    tilt: tuple[float, float] = (0.0, 0.0)
    decentre: tuple[float, float] = (0.0, 0.0)
    index: float = 0.0

    def applied(self, element: Element, scene: Scene) -> Element:
        """Return the element with its errors."""
        turn = element.turn
        place = element.position + turn[:, :2] @ self.decentre
        tilt = tilt_of(turn @ turned(tuple(np.degrees(self.tilt).tolist())))
        update: dict[str, Any] = {"position": tuple(place.tolist()), "tilt": tilt}
        moved = element.model_copy(update=update)
        return moved.lit(scene.source.wavelength).denser(self.index) if self.index else moved


@dataclass(frozen=True)
class Perturbation:
    """Errors of one lens, or of a train: as `Tolerances`, with directions and signs.

    A train has the errors of its ``elements``, and of its ``pose`` those of the source alone.
    """

    pose: Pose = field(default_factory=Pose)
    elements: tuple[ElementError, ...] = ()
    # Errors of the refractive index and of the screen's distance.
    index: float = 0.0
    distance: float = 0.0
    # RMS and correlation length of the error of the designed face and of the front face.
    surface: tuple[float, float] = (0.0, 1.0)
    entrance_surface: tuple[float, float] = (0.0, 1.0)
    seed: int = 0  # of the errors of the faces

    def applied(
        self, scene: Scene, heights: Mapping[str, Array]
    ) -> tuple[Scene, Mapping[str, Array]]:
        """Return scene and control heights of the perturbed lens; nets may be finer."""
        if self.elements:
            scene, heights = self._moved(scene, heights)
        optic = scene.optic
        if self.index:
            optic = optic.denser(self.index)
        for number, (face, (amplitude, scale)) in enumerate(
            (
                (optic.designed_face, self.surface),
                (optic.placed_faces[0].name, self.entrance_surface),
            )
        ):
            if amplitude > 0:
                net, smooth = _net_of(optic, heights, face)
                rng = np.random.default_rng([self.seed, number] if number else self.seed)
                heights = {**heights, face: with_noise(net, smooth, amplitude, scale, rng)}
        scene = scene.with_optic(_with_nets(optic, heights))
        if self.distance:
            along = scene.onwards(scene.receiver) * self.distance
            screen = scene.receiver.moved_to(scene.receiver.plane_z + along)
            scene = scene.with_receiver(screen)
        return scene, heights

    @property
    def traced(self) -> Pose:
        """The pose for the check: of a train, the scene itself has all errors."""
        return Pose() if self.elements else self.pose

    def _moved(
        self, scene: Scene, heights: Mapping[str, Array]
    ) -> tuple[Scene, Mapping[str, Array]]:
        """Return a train with the errors of its elements and its source, and its heights."""
        pairs = zip(self.elements, scene.elements, strict=True)
        elements = tuple(error.applied(element, scene) for error, element in pairs)
        rises = {  # heights count from `Element.origin`
            placed.name: moved.position[2] - element.position[2]
            for element, moved in zip(scene.elements, elements, strict=True)
            for placed in element.placed_faces
        }
        source = scene.source
        if source.place is not None:
            x, y, z = np.add(source.place, self.pose.source_shift).tolist()
            source = source.placed((x, y, z))
        heights = {face: z + rises[face] for face, z in heights.items()}
        return scene.model_copy(update={"elements": elements, "source": source}), heights


def _net_of(optic: Element, heights: Mapping[str, Array], face: str) -> tuple[ControlNet, Array]:
    """Net and control heights of a face; a flat face has the smallest net."""
    nets = freeform_nets(optic)
    if face in nets:
        return nets[face], heights[face]
    net = ControlNet((4, 4), (3, 3), optic.half_width)
    return net, np.full(net.shape, optic.front_z)


def _with_nets(optic: Element, heights: Mapping[str, Array]) -> Element:
    """Return an element with the nets of the heights."""
    own = [placed.name for placed in optic.placed_faces]
    for face, each in heights.items():
        if face not in own:
            continue
        if face not in freeform_nets(optic):
            optic = optic.with_face(face, SplineFace(shape="bspline"))
        optic = optic.shaped(face, control_points=each.shape)
    return optic


@dataclass(frozen=True)
class Perturbed:
    """Result of a trace of a perturbed lens."""

    perturbation: Perturbation
    relative_l2: float  # without noise (`Validation.relative_l2_corrected`)
    efficiency: float  # part of the emitted flux on the receiver

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON; angles in degrees."""
        off = self.perturbation
        drawn = {**vars(off.pose), "index": off.index, "distance": off.distance}
        if off.elements:
            drawn = {"source_shift": off.pose.source_shift, "distance": off.distance}
        elements = [
            {"tilt": np.degrees(each.tilt).tolist(), "decentre": list(each.decentre)}
            | {"index": each.index}
            for each in off.elements
        ]
        return {
            **({"elements": elements} if elements else {}),
            **{
                name: np.degrees(size).tolist()
                if ABOUT[name].unit == "degrees"
                else np.array(size).tolist()
                for name, size in drawn.items()
            },
            "relative_l2": self.relative_l2,
            "efficiency": self.efficiency,
        }


def draw(
    tolerances: Tolerances, samples: int, seed: int, elements: int = 1
) -> Iterator[Perturbation]:
    """Yield random perturbations within tolerances; the same seed gives the same ones.

    Each of several ``elements`` has errors of its own.
    """
    of_elements = [np.random.default_rng([seed, 2003 + number]) for number in range(elements)]
    rng, of_source, of_exit = (
        np.random.default_rng([seed, number]) for number in (2000, 2001, 2002)
    )
    for _ in range(samples):
        tilt, decentre = _in_disc(rng, tolerances.tilt), _in_disc(rng, tolerances.decentre)
        errors = [
            ElementError(
                _in_disc(own, tolerances.tilt),
                _in_disc(own, tolerances.decentre),
                tolerances.index * own.uniform(-1, 1),
            )
            for own in of_elements
        ]
        index = tolerances.index * rng.uniform(-1, 1)
        yield Perturbation(
            Pose(
                tilt,
                decentre,
                _in_disc(of_source, tolerances.source_tilt),
                _in_ball(of_source, tolerances.source_shift),
                _in_disc(of_exit, tolerances.exit_tilt),
                _in_disc(of_exit, tolerances.exit_decentre),
            ),
            elements=tuple(errors) if elements > 1 else (),
            index=index if elements == 1 else 0.0,
            distance=tolerances.distance * rng.uniform(-1, 1),
            surface=tolerances.surface,
            entrance_surface=tolerances.entrance_surface,
            seed=int(rng.integers(1 << 62)),
        )


def perturbed(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    tolerances: Tolerances,
    samples: int = 100,
    rays: int = 1_000_000,
    seed: int = 1,
) -> Iterator[Perturbed]:
    """Trace the nominal lens, then ``samples`` perturbed lenses.

    Raises `Refused` if a tolerance is not possible; `RunFailed` if no light of the nominal lens
    reaches the receiver.

    Examples
    --------
    Three decentred plates of glass:

    >>> import numpy as np
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> from workbench.geometry.faces import FaceArrays
    >>> task = open_design(path("examples", "tophat.json"))
    >>> plate = FaceArrays({"lens.back": np.full(task.scene.optic.net_shape, 0.5)})
    >>> within = Tolerances(decentre=0.01)
    >>> nominal, *others = perturbed(task.scene, task.target, plate, within, samples=3, rays=10_000)
    >>> len(others), round(nominal.efficiency, 4)
    (3, 0.9216)
    """
    tolerances.check(scene)
    _check_faces(scene.optic, heights, tolerances)
    yield _trace(scene, target, heights, Perturbation(), rays, seed)
    for perturbation in draw(tolerances, samples, seed, len(scene.elements)):
        try:
            yield _trace(scene, target, heights, perturbation, rays, seed)
        except RunFailed:  # a dark image has an error of 1
            yield Perturbed(perturbation, relative_l2=1.0, efficiency=0.0)


@dataclass(frozen=True)
class Distribution:
    """Distribution of the error of perturbed lenses."""

    nominal: float  # error of the nominal lens
    mean: float
    worst: float
    percentiles: dict[str, float]  # by "5", "50", "95"

    @classmethod
    def of(cls, nominal: Perturbed, others: list[Perturbed]) -> "Distribution":
        """Summarise the results of `perturbed`: the nominal lens and at least one other."""
        errors = np.array([each.relative_l2 for each in others])
        return cls(
            nominal.relative_l2,
            float(errors.mean()),
            float(errors.max()),
            {f"{part}": float(np.percentile(errors, part)) for part in (5, 50, 95)},
        )

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return asdict(self)


def _trace(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    perturbation: Perturbation,
    rays: int,
    seed: int,
) -> Perturbed:
    off, heights = perturbation.applied(scene, heights)
    found = validate(off, target, heights, rays, seed, pose=perturbation.traced)
    return Perturbed(perturbation, found.relative_l2_corrected, found.efficiency)


def _check_faces(optic: Element, heights: Mapping[str, Array], tolerances: Tolerances) -> None:
    """Refuse errors by which the back face may touch the front face."""
    if not (tolerances.exit_tilt or tolerances.exit_decentre):
        return
    found = manufacture(optic, heights)
    steepest = math.tan(math.radians(found.steepest.bound))
    rim = math.tan(tolerances.exit_tilt) * math.hypot(*optic.half_width)
    for name, lower in (("exit_tilt", rim), ("exit_decentre", tolerances.exit_decentre * steepest)):
        if lower >= found.thinnest.bound / 2:  # half of the thickness for each of the two errors
            raise Refused(
                name,
                Message(
                    "the exit face may come {lower:.3g} nearer to the entrance face, "
                    "more than half of the least thickness {half:.3g}: less is needed",
                    lower=lower,
                    half=found.thinnest.bound,
                ),
            )


def _in_disc(rng: np.random.Generator, size: float) -> tuple[float, float]:
    radius, angle = math.sqrt(rng.random()), 2 * math.pi * rng.random()
    return size * (radius * math.cos(angle)), size * (radius * math.sin(angle))


def _in_ball(rng: np.random.Generator, size: float) -> tuple[float, float, float]:
    x, y, z = rng.normal(size=3)
    far = math.cbrt(rng.random()) / math.hypot(x, y, z)
    return size * float(x * far), size * float(y * far), size * float(z * far)


_SPANS = 4  # knot spans per length of the noise, enough for any degree


def with_noise(
    net: ControlNet, control_points: Array, amplitude: float, scale: float, rng: np.random.Generator
) -> Array:
    """Return control heights of a face with a random error, on a net as fine as the error needs.

    `amplitude`: RMS of the error about its mean, scene units; `scale`: correlation length, as in
    exp(−r² / scale²), from `tolerance_fields.FINEST` of the lens's width up to its width.
    """
    for axis, (r, n, p) in enumerate(zip(net.half_width, net.shape, net.degree, strict=True)):
        split = math.ceil(_SPANS * 2 * r / (scale * (n - p)))
        control_points = _refined(control_points, axis, r, p, split)
    finer = replace(net, shape=control_points.shape)
    return control_points + amplitude * _noise(finer, scale, rng)


def _refined(control_points: Array, axis: int, half_width: float, degree: int, split: int) -> Array:
    """Split each knot span along an axis evenly; the face stays the same."""
    spans = control_points.shape[axis] - degree
    coarse, fine = (_knots(half_width, count, degree) for count in (spans, spans * split))
    face = BSpline(coarse, np.moveaxis(control_points, axis, 0), degree)
    # The spline on the finer knots that interpolates the face is the face.
    places = np.array([fine[i + 1 : i + degree + 1].mean() for i in range(len(fine) - degree - 1)])
    places = places.clip(-half_width, half_width)  # which means miss by rounding
    finer = make_interp_spline(places, face(places), degree, t=fine).c
    return np.ascontiguousarray(np.moveaxis(finer, 0, axis))


def _noise(net: ControlNet, scale: float, rng: np.random.Generator) -> Array:
    """Control heights of a random face with mean 0 and RMS 1."""
    samplers, widths = [], []
    for r, n, p in zip(net.half_width, net.shape, net.degree, strict=True):
        knots = _knots(r, n - p, p)
        middles = (np.arange(4 * (n - p)) + 0.5) * (r / (2 * (n - p))) - r
        samplers.append(BSpline(knots, np.eye(n), p)(middles))
        # White noise after a Gaussian filter of σ has the correlation exp(−r² / 4σ²).
        widths.append(scale / 2 / (2 * r / (n - p)))
    # Filtered beyond the edge, so that the noise is stationary there.
    margins = [min(math.ceil(4 * width), n) for width, n in zip(widths, net.shape, strict=True)]
    size = [n + 2 * m for n, m in zip(net.shape, margins, strict=True)]
    white = gaussian_filter(rng.standard_normal(size), widths, mode="wrap")
    heights = white[margins[0] : size[0] - margins[0], margins[1] : size[1] - margins[1]]
    surface = samplers[0] @ heights @ samplers[1].T
    return np.asarray((heights - surface.mean()) / surface.std())


def _knots(half_width: float, spans: int, degree: int) -> Array:
    ends = np.full(degree, half_width)
    return np.concatenate([-ends, np.linspace(-half_width, half_width, spans + 1), ends])
