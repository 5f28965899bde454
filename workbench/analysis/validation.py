"""An independent check of a lens: fresh random rays, another tracer, the untouched target.

Nothing of the optimiser's path is used: the face comes from `scipy.interpolate`, refraction from
the angles at it, intersections from false position, the image from counting rays in pixels, all in
float64. A lens that is fitted to
the optimiser's fixed ray grid or to its smoothing filter is found out here.
"""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from workbench.analysis.cells import BATCHES
from workbench.analysis.face import Face, Refracted
from workbench.analysis.lights import CollimatedLight, PointLight
from workbench.errors import RunFailed
from workbench.optics.ledger import Ledger
from workbench.scene import CollimatedSource, Scene, Screen

Array = npt.NDArray[np.float64]


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
    efficiency : float
        Part of the emitted flux that lands on the screen.
    ledger : Ledger
        Where the light went.
    rays : int
        Rays traced.
    noise : float
        Monte-Carlo standard error of ``relative_l2``: standard deviation of its value for 16
        batches of the rays, over √16. The batches exclude each other, which makes the image of
        all rays better than this tells: an upper estimate.
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area on the screen, row 0 at +y.
    """

    loss: float
    relative_l2: float
    efficiency: float
    ledger: Ledger
    rays: int
    noise: float
    irradiance: Array


def validate(
    scene: Scene, target: Array, control_points: Array, rays: int = 4_000_000, seed: int = 1
) -> Validation:
    """Trace a lens anew.

    One ray starts at a random place in each of ``rays`` equal cells of the aperture, or in a random
    direction in each of as many equal cells of a point's cone. Memory does not grow with them.

    Parameters
    ----------
    scene : Scene
        Lens, source and screen; filter and run settings play no part.
    target : ndarray, shape (n_y, n_x)
        The wished image in any scale, row 0 at +y.
    control_points : ndarray, shape (n_u, n_v)
        Heights z of the exit face's control points, scene units.
    rays : int
        Rays to trace at least; rounded up to whole batches of a grid.
    seed : int
        The same seed gives the same rays.

    Raises
    ------
    RunFailed
        If no light reaches the screen.
    """
    screen = scene.screen
    face = Face(scene.lens, control_points)
    kind = CollimatedLight if isinstance(scene.source, CollimatedSource) else PointLight
    light = kind(scene, face, rays, seed)
    wanted = (target / target.max()).ravel()
    wanted /= wanted.sum()

    flux = np.zeros(wanted.size)  # of each pixel
    emitted = missed = entrance = left_side = off_screen = exit_loss = total_reflection = 0.0
    distances = []  # of the batches' images to the target
    for batch in range(BATCHES):
        batch_flux = np.zeros_like(flux)
        for some in light.batch(batch):
            hits = face.refract(some.places, some.height, some.direction, screen.z)
            refracted = some.flux[hits.passes]
            arriving = refracted * (1 - hits.reflectance)
            pixel = _pixels(screen, hits)
            inside = pixel >= 0
            np.add.at(batch_flux, pixel[inside], arriving[inside])
            off_screen += float(arriving[~inside].sum())
            exit_loss += float((refracted * hits.reflectance).sum())
            total_reflection += float(some.flux[~hits.passes].sum())
            emitted += some.emitted
            missed += some.missed_lens
            entrance += some.reflected
            left_side += some.left_side
        flux += batch_flux
        distances.append(_distance(batch_flux, wanted))

    flux /= emitted
    ledger = Ledger(
        emitted=1.0,
        on_screen=float(flux.sum()),
        off_screen=off_screen / emitted,
        missed_lens=missed / emitted,
        left_side=left_side / emitted,
        total_reflection=total_reflection / emitted,
        fresnel_entrance=entrance / emitted,
        fresnel_exit=exit_loss / emitted,
    )
    if ledger.on_screen == 0:
        raise RunFailed("no light of this lens reaches the screen, so there is no image to judge")
    distance = _distance(flux, wanted)
    return Validation(
        loss=distance / math.sqrt(wanted.size),
        relative_l2=distance / float(np.linalg.norm(wanted)),
        efficiency=ledger.efficiency,
        ledger=ledger,
        rays=light.rays,
        noise=float(np.std(distances, ddof=1) / np.linalg.norm(wanted)) / math.sqrt(BATCHES),
        irradiance=flux.reshape(target.shape) / screen.pixel_area,
    )


def _pixels(screen: Screen, hits: Refracted) -> npt.NDArray[np.int64]:
    """Number of the pixel of each ray, counted along the rows; −1 beside the screen."""
    column, row = screen.to_pixels(hits.x, hits.y)
    n_x, n_y = screen.pixels
    inside = (column >= 0) & (column < n_x) & (row >= 0) & (row < n_y)
    column, row = np.where(inside, column, 0), np.where(inside, row, 0)
    return np.where(inside, row.astype(np.int64) * n_x + column.astype(np.int64), -1)


def _distance(flux: Array, wanted: Array) -> float:
    """Frobenius norm of the difference of images that sum to 1; no light counts as a dark image."""
    total = flux.sum()
    return float(np.linalg.norm((flux / total if total > 0 else flux) - wanted))
