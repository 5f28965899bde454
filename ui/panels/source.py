"""Where the light comes from."""

import math
from collections.abc import Callable
from typing import Any

from ui.panels.edits import value_at
from ui.panels.fields import LENGTH, CheckRow, ChoiceRow, NumberRow, Row
from ui.panels.optional import KindRow
from ui.panels.panel import Panel
from workbench.scene import Lens, Scene

# A new source stands this many lens half-widths before the entrance face.
_DISTANCE = 5.0
# What a point source and a grid of them have in common; an exchange keeps it.
_COMMON = ("emission", "sampling", "fresh", "intersection")


class SourcePanel(Panel):
    """Bound to ``scene.source``."""

    def __init__(self) -> None:
        super().__init__("Source", source_rows("source", lambda: self.session.scene))


def source_rows(
    path: str, task: Callable[[], Scene], label: str = "Kind", otherwise: str = ""
) -> list[Row]:
    """Rows of a source.

    Parameters
    ----------
    path : str
        Where it is in the scene.
    task : callable
        The scene as the source lights it; another kind begins where its source is.
    label : str
        What stands before its kind.
    otherwise : str
        What a person reads for there being none, where one may be left out.
    """
    return [
        KindRow(
            path,
            label,
            "Collimated: parallel light along the optical axis that fills the entrance "
            "face. Point: light from one point into the cone that just covers the "
            "entrance face. Grid: many such points, standing for a source of some size.",
            [("collimated", "Collimated"), ("point", "Point"), ("grid", "Grid of points")],
            lambda kind: _begun(kind, task()),
            otherwise,
        ),
        NumberRow(
            f"{path}.position",
            "Position",
            "Where the point is: x, y and z. It has to stand before the entrance face; "
            "off the axis it lights the lens askew.",
            LENGTH,
            between=",",
            count=3,
        ),
        NumberRow(
            f"{path}.center",
            "Centre",
            "The middle of the grid: x, y and z. All points have the same z, before the "
            "entrance face.",
            LENGTH,
            between=",",
            count=3,
        ),
        NumberRow(
            f"{path}.half_width",
            "Half width",
            "Half of the grid's extent along x and y. No detail of the image can be "
            "sharper than the image that the lens makes of this.",
            LENGTH,
            between="×",
        ),
        NumberRow(
            f"{path}.points",
            "Points",
            "Points along x and y, the outer ones on the rim. More of them come closer "
            "to an evenly bright source.",
            between="×",
            whole=True,
        ),
        NumberRow(
            f"{path}.rays",
            "Rays",
            "Rays traced along x and y in each iteration. More rays give a smoother "
            "image and take longer; at least two per pixel and axis are good.",
            between="×",
            whole=True,
            present=_of_kind(path, "collimated"),
        ),
        NumberRow(
            f"{path}.rays",
            "Rays",
            "Rays traced in each iteration, those that miss the lens included. More give "
            "a smoother image and take longer; at least four per pixel are good.",
            whole=True,
            present=_of_kind(path, "point"),
        ),
        _RaysEachRow(path),
        ChoiceRow(
            f"{path}.emission",
            "Emission",
            "Uniform: equally bright in all directions, as a small bulb. Lambertian: "
            "dimmer away from the optical axis, as the surface of an LED.",
            [("uniform", "Uniform"), ("lambertian", "Lambertian")],
        ),
        ChoiceRow(
            f"{path}.sampling",
            "Sampling",
            "How directions are drawn. Low discrepancy (Sobol) spreads them evenly and "
            "needs far fewer rays; random is noisier, as in the paper.",
            [("sobol", "Low discrepancy"), ("random", "Random")],
        ),
        CheckRow(
            f"{path}.fresh",
            "Fresh rays",
            "Draw new rays for each iteration of the paper's method, so that the lens "
            "cannot fit itself to one set of them. Automatic compares lenses by the same "
            "rays and does not have this.",
            present=lambda data: _can_be_fresh(data, path),
        ),
        ChoiceRow(
            f"{path}.intersection.method",
            "Intersection",
            "How it is found where a ray meets the exit face. Exact: on the B-spline "
            "itself, fast and without an error of its own. Triangle mesh: as in the "
            "paper, for comparison.",
            [("exact", "Exact"), ("mesh", "Triangle mesh")],
            changes=lambda choice: {f"{path}.intersection": {"method": choice}},
        ),
        NumberRow(
            f"{path}.intersection.subdivisions",
            "Subdivisions",
            "Parts along x and y that each knot span is cut into, two triangles each. "
            "Twice as many make a quarter of the error, and four times the triangles.",
            between="×",
            whole=True,
        ),
    ]


class _RaysEachRow(NumberRow):
    """Rays of each point of a grid, and how many that are in all."""

    def __init__(self, path: str) -> None:
        super().__init__(
            f"{path}.rays",
            "Rays per point",
            "Rays from each point of the grid. What they add up to makes the image smooth; "
            "few from each of many points are enough.",
            whole=True,
            present=_of_kind(path, "grid"),
        )
        self._source = path

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show the scene's number and the sum."""
        super().show_scene(data, pending)
        source = value_at(data, self._source)
        in_all = math.prod(source["points"]) * source["rays"]
        self.set_unit(f"= {in_all:,} in all")


def _begun(kind: str, task: Scene) -> dict[str, object]:
    """A source of another kind, as like the task's own as it can be."""
    if kind == "collimated":
        return {"kind": kind}
    data = task.to_data()["source"]
    kept = {name: data[name] for name in _COMMON if name in data}
    at = data.get("position") or data.get("center") or _place(task.lens)
    if kind == "point":
        return {"kind": kind, "position": at, **kept}
    half_width = [r / 2 for r in task.lens.half_width]
    grid = {"center": at, "half_width": half_width, "points": [25, 25]}
    return {"kind": kind, **grid, **kept}


def _place(lens: Lens) -> list[float]:
    """On the axis, far enough away for the lens to bend all its light."""
    return [0.0, 0.0, lens.entrance_z - _DISTANCE * max(lens.half_width)]


def _of_kind(path: str, kind: str) -> Callable[[dict[str, Any]], bool]:
    return lambda data: bool(value_at(data, f"{path}.kind") == kind)


def _can_be_fresh(data: dict[str, Any], path: str) -> bool:
    """Whether the source has the choice, and the method that lights with it heeds it."""
    stage = value_at(data, path.rpartition(".")[0]) or {}
    method = stage.get("method", data["run"]["method"])
    return value_at(data, f"{path}.fresh") is not None and method == "paper"
