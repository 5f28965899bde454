"""Draw scenes, images and curves onto plotters and axes of the caller.

Only the modules of this package import pyvista and matplotlib: a program that draws nothing does
not wait for them.
"""

from collections.abc import Callable, Sequence
from typing import BinaryIO

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.design.session import Session, result_of
from workbench.scene.image import side_in_words, viewed_from
from workbench.system_libraries import keep_shaders_in_memory

_SURFACE_SAMPLES = (129, 129)
_RAYS = (15, 15)
_DPI = 150


def write_images(session: Session, file: BinaryIO) -> None:
    """Draw irradiance, target and signed error of a designed lens as PNG."""
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    from workbench.pictures.images import ErrorImage, IrradianceImage, target_irradiance

    figure = Figure(figsize=(13, 4), layout=ConstrainedLayoutEngine(wspace=0.12))
    lit, wanted, off = figure.subplots(1, 3)
    scene, target, irradiance = session.scene, session.target, result_of(session).state.irradiance
    IrradianceImage(lit, scene, target).update(irradiance)
    flux = scene.receiver.total(irradiance)
    IrradianceImage(wanted, scene, target).update(target_irradiance(scene, target, flux))
    ErrorImage(off, scene, target).update(irradiance)
    density = scene.receiver.density.capitalize()
    for axes, title in ((lit, density), (wanted, "Target"), (off, f"{density} − target")):
        axes.set_title(title, fontsize=10)
    figure.supxlabel(side_in_words(scene, viewed_from(scene)).capitalize(), fontsize=8)
    figure.savefig(file, format="png", dpi=_DPI)


def write_lens(session: Session, file: BinaryIO) -> None:
    """Draw a designed lens with its rays and the lit screen as PNG."""
    from PIL import Image

    lights = [light.irradiance for light in result_of(session).state.lights]
    Image.fromarray(lens_image(session, lights)).save(file, "PNG")


def write_loss(session: Session, file: BinaryIO) -> None:
    """Draw the loss of a designed lens over the iterations as PNG."""
    from matplotlib.figure import Figure

    from workbench.pictures.loss import draw_loss

    result = result_of(session)
    losses, starts = result.losses, result.stage_starts
    figure = Figure(figsize=(7, 4), layout="constrained")
    draw_loss(figure.subplots(), losses, starts, result.state.loss)
    figure.savefig(file, format="png", dpi=_DPI)


PICTURES: dict[str, Callable[[Session, BinaryIO], None]] = {
    "irradiance.png": write_images,
    "lens.png": write_lens,
    "loss.png": write_loss,
}
"""What a design run came to, by file name: each writes one picture of a session with a result."""


def lens_image(
    session: Session, lights: Sequence[Array], explode: bool = False
) -> npt.NDArray[np.uint8]:
    """Draw a designed lens with its rays."""
    keep_shaders_in_memory()
    import pyvista as pv
    from vtkmodules.vtkCommonCore import vtkLogger

    from workbench.geometry.surface import sample_faces
    from workbench.optics.paths import ray_paths
    from workbench.pictures.lens import LensPicture

    scene, heights = session.scene, result_of(session).state.heights
    # Without a display VTK draws in memory; that it looked for one is nobody's concern.
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)
    plotter = pv.Plotter(off_screen=True, window_size=[1600, 1000])
    try:
        picture = LensPicture(plotter, scene, session.target, explode=explode)
        picture.update(
            sample_faces(scene.optics, heights, _SURFACE_SAMPLES),
            ray_paths(scene, heights, _RAYS),
            lights[0],
            further=lights[1:],
        )
        picture.fit()
        return np.asarray(plotter.screenshot(return_img=True))
    finally:
        plotter.close()
