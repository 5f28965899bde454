"""An independent check of a lens: another tracer, the untouched target, fresh random rays.

Nothing of the optimiser's path is used, see `workbench.analysis.tracing`: the face's polynomials
come from `scipy.interpolate`, refraction from the part of a ray along the face, intersections from
false position, the image from counting rays in pixels, all in float64. A lens that is fitted to the
optimiser's fixed ray grid or to its smoothing filter is found out here. Where asked for, cells find
its error without the scatter of rays, see `workbench.analysis.cells`; rays are a second opinion.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.analysis.by_cells import ByCells, RandomShare, without_scatter
from workbench.analysis.focus import with_screen_at
from workbench.analysis.metrics import Quality, paper_loss, product, relative_l2, root
from workbench.analysis.regions import light_of_lit_area, light_of_regions
from workbench.analysis.scatter import FEWER, STUDENT_T, CorrectedDistance, IndependentError
from workbench.analysis.shading import shading_of
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import Tally
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.errors import RunFailed
from workbench.geometry.as_made import scatterer_of
from workbench.measured.lamps import light_unit
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.progress import Progress, Steps, finished, no_progress, of_equal, within
from workbench.scene import Scene

Images = list[npt.NDArray[np.float32]]

DARK = Message("no light of this lens reaches the screen, so there is no image to judge")
"""Why a lens is not checked."""

_CELLS = 0.7  # estimated fraction of the work for the image by cells
_HUGE = 1e200  # largest value of a target that is not scaled, so that its sum is finite


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
    progress: Progress = no_progress,
) -> Validation:
    """Check a lens by an independent trace with random rays, and by cells if ``accuracy`` is given.

    `target` (n_y, n_x): of the first image, in any scale, row 0 at +y; `rays`: least number for
    each image, rounded up to whole batches; a quarter more are traced for the corrected error;
    `screen_z`: z of the screen in place of the scene's; `threads`: by default one for each core;
    `accuracy`: relative error of the image by cells, or a fortieth of its distance to the target
    if that is more; see `imaging`. Raises `Refused` if there are
    too many rays, the screen may touch the lens, or the lens is no solid body; `RunFailed` if no
    light reaches the receiver, or too few rays of a file.

    Examples
    --------
    A plate of glass reflects 4 % at each face:

    >>> import numpy as np
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> task = open_design(path("examples", "tophat.json"))
    >>> plate = {"lens.back": np.full(task.scene.optic.net_shape, 0.5)}
    >>> found = validate(task.scene, task.target, plate, rays=100_000)
    >>> round(found.account.lost["fresnel_entrance"], 12)
    0.04
    """
    steps = validating(scene, target, heights, rays, seed, screen_z, pose, threads, accuracy)
    return finished(steps, progress)


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
    """`validate` in steps."""
    if screen_z is not None:
        scene.check_one_image("a check with the screen elsewhere")
        scene = with_screen_at(scene, screen_z)
    found: list[Validation] = []
    images = scene.wanted(target)
    for done, image in enumerate(images):
        steps = _of_one(image.scene, image.target, heights, rays, seed, pose, threads, accuracy)
        one = yield from within(steps, partial(of_equal, len(images), done))
        clearest = (one.by_cells or one).irradiance
        own = image.scene
        area = light_of_lit_area(own, image.target, clearest)
        regions = light_of_regions(own.regions, own.receiver, clearest, light_unit(own))
        found.append(replace(one, weight=image.weight, lit_area=area, regions=regions))
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
    target = target / target.max() if target.max() > _HUGE else target
    image, independent, traced_from = None, None, 0.0
    if accuracy is not None:
        steps = without_scatter(scene, heights, target, accuracy, pose, threads, rays)
        image, independent = yield from within(steps, lambda part: _CELLS * part)
        traced_from = _CELLS
    trace = Trace(scene, heights, rays, seed, pose)
    middle = traced_from + (1 - traced_from) * FEWER / (FEWER + 1)
    account, irradiance, spread, batches = yield from within(
        _traced(trace, target, scene.receiver.pixel_measure, threads),
        lambda part: traced_from + (middle - traced_from) * part,
    )
    references = [target] if image is None else [target, image.irradiance]
    if trace.sampled:
        unscattered = _of_parts(batches, references, scene.receiver.called)
        independent = IndependentError(unscattered[0], trace.rays)
    else:
        second = Trace(scene, heights, -(-rays // FEWER), _another(seed), pose)
        unscattered = yield from within(
            _by_other_rays(second, irradiance, references, threads),
            lambda part: middle + (1 - middle) * part,
        )

    error = relative_l2(irradiance, target)
    noise = float(np.std(spread.distances, ddof=1)) / math.sqrt(BATCHES)
    share = RandomShare.of(account.efficiency, spread.shares, trace.rays)
    corrected, by_cells = unscattered[0], None
    if image is not None:
        known = None if trace.sampled else share
        of_rays = (irradiance, unscattered[1], known, account, independent)
        by_cells = ByCells.of(image, target, scene.receiver, *of_rays)
    left_out = None if accuracy is None else _reason_without_cells(scene, by_cells, corrected)
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
        image_noise=_scatter(error, corrected, irradiance, target),
        share=share,
        by_cells=None if left_out else by_cells,
        left_out=left_out,
        shading=None if accuracy is None else shading_of(scene, heights, seed, pose),
    )


def _reason_without_cells(
    scene: Scene, by_cells: ByCells | None, corrected: CorrectedDistance
) -> Message | None:
    """Why the check has no deterministic figure; None where it has one."""
    scatterer = scatterer_of(scene)
    if scatterer is not None:
        return Message("{what} scatters the light: random rays are used", what=scatterer)
    if by_cells is None:
        return Message("finer cells would take too long: ask for more rays")
    if by_cells.poorer_than(corrected.interval):
        return Message(
            "cells are off by up to {bound:.2g} %, more than random rays: ask for more rays",
            bound=100 * by_cells.bound,
        )
    return None


class _Spread(NamedTuple):
    """What batches of rays say each: their distance to the target, and the part on the receiver."""

    distances: list[float]
    shares: list[float]


def _traced(
    trace: Trace, target: Array, pixel_measure: float | Array, threads: int | None
) -> Steps[tuple[Account, Array, _Spread, Images]]:
    """Where the light of a trace goes, its image, and how its batches differ.

    Where the batches are independent, their images too.
    """
    spread, images = _Spread([], []), []
    total: Tally | None = None
    for batch in trace.batches(threads):
        if batch is not None:
            spread.distances.append(relative_l2(batch.flux.reshape(target.shape), target))
            spread.shares.append(float(batch.flux.sum()) / batch.emitted)
            if trace.sampled:
                images.append(batch.flux.reshape(target.shape).astype(np.float32))
        total = added(total, batch)
        del batch  # large images must not wait for the next ones
        yield trace.part
    assert total is not None
    account = _account(total)
    if account.on_screen == 0:
        raise RunFailed(DARK)
    irradiance = total.flux.reshape(target.shape) / (total.emitted * pixel_measure)
    return account, irradiance, spread, images


def _of_parts(
    batches: Images, references: Sequence[Array], receiver: str
) -> list[CorrectedDistance]:
    """The distance of a file's image to each reference, from images of parts of its rays."""
    found = [CorrectedDistance.of_pairs(batches, reference) for reference in references]
    if math.isinf(found[0].off):
        few = Message(
            "so few rays of the file come to the {receiver} that some of {parts} parts of them "
            "make no image: the check needs a file of more rays",
            parts=BATCHES,
            receiver=receiver,
        )
        raise RunFailed(few)
    return found


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


def _scatter(error: float, corrected: CorrectedDistance, image: Array, target: Array) -> float:
    """Norm of the scatter of an image over that of the image, from its error with and without."""
    size = float(np.linalg.norm(target) / target.sum() * image.sum() / np.linalg.norm(image))
    return root(error**2 - corrected.square) * size


def _account(tally: Tally) -> Account:
    """The account of all light, as parts of what was emitted."""
    lost = {"off_screen": float(tally.beside.sum()), **tally.lost}
    parts = {name: flux / tally.emitted for name, flux in lost.items()}
    return Account(float(tally.flux.sum()) / tally.emitted, parts)


def _another(seed: int) -> int:
    """A seed for rays that have nothing to do with those of this one."""
    return int(np.random.SeedSequence([seed, 1000]).generate_state(1, np.uint64)[0])
