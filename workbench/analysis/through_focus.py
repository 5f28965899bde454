"""Light of a lens on screens elsewhere, by the rays of the independent check."""

from collections.abc import Mapping, Sequence

from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import Tally
from workbench.arrays import Array
from workbench.progress import Progress, no_progress
from workbench.scene import Scene


def through_focus(
    scene: Scene,
    heights: Mapping[str, Array],
    distances: Sequence[float] | None,
    rays: int = 1_000_000,
    seed: int = 1,
    progress: Progress = no_progress,
) -> Array:
    """Irradiance on screens at several distances, from one trace.

    `distances`: z of each screen; None stands for the scene's receiver alone. Returns (k, n_y,
    n_x): flux per area on each of the k screens, row 0 at +y. Raises `Refused` if a screen may
    touch the lens, or the lens is no body.
    """
    for z in distances or ():
        with_screen_at(scene, z)
    trace = Trace(scene, heights, rays, seed, distances=distances)
    total: Tally | None = None
    for batch in trace.batches():
        total = added(total, batch)
        del batch
        progress(trace.part)
    assert total is not None
    n_x, n_y = scene.receiver.pixels
    images: Array = total.flux.reshape(-1, n_y, n_x)
    images /= total.emitted * scene.receiver.pixel_measure
    return images


def with_screen_at(scene: Scene, z: float) -> Scene:
    """The scene with its screen elsewhere.

    Raises `Refused` if the screen may touch the lens there, or the receiver is at no distance.
    """
    there = scene.with_receiver(scene.receiver.moved_to(z))
    there.check()
    return there
