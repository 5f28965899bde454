"""An independent check of a lens: another tracer, the untouched target, fresh random rays.

Nothing of the optimiser's path is used, see `workbench.analysis.tracing`: the face's polynomials
come from `scipy.interpolate`, refraction from the part of a ray along the face, intersections from
false position, the image from counting rays in pixels, all in float64. A lens that is fitted to the
optimiser's fixed ray grid or to its smoothing filter is found out here. Where asked for, cells find
its error without the scatter of rays, see `workbench.analysis.cells`; rays are a second opinion.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.by_cells import ByCells, without_scatter
from workbench.analysis.independent import IndependentError
from workbench.analysis.metrics import Quality, paper_loss, product, relative_l2
from workbench.analysis.regions import RegionLight, light_of_regions
from workbench.analysis.scatter import FEWER, STUDENT_T, CorrectedDistance
from workbench.analysis.shading import Shading, shading_of
from workbench.analysis.through_focus import with_screen_at
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.cells import BATCHES
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import Tally
from workbench.errors import RunFailed
from workbench.measured.light_unit import light_unit
from workbench.optics.account import Account
from workbench.scene import Scene
from workbench.watch import Steps, Watch, finished, of_equal, unwatched, within

Array = npt.NDArray[np.float64]
Interval = tuple[float, float]
Images = list[npt.NDArray[np.float32]]

# Part of the work that the image by cells is taken to be.
_CELLS = 0.2
# Brighter targets are scaled down, else the sum over their pixels might be infinite.
_HUGE = 1e200


@dataclass(frozen=True)
class Validation:
    """What an independent trace says of a lens.

    Attributes
    ----------
    loss : float
        Paper's loss (section 2.4): Frobenius norm of the difference between image and target,
        each divided by its sum, over √(n_x n_y).
    relative_l2 : float
        The same norm over that of the normalised target; independent of the number of pixels.
        Scatter of the rays from pixel to pixel is in it, and falls with the number of rays.
    relative_l2_interval : tuple[float, float]
        Where it lies for other rays, as many: at least 95 % confidence.
    relative_l2_corrected : float
        The same error without the scatter of the rays, by a second image of a quarter as many
        other rays; see `CorrectedDistance`.
    relative_l2_corrected_interval : tuple[float, float]
        Where the lens's error lies: at least 95 % confidence.
    efficiency : float
        Part of the emitted flux that lands on the screen.
    account : Account
        Where the light went.
    quality : Quality
        Other figures of the image.
    rays : int
        Rays traced for the image.
    noise : float
        Monte-Carlo standard error of ``relative_l2``: standard deviation of its value for 16
        batches of the rays, over √16. The batches exclude each other, which makes the image of
        all rays better than this tells: an upper estimate. For the same reason products of two
        batches would not do for the corrected error.
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area on the screen, row 0 at +y.
    by_cells : ByCells, optional
        What cells say, where that was asked for and the source has not too many points.
    shading : Shading, optional
        Light that is counted although something is in its way, where cells were asked for.
    regions : tuple of RegionLight
        The light of each region, by cells where there are some.
    further : tuple of Validation
        The same of each further image, in their order.
    weight : float
        What the square of this image's error counts for beside those of the others.
    """

    loss: float
    relative_l2: float
    relative_l2_interval: Interval
    relative_l2_corrected: float
    relative_l2_corrected_interval: Interval
    efficiency: float
    account: Account
    quality: Quality
    rays: int
    noise: float
    irradiance: Array
    by_cells: ByCells | None = None
    shading: Shading | None = None
    regions: tuple[RegionLight, ...] = ()
    further: tuple["Validation", ...] = ()
    weight: float = 1.0

    @property
    def images(self) -> tuple["Validation", ...]:
        """What is said of each image, the first one first."""
        return (self, *self.further)

    @property
    def verified(self) -> "Validation | ByCells | CombinedError":
        """What has the error of the lens itself: cells, or else random rays.

        That of several images is the root of the weighted mean of their squares, as for a design.
        """
        return CombinedError.of(self.images) if self.further else self.by_cells or self

    @property
    def loss_corrected(self) -> float:
        """``loss`` of the lens itself, without the scatter of the rays."""
        if self.relative_l2 == 0:
            return self.loss
        return self.loss * self.verified.relative_l2_corrected / self.relative_l2

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON; those of further images and regions in lists."""
        further = {"further_images": [each.to_data() for each in self.further]}
        regions = {"regions": [each.to_data() for each in self.regions]}
        return {
            "loss": self.loss,
            "relative_l2": self.relative_l2,
            "relative_l2_interval": list(self.relative_l2_interval),
            "relative_l2_corrected": self.relative_l2_corrected,
            "relative_l2_corrected_interval": list(self.relative_l2_corrected_interval),
            **self.quality.to_data(),
            "efficiency": self.efficiency,
            "ledger": self.account.to_data(),
            "rays": self.rays,
            "noise": self.noise,
            "deterministic": self.by_cells and self.by_cells.to_data(),
            "shading": self.shading and self.shading.to_data(),
            **(regions if self.regions else {}),
            **(further if self.further else {}),
        }


class CombinedError(NamedTuple):
    """The error of several images.

    Attributes
    ----------
    relative_l2_corrected, relative_l2_corrected_interval
        As of `Validation`.
    """

    relative_l2_corrected: float
    relative_l2_corrected_interval: Interval

    @classmethod
    def of(cls, images: Sequence[Validation]) -> "CombinedError":
        """The root of the weighted mean of the squares of their errors."""
        each = [image.by_cells or image for image in images]
        weights = [image.weight for image in images]
        errors = [
            (found.relative_l2_corrected, *found.relative_l2_corrected_interval) for found in each
        ]
        error, low, high = np.sqrt(np.average(np.square(errors), axis=0, weights=weights)).tolist()
        return cls(error, (low, high))


def validate(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    rays: int = 4_000_000,
    seed: int = 1,
    screen_z: float | None = None,
    pose: Pose | None = None,
    threads: int | None = None,
    accuracy: float | None = None,
    watch: Watch = unwatched,
) -> Validation:
    """Trace a lens anew.

    Parameters
    ----------
    scene : Scene
        Lens, source and screen; filter and run settings play no part. Each of its images is
        checked by itself, with as many rays.
    target : ndarray, shape (n_y, n_x)
        The target image in any scale, row 0 at +y; of further images the scene has it.
    heights : mapping of str to ndarray, shape (n_u, n_v)
        Control heights of each freeform face by its name, scene units.
    rays : int
        Rays to trace at least; rounded up to whole batches of a grid. A quarter as many more are
        traced for the corrected error.
    seed : int
        The same seed gives the same rays.
    screen_z : float, optional
        Where the screen is, in place of the scene's.
    pose : Pose, optional
        How the lens stands; straight and centred by default.
    threads : int, optional
        How many trace; as many as there are cores by default.
    accuracy : float, optional
        Relative error that the image by cells may have; none is made by default.
    watch : callable
        Called with the part that is done.

    Raises
    ------
    Refused
        If there are too many rays, the screen may touch the lens there, or is to be elsewhere
        while there are further images, or the lens is no body; see `check_body`.
    RunFailed
        If no light reaches the screen.

    Examples
    --------
    A plate of glass reflects 4 % at each face:

    >>> import numpy as np
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> task = open_design(path("examples", "tophat.json"))
    >>> plate = {"exit": np.full(task.scene.optic.net_shape, 0.5)}
    >>> found = validate(task.scene, task.target, plate, rays=100_000)
    >>> round(found.account.lost["fresnel_entrance"], 12)
    0.04
    """
    steps = validating(scene, target, heights, rays, seed, screen_z, pose, threads, accuracy)
    return finished(steps, watch)


def validating(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    rays: int = 4_000_000,
    seed: int = 1,
    screen_z: float | None = None,
    pose: Pose | None = None,
    threads: int | None = None,
    accuracy: float | None = None,
) -> Steps[Validation]:
    """`validate` step by step, so that one can see how far it is and leave it.

    Parameters
    ----------
    scene, target, heights, rays, seed, screen_z, pose, threads, accuracy
        As for `validate`, and so is what is raised.
    """
    if screen_z is not None:
        scene.check_one_image("a check with the screen elsewhere")
        scene = with_screen_at(scene, screen_z)
    found: list[Validation] = []
    images = scene.images(target)
    for done, image in enumerate(images):
        steps = _of_one(image.scene, image.target, heights, rays, seed, pose, threads, accuracy)
        one = yield from within(steps, partial(of_equal, len(images), done))
        clearest = (one.by_cells or one).irradiance
        alone = image.scene
        told = light_unit(alone)
        regions = light_of_regions(alone.regions, alone.receiver, clearest, told)
        found.append(replace(one, weight=image.weight, regions=regions))
    first, *others = found
    return replace(first, further=tuple(others)) if others else first


def _of_one(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    rays: int,
    seed: int,
    pose: Pose | None,
    threads: int | None,
    accuracy: float | None,
) -> Steps[Validation]:
    """`validating` with a scene of one image."""
    if target.max() > _HUGE:
        target = target / target.max()

    image, independent, traced_from = None, None, 0.0
    if accuracy is not None:
        steps = without_scatter(scene, heights, target, accuracy, pose, threads)
        image, independent = yield from within(steps, lambda part: _CELLS * part)
        traced_from = _CELLS
    trace = Trace(scene, heights, rays, seed, pose)
    middle = traced_from + (1 - traced_from) * FEWER / (FEWER + 1)
    account, irradiance, distances, batches = yield from within(
        _traced(trace, target, scene.receiver.pixel_measure, threads),
        lambda part: traced_from + (middle - traced_from) * part,
    )
    references = [target] if image is None else [target, image.irradiance]
    if trace.sampled:
        unscattered = [CorrectedDistance.of_pairs(batches, reference) for reference in references]
        independent = IndependentError(unscattered[0], trace.rays)
    else:
        second = Trace(scene, heights, -(-rays // FEWER), _another(seed), pose)
        unscattered = yield from within(
            _by_other_rays(second, irradiance, references, threads),
            lambda part: middle + (1 - middle) * part,
        )

    error = relative_l2(irradiance, target)
    noise = float(np.std(distances, ddof=1)) / math.sqrt(BATCHES)
    corrected, by_cells = unscattered[0], None
    if image is not None:
        by_cells = ByCells.of(
            image, target, scene.receiver, irradiance, unscattered[1], independent
        )
    return Validation(
        loss=paper_loss(irradiance, target),
        relative_l2=error,
        relative_l2_interval=(max(error - STUDENT_T * noise, 0.0), error + STUDENT_T * noise),
        relative_l2_corrected=corrected.distance,
        relative_l2_corrected_interval=corrected.interval,
        efficiency=account.efficiency,
        account=account,
        quality=Quality.of(irradiance, target),
        rays=trace.rays,
        noise=noise,
        irradiance=irradiance,
        by_cells=by_cells,
        shading=None if accuracy is None else shading_of(scene, heights, seed, pose),
    )


def _traced(
    trace: Trace, target: Array, pixel_measure: float | Array, threads: int | None
) -> Steps[tuple[Account, Array, list[float], Images]]:
    """Where the light of a trace goes, its image, and the distances of its batches' to the target.

    Where the batches are independent, their images too.
    """
    distances, images = [], []
    total: Tally | None = None
    for batch in trace.batches(threads):
        if batch is not None:
            distances.append(relative_l2(batch.flux.reshape(target.shape), target))
            if trace.sampled:
                images.append(batch.flux.reshape(target.shape).astype(np.float32))
        total = added(total, batch)
        del batch  # large images must not wait for the next ones
        yield trace.part
    assert total is not None
    account = _account(total)
    if account.on_screen == 0:
        raise RunFailed("no light of this lens reaches the screen, so there is no image to judge")
    irradiance = total.flux.reshape(target.shape) / (total.emitted * pixel_measure)
    return account, irradiance, distances, images


def _by_other_rays(
    trace: Trace, image: Array, references: Sequence[Array], threads: int | None
) -> Steps[list[CorrectedDistance]]:
    """An image's distance to each reference, from its products with those of other rays."""
    found: list[list[float]] = [[] for _ in references]
    for batch in trace.batches(threads):
        if batch is not None:
            other = batch.flux.reshape(image.shape)
            for products, reference in zip(found, references, strict=True):
                products.append(product(image, other, reference))
        del batch
        yield trace.part
    return [CorrectedDistance.of(products) for products in found]


def _account(tally: Tally) -> Account:
    """The account of all light, as parts of what was emitted."""
    lost = {"off_screen": float(tally.beside.sum()), **tally.lost}
    parts = {name: flux / tally.emitted for name, flux in lost.items()}
    return Account(float(tally.flux.sum()) / tally.emitted, parts)


def _another(seed: int) -> int:
    """A seed for rays that have nothing to do with those of this one."""
    return int(np.random.SeedSequence([seed, 1000]).generate_state(1, np.uint64)[0])
