"""Figures of a task that are known before the design, and its best possible picture."""

from collections.abc import Generator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from workbench.analysis.light_limit import LightLimit, light_limits
from workbench.arrays import Array
from workbench.design.checks import grazed
from workbench.design.session import Session
from workbench.extended.blur import diffraction
from workbench.extended.bound import Bound, percent
from workbench.jobs.estimate import Estimate, estimating
from workbench.jobs.job import blur_widths
from workbench.jobs.slopes import Slopes, needed_slopes
from workbench.messages import Message
from workbench.powers import written
from workbench.scene import Scene
from workbench.units import sized

_BLACK = 0.01  # parts of a target's peak up to where a pixel is dark
_SMALL = 0.01  # least error that an estimate resolves
_ALL = 0.995  # part of the light that counts as all
_HALF = 0.5  # part of the light below which the lamp is too far away
_STEEP = 0.85  # of the largest deflection, from where much light is reflected


class Figure(NamedTuple):
    """A figure that is known before the design."""

    name: str
    value: str  # with its unit
    meaning: str  # its consequence, in a sentence
    warns: bool = False  # whether the design will fail by it


@dataclass(frozen=True, eq=False)
class Prospect:
    """What can be expected of a task: resolution, slopes, light, and the best image."""

    picture: Array | None  # (n_y, n_x), blurred by the source; None while unknown
    figures: tuple[Figure, ...]


def prospecting(session: Session) -> Generator[Prospect | float | None, None, Prospect]:
    """Find the figures of a task in steps.

    Yields first the figures without the estimate, then the progress of the estimate, then the
    figures with it.
    """
    scene = session.scene
    slopes = needed_slopes(scene, _lit(session))
    light = light_limits(scene)[0]
    known = *_resolved(scene), _steepness(scene, slopes), *_slant(scene), *_caught(scene, light)
    pending = Figure(
        Message("Estimate"), Message("estimating…"), Message("From a coarse design of this task.")
    )
    yield Prospect(None, (pending, *known, _proposal(session)))
    estimated = _estimated(scene, (yield from estimating(session)))
    yield Prospect(None, (estimated, *known, _proposal(session)))
    bound, picture = Bound(scene, session.target), session.target
    if bound.blurred:
        picture = (yield from bound.finding()).image.clip(min=0)
    figures = (
        estimated,
        _light_at_best(bound, light),
        _error_at_best(bound, slopes),
        *known,
        _proposal(session),
    )
    return Prospect(picture, figures)


def _estimated(scene: Scene, estimate: Estimate | None) -> Figure:
    name = Message("Estimate")
    if estimate is None:
        why = (
            Message("No flux arrives in a coarse design of this task.")
            if scene.run.method == "auto"
            else Message("Only designs by the automatic method are estimated.")
        )
        return Figure(name, Message("not known"), why, scene.run.method == "auto")
    value = Message(
        "error {error}, {light:.0f} % of the light {place}",
        error=_range(estimate),
        light=100 * estimate.light,
        place=Message(scene.receiver.place),
    )
    meaning = Message("From a coarse design of this task, with losses and source size.")
    return Figure(name, value, meaning, estimate.most > 10 * _BLACK)


def _range(estimate: Estimate) -> str:
    if estimate.most < _SMALL:
        return f"< {percent(_SMALL)}"
    return f"{percent(estimate.least).removesuffix(' %')} – {percent(estimate.most)}"


def _lit(session: Session) -> tuple[float, float, float, float]:
    bright = session.target > _BLACK * session.target.max()
    left, right, bottom, top = session.scene.receiver.bounds
    n_y, n_x = bright.shape
    columns, rows = (np.flatnonzero(bright.any(axis=axis)) for axis in (0, 1))
    per_column, per_row = (right - left) / n_x, (top - bottom) / n_y
    return (
        left + columns[0] * per_column,
        left + (columns[-1] + 1) * per_column,
        top - (rows[-1] + 1) * per_row,
        top - rows[0] * per_row,
    )


def _resolved(scene: Scene) -> tuple[Figure, ...]:
    unit = scene.receiver.measure.sign_in(scene.unit)
    wide = 2 * min(scene.receiver.half_extent)
    x, y = blur_widths(scene)
    spread = diffraction(scene)
    if max(x, y) == 0:
        blur = Figure(
            Message("Finest detail"),
            Message("none"),
            Message("The source has no size."),
        )
    else:
        same = abs(x - y) < 0.01 * max(x, y)
        value = (
            written(x, unit, 3)
            if same
            else sized(f"{written(x, digits=3)} × {written(y, digits=3)}", unit)
        )
        across, up = np.multiply(2, scene.receiver.half_extent) / max(x, y)
        parts = Message("{across:.0f} × {up:.0f} dots in the image.", across=across, up=up)
        blur = Figure(Message("Finest detail"), value, parts, 10 * max(x, y) > wide)
    law = (
        Message("√(λ · distance)")
        if scene.receiver.at_distance
        else Message("λ / width of the lens")
    )
    return (
        blur,
        Figure(
            Message("Diffraction"),
            written(spread, unit, 2),
            Message("{law}: limit of sharpness, which ray tracing does not include.", law=law),
            20 * spread > wide,
        ),
    )


def _steepness(scene: Scene, slopes: Slopes) -> Figure:
    optic = scene.optic
    name = Message("Largest slope")
    value = Message(
        "{slope:.0f}°, deflection up to {turn:.0f}°", slope=slopes.steepest, turn=slopes.turn
    )
    if not slopes.possible:
        return Figure(
            name,
            Message("a deflection of {turn:.0f}° would be needed", turn=slopes.turn),
            Message(
                "The {optic} deflects by {most:.0f}° at most. Use a smaller image, more "
                "distance or another source position.",
                optic=optic.called,
                most=slopes.most,
            ),
            True,
        )
    if slopes.turn > _STEEP * slopes.most:
        meaning = Message(
            "Near the limit of {most:.0f}° much light is reflected.", most=slopes.most
        )
        return Figure(name, value, meaning, True)
    return Figure(name, value, Message("Limit of the deflection: {most:.0f}°.", most=slopes.most))


def _slant(scene: Scene) -> tuple[Figure, ...]:
    warning = grazed(scene)
    if warning is None:
        return ()
    slant = Message("up to {slant:.0f}°", slant=scene.receiver.slant(scene.optic))
    return (
        Figure(
            Message("Light on the screen"), slant, Message("{sentence}.", sentence=warning), True
        ),
    )


def _caught(scene: Scene, light: LightLimit) -> tuple[Figure, ...]:
    optic, caught = scene.optic, light.meets
    if caught > _ALL:
        return ()
    return (
        Figure(
            Message("Light on the {optic}", optic=optic.called),
            Message("{part:.0f} % of it", part=100 * caught),
            Message(
                "The rest passes it by: a lamp that is nearer, or a larger {optic}, catches more.",
                optic=optic.called,
            ),
            caught < _HALF,
        ),
    )


def _light_at_best(bound: Bound, light: LightLimit) -> Figure:
    """Upper bound of the light on the bright part of the picture."""
    etendue = min(bound.on_receiver, bound.on_target) if bound.certified else 1.0
    meaning = Message("The rest misses the {optic} or is lost at its faces.", optic=_called(bound))
    most = min(light.most, light.turned * etendue)
    limited = most < _ALL * light.turned
    if limited:
        meaning = Message(
            "No more can land where the picture is bright: the light's own image is larger."
        )
    return Figure(
        Message("Light at best"),
        Message("at most {part:.0f} %", part=100 * most),
        meaning,
        limited,
    )


def _error_at_best(bound: Bound, slopes: Slopes) -> Figure:
    """Lower bound of the error, where it is known."""
    name, unknown = Message("Error at best"), Message("not known")
    if not slopes.possible:
        why = Message("The {optic} cannot turn all the light that far.", optic=_called(bound))
        return Figure(name, unknown, why, True)
    if max(bound.blur.widths) == 0 or bound.blur.within_a_pixel:
        return Figure(name, unknown, Message("The size of the light sets no bound."))
    if bound.unknown:
        found = percent(bound.deblurred.error)
        unknown = Message("not known; {error} for the light found", error=found)
        return Figure(name, unknown, Message("{sentence}.", sentence=bound.unknown))
    least = bound.relative_l2
    if least <= 0:
        return Figure(name, unknown, Message("The light is small enough for this picture."))
    why = Message("No lens of this size can be below it; a smaller or farther lamp would help.")
    return Figure(name, percent(least), why, least > 10 * _BLACK)


def _called(bound: Bound) -> str:
    return bound.scene.optic.called


def _proposal(session: Session) -> Figure:
    optic, receiver = session.scene.optic, session.scene.receiver
    n_u, n_v = optic.net_shape
    n_x, n_y = receiver.pixels
    height = abs(optic.leaving_z - optic.front_z)
    net = Message(
        "{n_u} × {n_v} control points, {n_x} × {n_y} pixels", n_u=n_u, n_v=n_v, n_x=n_x, n_y=n_y
    )
    if height:
        net = Message(
            "{height:.3g} {unit} thick, {net}", height=height, unit=session.scene.unit, net=net
        )
    return Figure(Message("Proposed"), net, Message("Can be changed later in the window."))
