"""``freeform photograph``."""

import json
from contextlib import closing
from pathlib import Path

from workbench.analysis.making.photograph import Corner, comparing
from workbench.analysis.making.photograph_options import PhotographOptions
from workbench.cli.output import PartProgress
from workbench.design.session import result_of
from workbench.errors import Refused
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import read_session
from workbench.progress import finished
from workbench.report.measured import photograph_rows
from workbench.targets.colour import TONES
from workbench.targets.image import read_picture


def photograph(
    path: Path,
    picture: Path,
    corners: tuple[Corner, ...],
    options: PhotographOptions,
    plot: Path | None,
    as_json: bool,
) -> None:
    """Print how a photograph differs from the predicted light, and the likely causes.

    Raise Refused if the session has no lens, the photograph cannot be read, the picture is not
    within the corners, or the plot cannot be written.
    """
    session = read_session(path)
    heights = result_of(session, str(path)).state.heights
    try:
        light = read_picture(picture, tone=TONES[options.tone]).light
    except Refused as refused:  # whose path is the field of a target
        raise Refused("photograph", refused.reason) from None
    if plot is not None:
        check_writable(plot)
    with closing(PartProgress("photograph")) as progress:
        steps = comparing(session.scene, session.target, heights, light, corners)
        found = finished(steps, progress.show)
    unit = session.scene.unit
    if as_json:
        data = {
            "unit": unit,
            "difference": found.apart,
            "difference_with_causes": found.left,
            "response": found.response,
            "darkening": found.darkening,
            "turned": found.turned or None,
            "causes": [cause.to_data() for cause in found.causes],
        }
        print(json.dumps(data))
    else:
        for name, value in photograph_rows(found, unit):
            print(f"{name:<18}{value}")
    if plot is not None:
        from workbench.pictures.part.photograph import write_photograph  # slow import

        with replacing(plot) as file:
            write_photograph(file, found, session.scene)
