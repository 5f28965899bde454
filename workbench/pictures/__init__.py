"""Draws scenes, images and curves onto plotters and axes that the caller owns.

pyvista and matplotlib are imported by the modules in here alone, so whoever needs no picture does
not wait for them.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from workbench.design.snapshot import Result
    from workbench.scene import Scene

_SURFACE_SAMPLES = (129, 129)
_RAYS = (15, 15)
_DPI = 150


class Designed(Protocol):
    """What a session holds."""

    @property
    def scene(self) -> "Scene":
        """The design task."""

    @property
    def target(self) -> npt.NDArray[np.float64]:
        """Wished image, shape (n_y, n_x)."""

    @property
    def result(self) -> "Result | None":
        """The designed lens, if there is one."""


def write_pictures(session: Designed, folder: Path) -> list[Path]:
    """Draw what a design run came to.

    Parameters
    ----------
    session : Designed
        A session with a result.
    folder : Path
        Existing folder; files of the same names are replaced.

    Returns
    -------
    list[Path]
        ``irradiance.png`` (irradiance, target and signed error), ``lens.png`` (the lens with its
        rays and the lit screen) and ``loss.png``. Nothing without a result.

    Raises
    ------
    OSError
        If a picture cannot be written.
    """
    if session.result is None:
        return []
    return [
        _write_images(session, session.result, folder / "irradiance.png"),
        _write_lens(session, session.result, folder / "lens.png"),
        _write_loss(session.result, folder / "loss.png"),
    ]


def _write_images(session: Designed, result: "Result", path: Path) -> Path:
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    from workbench.pictures.images import ErrorImage, IrradianceImage, target_irradiance

    figure = Figure(figsize=(13, 4), layout=ConstrainedLayoutEngine(wspace=0.12))
    lit, wished, off = figure.subplots(1, 3)
    scene, target = session.scene, session.target
    IrradianceImage(lit, scene, target).update(result.irradiance)
    IrradianceImage(wished, scene, target).update(target_irradiance(scene, target))
    ErrorImage(off, scene, target).update(result.irradiance)
    for axes, title in ((lit, "Irradiance"), (wished, "Target"), (off, "Irradiance − target")):
        axes.set_title(title, fontsize=10)
    figure.savefig(path, dpi=_DPI)
    return path


def _write_lens(session: Designed, result: "Result", path: Path) -> Path:
    from PIL import Image

    Image.fromarray(lens_image(session, result.irradiance)).save(path)
    return path


def lens_image(
    session: Designed, irradiance: npt.NDArray[np.float64], explode: bool = False
) -> npt.NDArray[np.uint8]:
    """Draw a designed lens with its rays.

    Parameters
    ----------
    session : Designed
        A session with a result.
    irradiance : ndarray, shape (n_y, n_x)
        Flux per area on the screen.
    explode : bool
        Whether long distances are drawn short.

    Returns
    -------
    ndarray of uint8, shape (height, width, 3)
    """
    import pyvista as pv
    from vtkmodules.vtkCommonCore import vtkLogger

    from workbench.geometry.surface import sample_surface
    from workbench.optics.paths import ray_paths
    from workbench.pictures.lens import LensPicture

    assert session.result is not None
    scene, heights = session.scene, session.result.control_points
    # Without a display VTK draws in memory; that it looked for one is nobody's concern.
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)
    plotter = pv.Plotter(off_screen=True, window_size=[1600, 1000])
    try:
        picture = LensPicture(plotter, scene, session.target, explode=explode)
        picture.update(
            sample_surface(scene.lens, heights, _SURFACE_SAMPLES),
            ray_paths(scene, heights, _RAYS),
            irradiance,
        )
        picture.fit()
        return np.asarray(plotter.screenshot(return_img=True))
    finally:
        plotter.close()


def _write_loss(result: "Result", path: Path) -> Path:
    from matplotlib.figure import Figure

    from workbench.pictures.loss import LossPicture

    figure = Figure(figsize=(7, 4), layout="constrained")
    LossPicture(figure.subplots()).update(result.losses, result.losses.size, result.stage_starts)
    figure.savefig(path, dpi=_DPI)
    return path
