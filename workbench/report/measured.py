"""Figures of photographs of the light and of measured parts, as rows."""

from collections.abc import Sequence
from pathlib import PurePath

from workbench.analysis.inspection.inspection import AS_DESIGNED, Inspection, MeasuredPart
from workbench.analysis.making.photograph import Cause, Photograph
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.design.session import verified_error
from workbench.messages import Message
from workbench.powers import written
from workbench.report.content import Fact
from workbench.report.figures import percent


def photograph_rows(found: Photograph, unit: str) -> tuple[Fact, ...]:
    """Rows of the differences between photograph and prediction, the likeliest causes last."""
    return (
        Fact(
            Message("difference"),
            Message("{part} (relative L2, beside scale and camera)", part=percent(found.apart, 1)),
        ),
        Fact(Message("with causes"), percent(found.left, 1)),
        Fact(
            Message("response"),
            Message("{power:.2f} (1 if the tone is right)", power=found.response),
        ),
        Fact(
            Message("corners"),
            Message("{factor:.2f} times as light as the middle", factor=found.darkening),
        ),
        *((Fact(Message("photograph"), found.turned),) if found.turned else ()),
        *(
            Fact(
                cause.name,
                Message(
                    "{value} ± {off}, explains {part:.0f} %",
                    value=_in_words(cause, cause.value, unit),
                    off=_in_words(cause, cause.off, unit),
                    part=100 * cause.explains,
                ),
            )
            for cause in found.causes
        ),
    )


def _in_words(cause: Cause, value: float, unit: str) -> str:
    if cause.unit == "scene":
        return written(value, unit, 3)
    return percent(value, 1) if cause.unit == "times" else f"{value:.2f}{cause.unit}"


def part_rows(part: MeasuredPart, found: Inspection) -> tuple[Fact, ...]:
    """Rows of a measured part: residual, and where it lies."""
    micrometre, unit = found.micrometre, found.scene.unit
    residual, at = part.residual, part.alignment
    columns, rows = residual.net.shape
    turn = ", ".join(f"{angle:.4g}" for angle in at.placement.rotation_vector)
    shift = ", ".join(f"{place:.6g}" for place in at.placement.shift)
    return (
        Fact(Message("part"), _file(part)),
        Fact(
            Message("points"),
            Message(
                "{count} on {covered} of {face}, {missing} without a height, {spikes} spikes",
                count=len(residual.offsets),
                covered=percent(residual.covered, 1),
                face=found.face.name,
                missing=part.missing,
                spikes=residual.spikes,
            ),
        ),
        Fact(
            Message("residual"),
            Message(
                "{rms:.4g} µm rms, {whole:.4g} µm peak to valley",
                rms=residual.rms / micrometre,
                whole=residual.peak_to_valley / micrometre,
            ),
        ),
        Fact(
            Message("resolved"),
            Message(
                "{rms:.4g} µm rms, slope {slope:.4g} mrad rms, by {columns} × {rows} control "
                "points",
                rms=residual.resolved_rms / micrometre,
                slope=1e3 * residual.slope_rms,
                columns=columns,
                rows=rows,
            ),
        ),
        Fact(Message("rest"), f"{residual.noise / micrometre:.3g} µm rms"),
        Fact(Message("turned by"), f"{turn}° (± {_errors(at.turn_error)})"),
        Fact(
            Message("shifted by"),
            f"{shift} {unit} (± {_errors(at.shift_error / micrometre)} µm)",
        ),
        *(
            (Fact(Message("scale"), f"{at.placement.scale:.7g} (± {at.scale_error:.2g})"),)
            if at.scale_error is not None
            else ()
        ),
    )


def repeating_rows(found: Inspection) -> tuple[Fact, ...]:
    """Rows of what repeats in all parts, and of how much they differ."""
    repeats = Message("{rms:.4g} µm rms", rms=found.repeating_rms / found.micrometre)
    if found.spread is None:
        return (Fact(Message("repeats"), repeats),)
    differs = Message("{rms:.4g} µm rms", rms=found.spread / found.micrometre)
    return Fact(Message("repeats"), repeats), Fact(Message("parts differ by"), differs)


def light_rows(found: Inspection, lights: Sequence[Validation]) -> tuple[Fact, ...]:
    """Rows of the light as designed and of each part: verified error, light on the receiver."""
    parts = [Message("light of {part}", part=_file(part)) for part in found.parts]
    return tuple(
        Fact(
            name,
            Message(
                "{error} verified error, {light} on the receiver",
                error=verified_error(light.verified),
                light=percent(light.efficiency, 2),
            ),
        )
        for name, light in zip((AS_DESIGNED, *parts), lights, strict=True)
    )


def _file(part: MeasuredPart) -> str:
    return PurePath(part.name).name


def _errors(errors: Array) -> str:
    return ", ".join(f"{error:.2g}" for error in errors)
