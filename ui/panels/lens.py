"""The lens: its outline, material, B-spline net and the base that it grows from."""

import math
from typing import Any

import numpy as np

from ui.panels.fields import LENGTH, Changes, ChoiceRow, NumberRow
from ui.panels.optional import OptionalRow
from ui.panels.panel import Panel
from workbench.files.session import Session
from workbench.geometry.surface import ControlNet
from workbench.materials import CATALOGUE

_OWN_INDEX = "index"
_AUTOMATIC, _OWN_RANGE = "automatic", "own"
_HELIUM_D_UM = 0.5876  # the line at which catalogues quote an index


class LensPanel(Panel):
    """Bound to ``scene.lens``."""

    def __init__(self) -> None:
        self._material = ChoiceRow(
            "lens.refractive_index",
            "Material",
            "What the lens is made of: a catalogue material, or an index of your own.",
            [(_OWN_INDEX, "Own index"), *((name, name) for name in CATALOGUE)],
            read=_material,
            changes=self._change_material,
        )
        rows = [
            NumberRow(
                "lens.half_width",
                "Half width",
                "Half of the lens's extent along x and y. All of it is lit.",
                LENGTH,
                between="×",
            ),
            NumberRow(
                "lens.entrance_z",
                "Entrance at z",
                "Where the flat entrance face stands on the optical axis.",
                LENGTH,
            ),
            self._material,
            NumberRow(
                "lens.refractive_index",
                "Index",
                "Refractive index of the lens; the air around it has 1.",
                present=lambda data: _material(data) == _OWN_INDEX,
            ),
            NumberRow(
                "lens.wavelength_um",
                "Wavelength",
                "Vacuum wavelength at which the material's index is taken.",
                "µm",
                present=lambda data: _material(data) != _OWN_INDEX,
            ),
            NumberRow(
                "lens.degree",
                "Degree",
                "Polynomial degree of the exit face's B-spline along x and y, 1 to 7. "
                "3 gives smooth curvature.",
                between="×",
                whole=True,
            ),
            NumberRow(
                "lens.control_points",
                "Control points",
                "Number of control points along x and y. More of them draw finer detail "
                "and take longer.",
                between="×",
                whole=True,
            ),
            ChoiceRow(
                "lens.base.shape",
                "Base",
                "The shape of the exit face before the design; heights are counted from it.",
                [("flat", "Flat"), ("sphere", "Sphere")],
                changes=self._change_base,
            ),
            NumberRow(
                "lens.base.height",
                "Base at z",
                "Where the base crosses the optical axis.",
                LENGTH,
            ),
            NumberRow(
                "lens.base.radius",
                "Base radius",
                "Radius of curvature of the base; more than the lens's half-diagonal.",
                LENGTH,
            ),
            ChoiceRow(
                "lens.base.form",
                "Base form",
                "Concave rises towards the rim, convex falls.",
                [("concave", "Concave"), ("convex", "Convex")],
            ),
            ChoiceRow(
                "lens.height_range",
                "Height range",
                "How far the exit face may be from the base. Automatic takes what the task needs, "
                "between the thinnest and the thickest lens that is allowed.",
                [(_AUTOMATIC, "Automatic"), (_OWN_RANGE, "Own limits")],
                read=_range,
                changes=self._change_range,
            ),
            NumberRow(
                "lens.height_range",
                "From the base",
                "How far a control point may move from the base, down and up. "
                "A wider range bends light further.",
                LENGTH,
                between="to",
            ),
            OptionalRow(
                "lens.max_thickness",
                "Max. thickness",
                "The exit face is at most this far from the entrance face: the thickness of the "
                "stock that the part is made of. Left empty, any will do.",
                lambda data: ["none"],
                LENGTH,
            ),
            NumberRow(
                "lens.min_thickness",
                "Min. thickness",
                "The exit face stays at least this far above the entrance face, "
                "so that the part can be made.",
                LENGTH,
            ),
        ]
        super().__init__("Lens", rows)

    def show_session(self, session: Session, pending: set[str]) -> None:
        """Show the lens, and the index that its material has."""
        super().show_session(session, pending)
        lens = session.scene.lens
        named = isinstance(lens.refractive_index, str)
        self._material.set_unit(f"n = {lens.index:.4f}" if named else "")

    def _change_material(self, choice: str) -> Changes:
        lens = self.session.scene.lens
        if choice == _OWN_INDEX:
            return {"lens.refractive_index": round(lens.index, 6), "lens.wavelength_um": None}
        wavelength = lens.wavelength_um or _HELIUM_D_UM
        return {"lens.refractive_index": choice, "lens.wavelength_um": wavelength}

    def _change_range(self, choice: str) -> Changes | None:
        lens, heights = self.session.scene.lens, self.session.control_points
        if choice == _range(self.session.scene.to_data()):
            return None
        if choice == _AUTOMATIC:
            return {"lens.height_range": None}
        half = 0.3 * max(lens.half_width)
        if heights is not None:
            x, y = ControlNet.of(lens).positions
            off = np.abs(heights - lens.base.height_at(x[:, None], y[None, :]))
            half = max(half, 1.5 * float(off.max()))
        half = float(f"{half:.2g}")
        return {"lens.height_range": [-half, half]}

    def _change_base(self, choice: str) -> Changes:
        lens = self.session.scene.lens
        base: dict[str, object] = {"shape": choice, "height": lens.base.height}
        if choice == "sphere":
            # Shallow enough for any lens that a flat base was good for.
            base["radius"] = float(f"{10 * math.hypot(*lens.half_width):.2g}")
        return {"lens.base": base}


def _range(data: dict[str, Any]) -> str:
    return _AUTOMATIC if data["lens"].get("height_range") is None else _OWN_RANGE


def _material(data: dict[str, Any]) -> str:
    index = data["lens"]["refractive_index"]
    return index if isinstance(index, str) else _OWN_INDEX
