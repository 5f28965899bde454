"""``freeform photograph``."""

import json
from contextlib import closing
from pathlib import Path

from workbench.analysis.making.photograph import Cause, Corner, comparing
from workbench.cli.output import PartProgress
from workbench.design.session import result_of
from workbench.files.session import read_session
from workbench.powers import written
from workbench.progress import finished
from workbench.targets.colour import TONES
from workbench.targets.image import read_picture


def photograph(
    path: Path, picture: Path, corners: tuple[Corner, ...], tone: str, as_json: bool
) -> None:
    """Print how a photograph differs from the predicted light, and the likely causes.

    Raise Refused if the session has no lens, the photograph cannot be read, or the picture is not
    within the corners.
    """
    session = read_session(path)
    heights = result_of(session, str(path)).state.heights
    light = read_picture(picture, tone=TONES[tone]).light
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
        return
    print(f"{'difference':<18}{100 * found.apart:.1f} %  (relative L2, beside scale and camera)")
    print(f"{'with causes':<18}{100 * found.left:.1f} %")
    print(f"{'response':<18}{found.response:.2f}  (1 if the tone is right)")
    print(f"{'corners':<18}{found.darkening:.2f} times as light as the middle")
    if found.turned:
        print(f"{'photograph':<18}{found.turned}")
    print("\nlikely causes, with statistical errors")
    for cause in found.causes:
        value, off = _in_words(cause, cause.value, unit), _in_words(cause, cause.off, unit)
        print(f"{cause.name:<18}{value} ± {off}  (explains {100 * cause.explains:.0f} %)")


def _in_words(cause: Cause, value: float, unit: str) -> str:
    if cause.unit == "scene":
        return written(value, unit, 3)
    return f"{100 * value:.1f} %" if cause.unit == "times" else f"{value:.2f}{cause.unit}"
