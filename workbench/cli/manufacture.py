"""``freeform manufacture``."""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from workbench.analysis.manufacture import (
    Extreme,
    FaceFigures,
    Manufacture,
    SurfaceMaps,
    Verdict,
    surface_maps,
    verdicts,
)
from workbench.analysis.manufacture import manufacture as compute_figures
from workbench.analysis.shop_limits import Limits
from workbench.arrays import Array
from workbench.design.session import result_of
from workbench.errors import Refused, RunFailed
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import read_session
from workbench.geometry.body import check_body
from workbench.geometry.surface import even_counts, freeform_nets
from workbench.scene import Element
from workbench.units import sized

# Samples of a map along the longer side of the lens.
_SAMPLES = 513


def manufacture(path: Path, limits: Limits, plot: Path | None, as_json: bool) -> None:
    """Print the manufacturing figures of each designed element, and whether limits are met.

    Raise Refused if the session has no lens or the plot cannot be written; RunFailed, after
    printing, if a limit is not met or the lens is no solid body.
    """
    session = read_session(path)
    result = result_of(session, str(path))
    scene = session.scene
    if plot is not None:
        check_writable(plot)
    heights = result.state.heights
    if limits.min_tool_radius is None:
        limits = replace(limits, min_tool_radius=scene.bends.get("min_tool_radius"))
    looked = [_Looked.at(optic, heights, limits) for optic in scene.optics]
    last = looked[-1]
    if as_json:
        data = {"unit": scene.unit, **last.to_data()}
        if len(looked) > 1:
            data["elements"] = {each.optic.name: each.to_data() for each in looked}
        print(json.dumps(data))
    else:
        for each in looked:
            if len(looked) > 1:
                print(each.optic.name)
            _print(each.found, each.judged, scene.unit)
    if plot is not None:
        from workbench.pictures.manufacture import write_manufacture  # slow import

        maps: dict[str, SurfaceMaps] = {
            scene.face_in_words(face): surface_maps(
                optic, heights, even_counts(optic.half_width, _SAMPLES), face
            )
            for optic in reversed(scene.optics)
            for face in reversed(freeform_nets(optic))
        }
        with replacing(plot) as file:
            write_manufacture(file, maps, last.limits, scene.unit)
    broken = [
        f"{each.optic.name}: {_sentence(v, scene.unit)}"
        if len(looked) > 1
        else _sentence(v, scene.unit)
        for each in looked
        for v in each.judged
        if v.state == "broken"
    ]
    try:
        check_body(scene, heights)
    except Refused as refused:
        broken.insert(0, str(refused))
    if broken:
        raise RunFailed("; ".join(broken))


class _Looked(NamedTuple):
    optic: Element
    found: Manufacture
    limits: Limits
    judged: list[Verdict]

    @classmethod
    def at(cls, optic: Element, heights: Mapping[str, Array], limits: Limits) -> "_Looked":
        if limits.min_thickness is None:
            limits = replace(limits, min_thickness=optic.least_thickness)
        found = compute_figures(optic, heights)
        return cls(optic, found, limits, verdicts(found, limits))

    def to_data(self) -> dict[str, Any]:
        listed = [v._asdict() | {"found": v.found.to_data()} for v in self.judged]
        return self.found.to_data() | {"limits": listed}


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
