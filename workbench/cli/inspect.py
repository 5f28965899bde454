"""``freeform inspect``."""

import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

from workbench.analysis.cells.image import ACCURACY
from workbench.analysis.inspection.inspection import (
    Inspection,
    MeasuredPart,
    Units,
    corrected_session,
    inspected,
)
from workbench.analysis.validation import validate
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.cli.output import PartProgress
from workbench.design.session import Session, result_of, verified_error
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import read_session, write_session
from workbench.measured.surfaces import MeasuredSurface, PictureScale, read_surface
from workbench.reading import opened

_DESIGNED, _CORRECTED = "as designed", "corrected drawing"


def inspect(
    path: Path,
    files: Sequence[Path],
    face: str | None,
    unit: Units,
    with_scale: bool,
    pictures: PictureScale | None,
    made_from: Path | None,
    rays: int,
    plot: Path | None,
    as_json: bool,
    output: Path | None,
) -> None:
    """Print how measured parts differ from the lens of a session, and their light.

    Raise Refused if the session has no lens, a measurement does not fit it, or a file cannot be
    written; RunFailed if no light reaches the receiver.
    """
    session = read_session(path)
    result_of(session, str(path))
    base = None if made_from is None else result_of(read_session(made_from), str(made_from))
    for file in filter(None, (plot, output)):
        check_writable(file)
    found = inspected(session, _read(files, pictures), face, unit, with_scale)
    lenses: dict[str, Mapping[str, Array]] = {_DESIGNED: found.heights}
    lenses |= {f"{part.name} as measured": found.as_measured(part) for part in found.parts}
    corrected = found.corrected(None if base is None else base.state.heights)
    if output is not None:
        lenses[_CORRECTED] = corrected
    lights = {name: _check(name, session, heights, rays) for name, heights in lenses.items()}
    if as_json:
        print(json.dumps(_data(found, lights)))
    else:
        for part in found.parts:
            _print(part, found)
        if found.spread is not None:
            print(f"{'parts differ by':<18}{found.spread / found.micrometre:.3g} µm rms")
        width = max(map(len, lights)) + 2
        print(f"\n{'':{width}}{'error':12}light on the receiver")
        for name, light in lights.items():
            error = verified_error(light.verified)
            print(f"{name:{width}}{error:12}{100 * light.efficiency:.2f} %")
    if plot is not None:
        from workbench.pictures.part.inspection import write_inspection  # slow import

        images = {name: light for name, light in lights.items() if name != _CORRECTED}
        with replacing(plot) as stream:
            write_inspection(stream, found, session.target, images)
    if output is not None:
        write_session(corrected_session(session, corrected, lights[_CORRECTED]), output)


def _read(
    files: Sequence[Path], pictures: PictureScale | None
) -> Iterator[tuple[str, MeasuredSurface]]:
    for path in files:
        with opened(path) as file:
            yield str(path), read_surface(path, file, pictures)


def _check(name: str, session: Session, heights: Mapping[str, Array], rays: int) -> Validation:
    with closing(PartProgress(name)) as progress:
        scene, target = session.scene, session.target
        return validate(scene, target, heights, rays, accuracy=ACCURACY, progress=progress.show)


def _data(found: Inspection, lights: Mapping[str, Validation]) -> dict[str, Any]:
    names = [_DESIGNED, *(f"{part.name} as measured" for part in found.parts)]
    data = found.to_data()
    for name, where in zip(names, [data, *data["parts"]], strict=True):
        where["relative_l2"] = lights[name].verified.relative_l2_corrected
        where["efficiency"] = lights[name].efficiency
    if _CORRECTED in lights:
        data["corrected_relative_l2"] = lights[_CORRECTED].verified.relative_l2_corrected
    return data


def _print(part: MeasuredPart, found: Inspection) -> None:
    micrometre, unit = found.micrometre, found.scene.unit
    residual, at = part.residual, part.alignment
    columns, rows = residual.net.shape
    turn = ", ".join(f"{angle:.4g}" for angle in at.placement.rotation_vector)
    shift = ", ".join(f"{place:.6g}" for place in at.placement.shift)
    left_out = f", {part.missing} without a height" if part.missing else ""
    left_out += f", {residual.spikes} spikes" if residual.spikes else ""
    lines = {
        "points": f"{len(residual.offsets)} on {100 * residual.covered:.1f} % of "
        f"{found.face.name}{left_out}",
        "residual": f"{residual.rms / micrometre:.4g} µm rms, "
        f"{residual.peak_to_valley / micrometre:.4g} µm peak to valley",
        "resolved": f"{residual.resolved_rms / micrometre:.4g} µm rms, slope "
        f"{1e3 * residual.slope_rms:.4g} mrad rms, by {columns} × {rows} control points",
        "rest": f"{residual.noise / micrometre:.3g} µm rms",
        "turned by": f"{turn}° (± {_errors(at.turn_error)})",
        "shifted by": f"{shift} {unit} (± {_errors(at.shift_error / micrometre)} µm)",
    }
    if at.scale_error is not None:
        lines["scale"] = f"{at.placement.scale:.7g} (± {at.scale_error:.2g})"
    print(part.name)
    for name, text in lines.items():
        print(f"  {name:<16}{text}")


def _errors(errors: Array) -> str:
    return ", ".join(f"{error:.2g}" for error in errors)
