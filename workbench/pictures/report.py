"""Pictures of a report, drawn on figures that the caller owns."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from workbench.arrays import Array
from workbench.design.session import Session, result_of
from workbench.geometry.surface import freeform_nets
from workbench.pictures import lens_image
from workbench.pictures.images import ErrorImage, IrradianceImage, target_irradiance
from workbench.pictures.loss import LossPicture
from workbench.pictures.manufacture import draw_manufacture
from workbench.pictures.section import SectionCurves, cut_through
from workbench.pictures.surface import ASPECTS, SurfaceImage
from workbench.pictures.tolerances import draw_errors

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

    from workbench.design.snapshot import Result

__all__ = [
    "draw_images",
    "draw_lens",
    "draw_loss",
    "draw_manufacture",
    "draw_sections",
    "draw_tolerances",
    "draw_two_tracers",
]

_FONT = 9
_APART = {"wspace": 0.12, "hspace": 0.03}


def draw_lens(figure: "FigureBase", session: Session, lights: Sequence[Array]) -> None:
    """Draw the lens with its rays, long distances short, and each receiver lit by an image."""
    axes = figure.subplots()
    axes.imshow(lens_image(session, lights, explode=True), interpolation="antialiased")
    axes.set_axis_off()


def draw_images(figure: "FigureBase", session: Session, irradiance: Array) -> None:
    """Draw irradiance, target, signed error and the height of each face over its place."""
    scene, target, result = session.scene, session.target, result_of(session)
    faces = list(reversed(freeform_nets(scene.optic)))
    lit, wanted, off, *others = figure.subplots(1 + len(faces), 2, gridspec_kw=_APART).ravel()
    IrradianceImage(lit, scene, target).update(irradiance)
    IrradianceImage(wanted, scene, target).update(
        target_irradiance(scene, target, scene.receiver.total(irradiance))
    )
    ErrorImage(off, scene, target).update(irradiance)
    density = scene.receiver.density.capitalize()
    titles = [density, "Target", f"{density} − target"]
    for axes, face in zip(others, faces, strict=False):
        SurfaceImage(axes, scene, ASPECTS[0], face).update(result.state.heights[face])
        titles.append(f"{scene.optic.face_in_words(face)} over its base".capitalize())
    for axes, title in zip((lit, wanted, off, *others), titles, strict=False):
        axes.set_title(title, fontsize=_FONT)
    for axes in others[len(faces) :]:
        axes.set_axis_off()


def draw_sections(figure: "FigureBase", session: Session, irradiance: Array) -> None:
    """Draw light and target along x and y through the middle of the receiver."""
    for axes, along in zip(figure.subplots(1, 2, gridspec_kw=_APART), "xy", strict=True):
        curves = SectionCurves(axes, session.scene, session.target)
        middle = session.scene.receiver.middle
        curves.update(irradiance, cut_through(session.scene, along, middle))


def draw_two_tracers(figure: "FigureBase", session: Session, ours: Array, mitsuba: Array) -> None:
    """Draw irradiance in two tracers, their difference at the same flux, and the target."""
    scene, target = session.scene, session.target
    density, flux = scene.receiver.density.capitalize(), scene.receiver.total(ours)
    panels = figure.subplots(2, 2, gridspec_kw=_APART).ravel()
    for axes, irradiance in zip(
        panels[[0, 1, 3]], (ours, mitsuba, target_irradiance(scene, target, flux)), strict=True
    ):
        IrradianceImage(axes, scene, target).update(irradiance)
    ErrorImage(panels[2], scene, ours).update(mitsuba)
    titles = f"{density}, check", f"{density}, Mitsuba 3", "Mitsuba 3 − check", "Target"
    for axes, title in zip(panels, titles, strict=True):
        axes.set_title(title, fontsize=_FONT)


def draw_loss(figure: "FigureBase", result: "Result") -> None:
    """Draw the loss over the iterations."""
    picture = LossPicture(figure.subplots())
    picture.update(result.losses, result.losses.size, result.stage_starts)


def draw_tolerances(figure: "FigureBase", nominal: float, errors: Sequence[float]) -> None:
    """Draw the distribution of the error over lenses that are off."""
    draw_errors(figure.subplots(), nominal, errors)
