"""What becomes of the image when lens, glass and assembly are a little off.

Lenses are perturbed at random within given tolerances, one after the other, and each is traced by
the independent tracer with the same rays, so that they differ by their perturbations alone.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench.analysis.surface_noise import FINEST, with_noise
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.validation import validate
from workbench.errors import Refused, RunFailed
from workbench.scene import Scene

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Tolerances:
    """How far a lens may be off; lengths in scene units, 0 where it is not.

    Attributes
    ----------
    tilt : float
        Largest angle between lens and optical axis, radians, turned about the middle of the
        entrance face; anywhere in the disc of all such tilts, evenly.
    decentre : float
        Largest distance of the lens from the axis; evenly in the disc.
    index : float
        Largest error of the refractive index; evenly to both sides.
    distance : float
        Largest error of the screen's distance; evenly to both sides.
    surface : tuple[float, float]
        Root mean square of the exit face's error, and the length over which it is alike.
    source_tilt : float
        As ``tilt``, of the source about its middle.
    source_shift : float
        Largest distance of the source from its place; evenly in the ball.
    """

    tilt: float = 0.0
    decentre: float = 0.0
    index: float = 0.0
    distance: float = 0.0
    surface: tuple[float, float] = (0.0, 1.0)
    source_tilt: float = 0.0
    source_shift: float = 0.0

    @property
    def any(self) -> bool:
        """Whether anything is off."""
        lengths = self.decentre, self.distance, self.source_shift, self.surface[0]
        return any((self.tilt, self.source_tilt, self.index, *lengths))

    def check(self, scene: Scene) -> None:
        """Refuse what is not possible for a scene, in the words of the command line.

        Raises
        ------
        Refused
            With the tolerance and what is allowed.
        """
        scene.check_one_image("tolerances")
        for name in ("tilt", "source_tilt"):
            angle = getattr(self, name)
            if not 0 <= angle < math.pi / 4:
                raise Refused(name, f"{math.degrees(angle):g} degrees; at least 0, less than 45")
        if not 0 <= self.decentre < math.inf:
            raise Refused("decentre", f"{self.decentre:g}; a finite number from 0 is needed")
        most = scene.optic.index - 1
        if self.index != 0 and not 0 <= self.index < most:
            raise Refused("index", f"{self.index:g}; at least 0, less than {most:g}")
        optic, room = scene.optic, math.inf
        if self.distance:
            room = optic.onwards * (scene.receiver.plane_z - optic.edge_z)
        if not 0 <= self.distance < room:
            raise Refused(
                "distance",
                f"{self.distance:g}; at least 0, less than {room:g}, else the screen may touch "
                f"the {optic.called}",
            )
        self._check_source(scene)
        amplitude, scale = self.surface
        if not 0 <= amplitude < math.inf:
            raise Refused("surface[0]", f"{amplitude:g}; a finite number from 0 is needed")
        width = 2 * max(scene.optic.half_width)
        if amplitude > 0 and not FINEST * width <= scale <= width:
            raise Refused("surface[1]", f"{scale:g}; from {FINEST * width:g} to {width:g}")

    def _check_source(self, scene: Scene) -> None:
        """Refuse what the source of a scene cannot be off by."""
        source = scene.source
        if self.source_tilt and not source.turns:
            raise Refused(
                "source_tilt",
                f"{math.degrees(self.source_tilt):g} degrees change nothing: this source lights "
                "the lens alike however it is turned; 0",
            )
        if self.source_shift and not source.moves:
            raise Refused(
                "source_shift",
                f"{self.source_shift:g} changes nothing: even light from infinitely far is the "
                "same everywhere; 0",
            )
        room = scene.optic.front_z - source.nearest_z
        if not 0 <= self.source_shift < room:
            raise Refused(
                "source_shift",
                f"{self.source_shift:g}; at least 0, less than {room:g}, else the source may "
                "touch the lens",
            )


@dataclass(frozen=True)
class Perturbation:
    """How far one lens is off: as `Tolerances`, with directions and signs.

    Attributes
    ----------
    pose : Pose
        How the lens stands.
    index, distance : float
        What is added to the refractive index and to the screen's distance.
    surface : tuple[float, float]
        Root mean square and scale of the exit face's error.
    seed : int
        Which error of the exit face.
    """

    pose: Pose = field(default_factory=Pose)
    index: float = 0.0
    distance: float = 0.0
    surface: tuple[float, float] = (0.0, 1.0)
    seed: int = 0

    def applied(
        self, scene: Scene, heights: Mapping[str, Array]
    ) -> tuple[Scene, Mapping[str, Array]]:
        """The scene and the control heights of the lens, which may be more, that is off."""
        optic, face = scene.optic, scene.optic.face
        if self.index:
            off = {"refractive_index": optic.index + self.index, "wavelength_um": None}
            optic = optic.model_copy(update=off)
        amplitude, scale = self.surface
        if amplitude > 0:
            rng = np.random.default_rng(self.seed)
            if "entrance" in heights:  # its net stays as it is while that of the exit face changes
                counts = {"control_points": heights["entrance"].shape}
                entrance = optic.entrance.model_copy(update=counts)
                optic = optic.model_copy(update={"entrance": entrance})
            optic, rough = with_noise(optic, heights[face], amplitude, scale, rng)
            heights = {**heights, face: rough}
        scene = scene.with_optic(optic)
        if self.distance:
            screen = scene.receiver.moved_to(scene.receiver.plane_z + optic.onwards * self.distance)
            scene = scene.model_copy(update={"screen": screen})
        return scene, heights


@dataclass(frozen=True)
class Perturbed:
    """What a trace says of a lens that is off.

    Attributes
    ----------
    perturbation : Perturbation
        How far it is off.
    relative_l2 : float
        Error of its image, without the scatter of the rays (`Validation.relative_l2_corrected`).
    efficiency : float
        Part of the emitted flux that lands on the screen.
    """

    perturbation: Perturbation
    relative_l2: float
    efficiency: float

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON; angles in degrees."""
        off = self.perturbation
        return {
            "tilt": np.degrees(off.pose.tilt).tolist(),
            "decentre": list(off.pose.decentre),
            "source_tilt": np.degrees(off.pose.source_tilt).tolist(),
            "source_shift": list(off.pose.source_shift),
            "index": off.index,
            "distance": off.distance,
            "relative_l2": self.relative_l2,
            "efficiency": self.efficiency,
        }


def draw(tolerances: Tolerances, samples: int, seed: int) -> Iterator[Perturbation]:
    """Random perturbations within tolerances; the same seed gives the same, of each kind."""
    rng, of_source = (np.random.default_rng([seed, number]) for number in (2000, 2001))
    for _ in range(samples):
        tilt_x, tilt_y, shift_x, shift_y = (*_in_disc(rng), *_in_disc(rng))
        turn_x, turn_y = _in_disc(of_source)
        x, y, z = _in_ball(of_source)
        yield Perturbation(
            Pose(
                (tolerances.tilt * tilt_x, tolerances.tilt * tilt_y),
                (tolerances.decentre * shift_x, tolerances.decentre * shift_y),
                (tolerances.source_tilt * turn_x, tolerances.source_tilt * turn_y),
                (
                    tolerances.source_shift * x,
                    tolerances.source_shift * y,
                    tolerances.source_shift * z,
                ),
            ),
            index=tolerances.index * rng.uniform(-1, 1),
            distance=tolerances.distance * rng.uniform(-1, 1),
            surface=tolerances.surface,
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
    """Trace lenses that are off, one after the other.

    Parameters
    ----------
    scene, target, heights, rays
        As for `workbench.analysis.validation.validate`.
    tolerances : Tolerances
        How far they may be off.
    samples : int
        How many.
    seed : int
        The same seed gives the same lenses and rays.

    Yields
    ------
    Perturbed
        First the lens that is not off, then the others.

    Raises
    ------
    Refused
        If a tolerance is not possible.
    RunFailed
        If no light of the lens that is not off reaches the screen.

    Examples
    --------
    Three plates of glass that are decentred:

    >>> import numpy as np
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> from workbench.geometry.faces import FaceArrays
    >>> task = open_design(path("examples", "tophat.json"))
    >>> plate = FaceArrays({"exit": np.full(task.scene.optic.net_shape, 0.5)})
    >>> within = Tolerances(decentre=0.01)
    >>> nominal, *others = perturbed(task.scene, task.target, plate, within, samples=3, rays=10_000)
    >>> len(others), round(nominal.efficiency, 4)
    (3, 0.9216)
    """
    tolerances.check(scene)
    yield _trace(scene, target, heights, Perturbation(), rays, seed)
    for perturbation in draw(tolerances, samples, seed):
        try:
            yield _trace(scene, target, heights, perturbation, rays, seed)
        except RunFailed:  # a dark image is as wrong as its target is bright
            yield Perturbed(perturbation, relative_l2=1.0, efficiency=0.0)


@dataclass(frozen=True)
class Distribution:
    """How the error is distributed over perturbed lenses.

    Attributes
    ----------
    nominal : float
        Error of the lens that is not off.
    mean, worst : float
        Of the others.
    percentiles : dict[str, float]
        Error that so many percent of them do not exceed: "5", "50", "95".
    """

    nominal: float
    mean: float
    worst: float
    percentiles: dict[str, float]

    @classmethod
    def of(cls, nominal: Perturbed, others: list[Perturbed]) -> "Distribution":
        """Summarise what `perturbed` yields: its first lens, and at least one of the others."""
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
    found = validate(off, target, heights, rays, seed, pose=perturbation.pose)
    return Perturbed(perturbation, found.relative_l2_corrected, found.efficiency)


def _in_disc(rng: np.random.Generator) -> tuple[float, float]:
    """A point of the unit disc, evenly."""
    radius, angle = math.sqrt(rng.random()), 2 * math.pi * rng.random()
    return radius * math.cos(angle), radius * math.sin(angle)


def _in_ball(rng: np.random.Generator) -> tuple[float, float, float]:
    """A point of the unit ball, evenly."""
    x, y, z = rng.normal(size=3)
    far = math.cbrt(rng.random()) / math.hypot(x, y, z)
    return float(x * far), float(y * far), float(z * far)
