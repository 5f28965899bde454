"""``freeform manufacture``."""

import json
import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from workbench.analysis.manufacture import Extreme, FaceFigures, Manufacture, surface_maps
from workbench.analysis.manufacture import manufacture as compute_figures
from workbench.analysis.manufacture_limits import Limits, Verdict, verdicts
from workbench.design.session import result_of
from workbench.errors import Refused, RunFailed
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import read_session
from workbench.geometry.body import check_body
from workbench.geometry.surface import even_counts, freeform_nets
from workbench.units import sized

# Samples of a map along the longer side of the lens.
_SAMPLES = 513


def manufacture(path: Path, limits: Limits, plot: Path | None, as_json: bool) -> None:
    """Print the manufacturing figures of a session's lens, and whether limits are met.

    Raise Refused if the session has no lens or the plot cannot be written; RunFailed, after
    printing, if a limit is not met or the lens is no solid body.
    """
    session = read_session(path)
    result = result_of(session, str(path))
    scene = session.scene
    if plot is not None:
        check_writable(plot)
    found = compute_figures(scene.optic, result.state.heights)
    if limits.min_thickness is None:
        limits = replace(limits, min_thickness=scene.optic.least_thickness)
    if limits.min_tool_radius is None:
        limits = replace(limits, min_tool_radius=scene.run.min_tool_radius)
    judged = verdicts(found, limits)
    if as_json:
        listed = [v._asdict() | {"found": v.found.to_data()} for v in judged]
        print(json.dumps({"unit": scene.unit} | found.to_data() | {"limits": listed}))
    else:
        _print(found, judged, scene.unit)
    if plot is not None:
        from workbench.pictures.manufacture import write_manufacture  # slow import

        count = even_counts(scene.optic.half_width, _SAMPLES)
        maps = {
            scene.optic.face_in_words(face): surface_maps(
                scene.optic, result.state.heights, count, face
            )
            for face in reversed(freeform_nets(scene.optic))
        }
        with replacing(plot) as file:
            write_manufacture(file, maps, limits, scene.unit)
    broken = [_sentence(v, scene.unit) for v in judged if v.state == "broken"]
    try:
        check_body(scene, result.state.heights)
    except Refused as refused:
        broken.insert(0, str(refused))
    if broken:
        raise RunFailed("; ".join(broken))


def _print(found: Manufacture, judged: Sequence[Verdict], unit: str) -> None:
    print(f"{'':18}{'found':14}{'bound':14}at x, y ({unit})")
    print(_line("thinnest", found.thinnest, unit))
    print(_line("thickest", found.thickest, unit))
    _print_face(found, unit)
    if found.entrance is not None:
        print("entrance face")
        _print_face(found.entrance, unit)
    state = {"met": "met", "broken": "NOT MET", "open": "met where it was looked at"}
    for verdict in judged:
        print(f"{verdict.name} {verdict.wanted(unit)}: {state[verdict.state]}")


def _print_face(found: FaceFigures, unit: str) -> None:
    print(_line("steepest slope", found.steepest, "°"))
    print(_line("concave radius", found.tightest_concave, unit))
    print(_line("convex radius", found.tightest_convex, unit))
    print(_line("ball cutter up to", found.tool_radius, unit))
    print(f"{'sag range':<18}{found.sag_range:.5g} {unit}")
    print(f"{'draft':<18}{found.draft:.5g}°")


def _line(name: str, extreme: Extreme, unit: str) -> str:
    if math.isinf(extreme.value):
        return f"{name:<18}-"
    value, bound = (sized(f"{n:.5g}", unit) for n in (extreme.value, extreme.bound))
    x, y = extreme.place
    return f"{name:<18}{value:<14}{bound:<14}{x:.4g}, {y:.4g}"


def _sentence(verdict: Verdict, unit: str) -> str:
    value = f"{verdict.found.value:.4g}{verdict.behind(unit)}"
    return f"{verdict.name} {value}, {verdict.wanted(unit)} wanted"
