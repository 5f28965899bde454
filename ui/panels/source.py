"""Where the light comes from."""

import math
from collections.abc import Callable
from typing import Any

from ui.panels.fields import LENGTH, Changes, CheckRow, ChoiceRow, NumberRow
from ui.panels.panel import Panel
from workbench.files.session import Session
from workbench.scene import GridSource, Lens

# A new source stands this many lens half-widths before the entrance face.
_DISTANCE = 5.0
# What a point source and a grid of them have in common; an exchange keeps it.
_COMMON = ("emission", "sampling", "fresh", "intersection")


class SourcePanel(Panel):
    """Bound to ``scene.source``."""

    def __init__(self) -> None:
        self._rays_each = NumberRow(
            "source.rays",
            "Rays per point",
            "Rays from each point of the grid. What they add up to makes the image smooth; "
            "few from each of many points are enough.",
            whole=True,
            present=_of_kind("grid"),
        )
        super().__init__(
            "Source",
            [
                ChoiceRow(
                    "source.kind",
                    "Kind",
                    "Collimated: parallel light along the optical axis that fills the entrance "
                    "face. Point: light from one point into the cone that just covers the "
                    "entrance face. Grid: many such points, standing for a source of some size.",
                    [("collimated", "Collimated"), ("point", "Point"), ("grid", "Grid of points")],
                    changes=self._change_kind,
                ),
                NumberRow(
                    "source.position",
                    "Position",
                    "Where the point is: x, y and z. It has to stand before the entrance face; "
                    "off the axis it lights the lens askew.",
                    LENGTH,
                    between=",",
                    count=3,
                ),
                NumberRow(
                    "source.center",
                    "Center",
                    "The middle of the grid: x, y and z. All points have the same z, before the "
                    "entrance face.",
                    LENGTH,
                    between=",",
                    count=3,
                ),
                NumberRow(
                    "source.half_width",
                    "Half width",
                    "Half of the grid's extent along x and y. No detail of the image can be "
                    "sharper than the image that the lens makes of this.",
                    LENGTH,
                    between="×",
                ),
                NumberRow(
                    "source.points",
                    "Points",
                    "Points along x and y, the outer ones on the rim. More of them come closer "
                    "to an evenly bright source.",
                    between="×",
                    whole=True,
                ),
                NumberRow(
                    "source.rays",
                    "Rays",
                    "Rays traced along x and y in each iteration. More rays give a smoother "
                    "image and take longer; at least two per pixel and axis are good.",
                    between="×",
                    whole=True,
                    present=_of_kind("collimated"),
                ),
                NumberRow(
                    "source.rays",
                    "Rays",
                    "Rays traced in each iteration, those that miss the lens included. More give "
                    "a smoother image and take longer; at least four per pixel are good.",
                    whole=True,
                    present=_of_kind("point"),
                ),
                self._rays_each,
                ChoiceRow(
                    "source.emission",
                    "Emission",
                    "Uniform: equally bright in all directions, as a small bulb. Lambertian: "
                    "dimmer away from the optical axis, as the surface of an LED.",
                    [("uniform", "Uniform"), ("lambertian", "Lambertian")],
                ),
                ChoiceRow(
                    "source.sampling",
                    "Sampling",
                    "How directions are drawn. Low discrepancy (Sobol) spreads them evenly and "
                    "needs far fewer rays; random is noisier, as in the paper.",
                    [("sobol", "Low discrepancy"), ("random", "Random")],
                ),
                CheckRow(
                    "source.fresh",
                    "Fresh rays",
                    "Draw new rays for each iteration of the paper's method, so that the lens "
                    "cannot fit itself to one set of them. Automatic compares lenses by the same "
                    "rays and does not have this.",
                    present=_can_be_fresh,
                ),
                ChoiceRow(
                    "source.intersection.method",
                    "Intersection",
                    "How it is found where a ray meets the exit face. Exact: on the B-spline "
                    "itself, fast and without an error of its own. Triangle mesh: as in the "
                    "paper, for comparison.",
                    [("exact", "Exact"), ("mesh", "Triangle mesh")],
                    changes=self._change_intersection,
                ),
                NumberRow(
                    "source.intersection.subdivisions",
                    "Subdivisions",
                    "Parts along x and y that each knot span is cut into, two triangles each. "
                    "Twice as many make a quarter of the error, and four times the triangles.",
                    between="×",
                    whole=True,
                ),
            ],
        )

    def show_session(self, session: Session, pending: set[str]) -> None:
        """Show the source, and how many rays a grid has in all."""
        super().show_session(session, pending)
        source = session.scene.source
        if isinstance(source, GridSource):
            in_all = math.prod(source.points) * source.rays
            self._rays_each.set_unit(f"= {in_all:,} in all".replace(",", "\N{THIN SPACE}"))

    def _change_kind(self, choice: str) -> Changes:
        scene = self.session.scene
        if choice == scene.source.kind:
            return {}
        if choice == "collimated":
            return {"source": {"kind": choice}}
        data = scene.to_data()["source"]
        kept = {name: data[name] for name in _COMMON if name in data}
        at = data.get("position") or data.get("center") or _place(scene.lens)
        if choice == "point":
            return {"source": {"kind": choice, "position": at, **kept}}
        half_width = [r / 2 for r in scene.lens.half_width]
        grid = {"center": at, "half_width": half_width, "points": [25, 25]}
        return {"source": {"kind": choice, **grid, **kept}}

    def _change_intersection(self, choice: str) -> Changes:
        return {"source.intersection": {"method": choice}}


def _place(lens: Lens) -> list[float]:
    """On the axis, far enough away for the lens to bend all its light."""
    return [0.0, 0.0, lens.entrance_z - _DISTANCE * max(lens.half_width)]


def _of_kind(kind: str) -> Callable[[dict[str, Any]], bool]:
    return lambda data: bool(data["source"]["kind"] == kind)


def _can_be_fresh(data: dict[str, Any]) -> bool:
    return "fresh" in data["source"] and data["run"]["method"] == "paper"
