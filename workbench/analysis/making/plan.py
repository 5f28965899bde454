"""The cheapest plan of a shop for a wanted error as made: ball, step-over and polishing.

A coarse cut that is polished until its scallops are gone is as good as a fine one, as long as
polishing leaves the details of the lens. So each width of polishing has a widest step-over, and
the time of both decides.
"""

import math
from collections.abc import Mapping
from functools import partial
from typing import Any, NamedTuple

import torch

from workbench.analysis.making.plan_options import PlanOptions
from workbench.analysis.scatter import CorrectedDistance, tracing_independently
from workbench.arrays import Array
from workbench.cutters import cutter_radii
from workbench.design.levels import finest_image_of
from workbench.errors import Refused
from workbench.extended.blurring import convolved_in_place
from workbench.extended.relief_blur import ReliefBlurs
from workbench.geometry.as_made import AsMade
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets, nets_of
from workbench.messages import Message
from workbench.optics.plan import tensors_of
from workbench.powers import rounded
from workbench.progress import Steps, within
from workbench.scene import Scene, WantedImage
from workbench.scene.making.milling import Milling
from workbench.scene.making.polishing import Polishing
from workbench.scene.making.process import Process
from workbench.units import METRES

# Widths of polishing that are looked at, in knot spans of the net; and step-overs over the width,
# or, without polishing, in knot spans: what is finer than the smallest takes too long.
_WIDTHS = (0.0, 0.15, 0.25, 0.4, 0.6, 0.85, 1.2, 1.7, 2.4)
_FINEST, _COARSEST, _HALVINGS = 0.02, 8.0, 6
# The cheapest plan is checked by random rays; where it fails, finer ones are found. And parts of
# the time, for the images and for each check.
_ATTEMPTS, _ACCURACY, _SHRINKING = 4, 2e-3, 0.7
_PREPARED, _CHECKED = 0.4, 0.12
_MOST_STEP = 0.5  # step-over over the radius of the ball
_TURN = 1.0  # seconds from one pass to the next


class ShopPlan(NamedTuple):
    """A way to make a lens."""

    milling: Milling
    polishing: Polishing | None
    error: float  # relative L2 as made; of the cheapest by random rays, else as a run sees it
    milling_minutes: float
    polishing_minutes: float

    @property
    def minutes(self) -> float:
        """Time of both."""
        return self.milling_minutes + self.polishing_minutes

    @property
    def processes(self) -> tuple[Process, ...]:
        """Processes of a scene that is made so."""
        return (self.milling,) if self.polishing is None else (self.milling, self.polishing)

    def to_data(self) -> dict[str, Any]:
        """The plan by names, for JSON; lengths in scene units."""
        return {
            "processes": [each.model_dump() for each in self.processes],
            "scallop": self.milling.scallop,
            "relative_l2": self.error,
            "milling_minutes": self.milling_minutes,
            "polishing_minutes": self.polishing_minutes,
        }


class ShopPlans(NamedTuple):
    """Plans for a lens, the cheapest first."""

    designed: float  # relative L2 as designed, by random rays
    wanted: float  # relative L2 as made that was asked for
    plans: tuple[ShopPlan, ...]


def fitting_ball(scene: Scene, heights: Mapping[str, Array]) -> float:
    """Radius of the largest standard ball cutter that fits all designed faces, scene units.

    Where none fits, the radius is the largest one that does.
    """
    fitting = min(
        CutFace.lying(net, heights[face], outline_of(each), each.outwards(face)).default_radius
        for each in scene.optics
        for face, net in freeform_nets(each).items()
    )
    return next(iter(cutter_radii(scene.unit, fitting)), fitting)


def planning(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    options: PlanOptions | None = None,
    rays: int = 1_000_000,
) -> Steps[ShopPlans]:
    """Find plans in steps, the cheapest for each width of polishing.

    `options`: wanted error of the first image, cutter and times; `rays`: each check has at most
    four times as many. Raises `Refused` if no plan reaches the wanted error.
    """
    options = options or PlanOptions()
    radius = options.ball or fitting_ball(scene, heights)
    first, wanted, _ = scene.ideal.wanted(target)[0]
    spacing = max(max(net.spacing) for net in nets_of(scene).values())
    smoothed = []
    for number, part in enumerate(_WIDTHS):
        smoothed.append(_Smoothed(first, wanted, heights, part * spacing))
        yield _PREPARED * (number + 1) / len(_WIDTHS)
    ideal = _checked(first, heights, wanted, rays)
    designed = (yield from within(ideal, lambda done: _PREPARED + _CHECKED * done)).distance
    asked = 1.1 * designed if options.error is None else options.error / 100
    own, least = smoothed[0].error(), math.inf
    # Squares of what manufacture may add, and of how much of it a run may see.
    allowed = asked**2 - designed**2
    added = allowed * (own / designed) ** 2 if designed else allowed
    for attempt in range(_ATTEMPTS):
        limit = math.sqrt(max(own**2 + added, 0.0))
        found = [each.widest_step(radius, spacing, limit) for each in smoothed]
        plans = [
            _plan(scene, step, radius, each.width, options)
            for each, step in zip(smoothed, found, strict=True)
            if step is not None
        ]
        if not plans:
            break
        cheapest, *others = sorted(plans, key=lambda plan: plan.minutes)
        made = first.model_copy(update={"processes": cheapest.processes})
        begin = _PREPARED + _CHECKED * (attempt + 1)
        steps = _checked(made, heights, wanted, rays)
        error = yield from within(steps, partial(_of_check, begin))
        if error.distance - error.off <= asked:
            return ShopPlans(designed, asked, (cheapest._replace(error=error.distance), *others))
        least = min(least, error.distance)
        # Grooves that are not much finer than pixels spread light less evenly than a blur.
        added *= min(allowed / (error.square - designed**2), _SHRINKING)
    raise Refused(
        "error",
        Message(
            "{wanted:.3g} % as made is not reached by milling and polishing this lens; more than "
            "{least:.3g} % may be",
            wanted=100 * asked,
            least=100 * min(max(designed, asked), least),
        ),
    )


def _checked(
    scene: Scene, heights: Mapping[str, Array], target: Array, rays: int
) -> Steps[CorrectedDistance]:
    steps = tracing_independently(scene, heights, target, _ACCURACY, random_rays=rays)
    return (yield from steps).unscattered


def _of_check(begin: float, done: float) -> float:
    return begin + _CHECKED * done


class _Smoothed:
    """Images of a lens that is polished over a width, before and behind relief."""

    def __init__(
        self, scene: Scene, target: Array, heights: Mapping[str, Array], width: float
    ) -> None:
        processes = (Polishing(width=width),) if width else ()
        polished = scene.model_copy(update={"processes": processes})
        lens = tensors_of(heights, scene)
        self._image = finest_image_of(WantedImage(polished, target, 1.0), lens)
        self.width, self._light = width, self._image.light(lens)
        made = AsMade.of(polished)
        self._blurs = ReliefBlurs(made.scene, made.heights(heights))

    def error(self, milling: Milling | None = None) -> float:
        """Relative L2 error, with what polishing leaves of a cut."""
        if milling is None:
            return self._image.error_of(self._light)
        blur = self._blurs.blur([(relief, self.width) for relief in milling.reliefs])
        if blur is None:
            return self.error()
        light = convolved_in_place(self._light.double().cpu().numpy(), blur.of_pixels)
        return self._image.error_of(torch.as_tensor(light))

    def widest_step(
        self, radius: float, spacing: float, limit: float
    ) -> tuple[float, float] | None:
        """Widest step-over that meets a limit, and its error; None if there is none."""
        low = _FINEST * spacing
        high = min(_COARSEST * max(self.width, spacing), _MOST_STEP * radius)
        found = None
        for step in (low, *[0.0] * _HALVINGS):
            step = step or math.sqrt(low * high)
            error = self.error(Milling(ball_radius=radius, step_over=step))
            if error <= limit:
                low, found = step, (step, error)
            elif found is None:
                return None
            else:
                high = step
        return found


def _plan(
    scene: Scene, found: tuple[float, float], radius: float, width: float, options: PlanOptions
) -> ShopPlan:
    step, error = found
    mm = 1e3 * METRES[scene.unit]
    digit = 10.0 ** (math.floor(math.log10(step)) - 1)
    milling = Milling(ball_radius=radius, step_over=rounded(digit * (step // digit), 2))
    sizes = [[2 * mm * r for r in element.half_width] for element in scene.optics]
    area = sum(x * y for x, y in sizes)
    passes = sum(y / (mm * step) for _, y in sizes)
    cutting = area / (mm * step) / options.feed + passes * _TURN / 60
    polishing = options.polish_time * area / 100 * (mm * width / 0.1) ** 2
    polish = Polishing(width=rounded(width, 2)) if width else None
    return ShopPlan(milling, polish, error, cutting, polishing)
