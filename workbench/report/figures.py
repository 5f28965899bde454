"""Figures of a lens as rows: check, light account, manufacture, tolerances."""

import math
from collections.abc import Sequence

from workbench.analysis.by_cells import ByCells
from workbench.analysis.cross_check import CrossCheck
from workbench.analysis.light_limit import light_limits
from workbench.analysis.manufacture import Extreme, FaceFigures, Manufacture, verdicts
from workbench.analysis.regions import RegionLight
from workbench.analysis.scatter import IndependentError
from workbench.analysis.shading import Shading
from workbench.analysis.shop_limits import Limits
from workbench.analysis.tolerance_fields import ABOUT, PAIRS, Tolerances
from workbench.analysis.tolerances import Distribution
from workbench.analysis.validation_figures import Validation
from workbench.design.session import Checked, verified_error
from workbench.extended.bound import Bound
from workbench.measured.lamps import IN_PARTS, LightUnit
from workbench.messages import Message, capitalised
from workbench.optics.account import Account, words_of
from workbench.powers import written
from workbench.report.content import Fact, Table
from workbench.report.findings import GOALS
from workbench.scene import Element, Scene

_NO_LIMIT = "–"
_STATES = {"met": "met", "broken": "not met", "open": "met where it was looked at"}


def check_rows(
    found: Validation, difference: float, remark: Message | None = None
) -> tuple[Fact, ...]:
    """Rows of the independent check.

    ``difference`` is the relative L2 difference to the optimiser's own image, ``remark`` says
    whether that image is reliable; see `Validation.beside_run`.
    """
    quality, failed = found.quality, found.by_cells and found.by_cells.contradiction
    return (
        *((Fact("check failed", failed),) if failed else ()),
        *((Fact("no deterministic figure", found.left_out),) if found.left_out else ()),
        Fact("verified error", _without_noise(found.verified)),
        *(_cell_rows(found.by_cells, found) if found.by_cells else ()),
        Fact("error with ray noise", _within(found.relative_l2, found.relative_l2_interval)),
        Fact("loss of the paper", written(found.loss)),
        Fact("PSNR", _or_dash(quality.psnr, ".2f", " dB")),
        Fact("SSIM", f"{quality.ssim:.5f}"),
        Fact("correlation", _or_dash(quality.correlation, ".5f")),
        *(() if found.lit_area else (Fact("uniformity", f"{quality.uniformity:.5f}"),)),
        Fact("contrast", _or_dash(quality.contrast, ".5f")),
        Fact("efficiency", percent(found.efficiency)),
        *_shading_rows(found.shading),
        Fact("difference to the optimiser", percent(difference)),
        *((Fact("optimiser and check", remark),) if remark else ()),
        Fact("rays", f"{found.rays:,}"),
    )


def made_rows(found: Validation) -> tuple[Fact, ...]:
    """Rows of the error as designed and after each process, with the share of each."""
    return tuple(
        Fact(
            step.title or Message("error as designed"),
            Message(
                "{error}, {change:+.3f} percentage points by this process ({interval})",
                error=percent(step.error),
                change=100 * step.change,
                interval=_interval(step.interval),
            )
            if step.title
            else _within(step.error, step.interval),
        )
        for step in found.steps
    )


def region_rows(found: Validation) -> tuple[Fact, ...]:
    """Rows of the check for the lit area of the target, and for each region."""
    return tuple(Fact(light.name, light.words) for light in found.areas)


def area_table(found: Validation) -> Table | None:
    """Table of the light of the target's lit area and of each region; None without both."""
    if not found.areas:
        return None
    rows = [(capitalised(light.name), *light.figures.values()) for light in found.areas]
    return Table(("Area", *map(capitalised, found.areas[0].figures)), tuple(rows))


Made = tuple[Element, Manufacture, Limits]
"""An element with its figures and limits for manufacture."""


def result_table(scene: Scene, found: Validation, made: Sequence[Made]) -> Table:
    """Table of what the design reaches, its limits, and whether each limit is met.

    The error is that of all images; the light is that of the image with the least light.
    """
    error = found.verified
    light = min((image.by_cells or image).efficiency for image in found.images)
    rows = [
        _goal_row(
            scene,
            "error",
            ("Relative L2 error", verified_error(error, percent)),
            error.relative_l2_corrected,
        ),
        _goal_row(
            scene, "light", (capitalised(f"light {scene.receiver.place}"), percent(light)), light
        ),
    ]
    for number, image in enumerate(found.images, 1):
        if image.lit_area is not None:
            rows += _uniformity_rows(scene, image.lit_area, number if found.further else 0)
    for element, figures, limits in made:
        of = f" of the {element.name}" if len(made) > 1 else ""
        rows += [
            (
                capitalised(f"{v.name}{of}"),
                written(v.found.value, v.behind(scene.unit).strip(), 5),
                v.wanted(scene.unit),
                _STATES[v.state],
            )
            for v in verdicts(figures, limits)
        ]
    return Table(("Figure", "Result", "Limit", "Limit met"), tuple(rows))


def _goal_row(scene: Scene, key: str, shown: tuple[str, str], value: float) -> tuple[str, ...]:
    goal = GOALS[key]
    limit = goal.of(scene)
    if limit is None:
        return (*shown, _NO_LIMIT, _NO_LIMIT)
    number = f"{100 * limit:g} %" if goal.percent else f"{limit:g}"
    met = goal.judged(scene, value, "bad") == "good"
    wanted = f"at {'most' if goal.at_most else 'least'} {number}"
    return (*shown, wanted, _STATES["met" if met else "broken"])


def _uniformity_rows(scene: Scene, light: RegionLight, image: int) -> list[tuple[str, ...]]:
    """Rows of a lit area; ``image`` is the number of its image, 0 for a single one."""
    where = f" on the {light.name}{f', image {image}' if image else ''}"
    _, average, _, _, even, ends = (
        (f"{capitalised(name)}{where}", text) for name, text in light.figures.items()
    )
    return [
        (*average, _NO_LIMIT, _NO_LIMIT),
        _goal_row(scene, "uniformity", even, light.uniformity or 0.0),
        (*ends, _NO_LIMIT, _NO_LIMIT),
    ]


def _shading_rows(found: Shading | None) -> tuple[Fact, ...]:
    return tuple(Fact(name, text) for name, text in found.figures.items()) if found else ()


def _cell_rows(found: ByCells, by_rays: Validation) -> tuple[Fact, ...]:
    columns, rows = found.cells
    off, over_noise = percent(found.difference), found.difference_over_noise
    size = f"{columns} × {rows}"
    return (
        *(
            (Fact("beam mesh", _with(size, found.less_exact)),)
            if found.independent is None
            else (Fact("beam mesh", size), _independent_row(found.independent, found.less_exact))
        ),
        Fact(
            "difference of random rays",
            f"{off}, –"
            if over_noise is None
            else Message("{off}, {times:.2f} times their noise", off=off, times=over_noise),
        ),
        Fact("error by random rays", _without_noise(by_rays)),
    )


def _independent_row(found: IndependentError, remark: Message | None) -> Fact:
    text = Message("{rays:,} rays, 95 % confidence", rays=found.rays)
    return Fact("error by image pairs", _with(text, remark))


def tracer_rows(found: CrossCheck) -> tuple[Fact, ...]:
    """Rows of the comparison with Mitsuba 3; in pairs, the first is the check."""
    ours, theirs = found.ours, found.mitsuba
    return (
        Fact("difference of both images", percent(found.difference)),
        Fact("by ray noise alone", percent(found.noise)),
        Fact("without ray noise", percent(found.difference_corrected)),
        Fact("95 % confidence", _interval(found.difference_corrected_interval)),
        Fact("error, check and Mitsuba", _pair(ours.relative_l2, theirs.relative_l2)),
        Fact(
            "without ray noise, both",
            _pair(ours.relative_l2_corrected, theirs.relative_l2_corrected),
        ),
        Fact("efficiency, both", _pair(ours.efficiency, theirs.efficiency)),
        Fact("rays of each", f"{found.rays:,}"),
        *((Fact("left out of both", ", ".join(found.left_out)),) if found.left_out else ()),
    )


def _pair(one: float, other: float) -> str:
    return f"{percent(one)} / {percent(other)}"


def bound_rows(found: Bound) -> tuple[Fact, ...]:
    """Rows of the limit of the light, and of the lower bound if the source sets one."""
    limit = Fact("light with any lens, at most", f"{light_limits(found.scene)[0].percent} %")
    if not found.certified:
        return (limit,)
    return (
        limit,
        Fact("no lens is below", percent(found.relative_l2)),
        Fact("a source half as wide would allow", percent(found.half_as_wide)),
        Fact(
            "for that, the source blurs over", "{:.3g} × {:.3g} pixels".format(*found.blur.widths)
        ),
    )


def account_rows(account: Account, scene: Scene, unit: LightUnit = IN_PARTS) -> tuple[Fact, ...]:
    """Rows of the light account, as parts of the emitted flux, and in lumen if known."""
    parts = account.parts_in(scene)
    titles = {part: words_of(part, scene.receiver)[0] for part in parts}
    return tuple(
        Fact(titles[part][:1].lower() + titles[part][1:], _part(flux / account.emitted, unit))
        for part, flux in parts.items()
    )


def _part(share: float, unit: LightUnit) -> str:
    return ", ".join(filter(None, (percent(share), unit.flux_in_words(share))))


def manufacture_rows(found: Manufacture, limits: Limits, unit: str) -> tuple[Fact, ...]:
    """Rows of the manufacturing figures with their bounds, and of the limits."""
    return (
        Fact("thinnest", _extreme(found.thinnest, unit, "at least")),
        Fact("thickest", _extreme(found.thickest, unit, "at most")),
        *_face_rows(found, unit),
        *(() if found.entrance is None else _face_rows(found.entrance, unit, "entrance face: ")),
        *(
            Fact(f"limit of the {v.name}", f"{v.wanted(unit)}: {_STATES[v.state]}")
            for v in verdicts(found, limits)
        ),
    )


def _face_rows(found: FaceFigures, unit: str, face: str = "") -> tuple[Fact, ...]:
    return (
        Fact(f"{face}steepest slope", _extreme(found.steepest, "°", "at most")),
        Fact(f"{face}draft", f"{found.draft:.3f}°"),
        Fact(f"{face}smallest concave radius", _extreme(found.tightest_concave, unit, "at least")),
        Fact(f"{face}smallest convex radius", _extreme(found.tightest_convex, unit, "at least")),
        Fact(f"{face}ball cutter up to", _extreme(found.tool_radius, unit, "at least")),
        Fact(f"{face}sag range", written(found.sag_range, unit, 6)),
    )


def tolerance_rows(
    scene: Scene, within: Tolerances, spread: Distribution, samples: int
) -> tuple[Fact, ...]:
    """Rows of the tolerances and the distribution of the error without ray noise."""
    return (
        *(
            Fact(ABOUT[name].row, _error_size(name, within, scene.unit))
            for name, size in within.sizes.items()
            if size
        ),
        Fact("lenses", str(samples)),
        Fact("error as designed", percent(spread.nominal)),
        Fact("mean", percent(spread.mean)),
        *(Fact(f"{part} % of lenses", percent(e)) for part, e in spread.percentiles.items()),
        Fact("worst", percent(spread.worst)),
    )


def _error_size(name: str, within: Tolerances, unit: str) -> str:
    about, value = ABOUT[name], getattr(within, name)
    sizes = value if name in PAIRS else (value,)
    return " over ".join(about.shown(size, unit) for size in sizes)


def percent(fraction: float, digits: int = 3) -> str:
    """A fraction in per cent, with a space before the sign."""
    return f"{100 * fraction:.{digits}f} %"


def _extreme(found: Extreme, unit: str, sense: str) -> str:
    if math.isinf(found.value):
        return "none"
    x, y = found.place
    value = written(found.value, unit, 5)
    return f"{value} at ({written(x)}, {written(y)}); {sense} {written(found.bound, unit, 5)}"


def _without_noise(found: Checked) -> str:
    interval = found.relative_l2_corrected_interval
    if interval[0] == 0:
        return verified_error(found, percent)
    return _within(found.relative_l2_corrected, interval)


def _within(error: float, interval: tuple[float, float]) -> Message:
    return Message("{error} ({interval})", error=percent(error), interval=_interval(interval))


def _interval(ends: tuple[float, float]) -> Message:
    return Message("{low} to {high}", low=percent(ends[0]), high=percent(ends[1]))


def _with(figure: str, remark: Message | None) -> str:
    return figure if remark is None else Message("{figure}; {remark}", figure=figure, remark=remark)


def _or_dash(value: float | None, form: str, tail: str = "") -> str:
    return "–" if value is None else f"{value:{form}}{tail}"
