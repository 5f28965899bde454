"""``freeform inspect``."""

import json
from collections.abc import Iterator, Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

from workbench.analysis.inspection.inspection import (
    AS_DESIGNED,
    Inspection,
    Units,
    corrected_session,
    inspected,
    lighting,
)
from workbench.analysis.inspection.options import InspectionOptions
from workbench.analysis.validation_figures import Validation
from workbench.cli.output import PartProgress
from workbench.design.session import result_of, verified_error
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import read_session, write_session
from workbench.measured.surfaces import MeasuredSurface, PictureScale, read_surface
from workbench.progress import finished
from workbench.reading import opened
from workbench.report.measured import part_rows, repeating_rows

_CORRECTED = "corrected drawing"


def inspect(
    path: Path,
    files: Sequence[Path],
    face: str | None,
    options: InspectionOptions,
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
    surfaces, unit = _read(files, options.pictures), Units(options.unit, options.z_unit)
    found = inspected(session, surfaces, face, unit, options.scale)
    corrected = found.corrected(None if base is None else base.state.heights)
    lenses = found.lenses if output is None else (*found.lenses, corrected)
    with closing(PartProgress("check")) as progress:
        lights = finished(lighting(session, lenses, rays), progress.show)
    if as_json:
        print(json.dumps(_data(found, lights)))
    else:
        for part in found.parts:
            for name, text in part_rows(part, found):
                print(f"{name:<18}{text}")
            print()
        for name, text in repeating_rows(found):
            print(f"{name:<18}{text}")
        names = (AS_DESIGNED, *(f"{part.name} as measured" for part in found.parts), _CORRECTED)
        width = max(map(len, names)) + 2
        print(f"\n{'':{width}}{'error':12}light on the receiver")
        for name, light in zip(names, lights, strict=False):
            error = verified_error(light.verified)
            print(f"{name:{width}}{error:12}{100 * light.efficiency:.2f} %")
    if plot is not None:
        from workbench.pictures.part.inspection import write_inspection  # slow import

        with replacing(plot) as stream:
            write_inspection(stream, found, session.target, lights)
    if output is not None:
        write_session(corrected_session(session, corrected, lights[-1]), output)


def _read(
    files: Sequence[Path], pictures: PictureScale | None
) -> Iterator[tuple[str, MeasuredSurface]]:
    for path in files:
        with opened(path) as file:
            yield str(path), read_surface(path, file, pictures)


def _data(found: Inspection, lights: Sequence[Validation]) -> dict[str, Any]:
    data = found.to_data()
    for light, where in zip(lights, [data, *data["parts"]], strict=False):
        where["relative_l2"] = light.verified.relative_l2_corrected
        where["efficiency"] = light.efficiency
    if len(lights) > len(found.lenses):
        data["corrected_relative_l2"] = lights[-1].verified.relative_l2_corrected
    return data
