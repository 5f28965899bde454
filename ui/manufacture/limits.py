"""What a shop can make: limits that a person gives, kept for all designs of the same unit."""

import math
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, QSettings, Signal

from ui.panels.edits import Edit, Typed
from ui.panels.optional import OptionalRow
from ui.words import later, tr
from workbench.analysis.manufacture_limits import Limits
from workbench.scene import LENGTH, Measure, Scene

_ROWS = later(
    {
        "min_thickness": ("Thinnest", "The part has to be as thick as this everywhere"),
        "max_thickness": ("Thickest", "The part must not be thicker than this anywhere"),
        "max_slope": (
            "Slope",
            "Largest angle between a freeform face and a plane across the axis, in degrees",
        ),
        "min_radius": (
            "Concave radius",
            "Smallest radius that a tool can cut, of concave and convex places",
        ),
        "min_tool_radius": (
            "Largest ball that fits",
            (
                "Radius of the ball cutter that has to reach every place of the face. One that is "
                "too large for a hollow leaves material standing there"
            ),
        ),
    }
)
_ANGLE = "max_slope"
_HINT = later("Empty: what the design task keeps to, if anything. Kept for the next start.")


class LimitFields(QObject):
    """A field for each limit. An empty one stands for the limit that the design keeps to.

    Parameters
    ----------
    settings : QSettings
        Where limits outlive the window. Lengths are kept for each unit by itself.

    Attributes
    ----------
    rows : dict of str to OptionalRow
        By the names of `Limits`; to be put somewhere.
    changed : Signal(Limits)
        Other ones count.
    """

    changed = Signal(object)

    def __init__(self, settings: QSettings, parent: QObject) -> None:
        super().__init__(parent)
        self._settings = settings
        self._scene: Scene | None = None
        self.rows = {
            name: OptionalRow(
                name,
                tr(label),
                f"{tr(tip)}. {tr(_HINT)}",
                Measure("°") if name == _ANGLE else LENGTH,
                partial(self._stand_in, name),
            )
            for name, (label, tip) in _ROWS.items()
        }
        for name, row in self.rows.items():
            row.editors[name].setAccessibleName(tr("Limit: {label}").format(label=row.label.text()))
            row.edited.connect(self._take)
            row.reverted.connect(self._revert)

    @property
    def limits(self) -> Limits:
        """Those that count now."""
        own = self._own()
        return Limits(**{name: self._kept(name) or own[name] for name in self.rows})

    def show_scene(self, scene: Scene) -> None:
        """Take unit and own limits of another design."""
        before, self._scene = self._scene, scene
        if before is None or before.unit != scene.unit:
            for row in self.rows.values():
                row.refuse("")
        self._show()
        self.changed.emit(self.limits)

    def _take(self, edit: Edit) -> None:
        row, value = self.rows[edit.path], None
        typed = edit.changes[edit.path]
        if isinstance(typed, Typed):
            try:
                value = float(typed.number(self._unit))
            except ValueError as error:
                row.refuse(f"{error}")
                return
            if not 0 < value < math.inf:
                row.refuse(tr("{value:g}; a number above 0, or nothing").format(value=value))
                return
        row.refuse("")
        self._settings.setValue(self._key(edit.path), "" if value is None else repr(value))
        self._show()
        self.changed.emit(self.limits)

    def _revert(self, path: str) -> None:
        self.rows[path].refuse("")
        self._show()

    def _show(self) -> None:
        pending = {name for name, row in self.rows.items() if row.refusal}
        data: dict[str, Any] = {name: self._kept(name) for name in self.rows}
        data["unit"] = self._unit
        for row in self.rows.values():
            row.show_scene(data, pending)

    @property
    def _unit(self) -> str:
        return "" if self._scene is None else self._scene.unit

    def _kept(self, name: str) -> float | None:
        try:
            value = float(str(self._settings.value(self._key(name), "")))
        except ValueError:  # none, or not this program's
            return None
        return value if 0 < value < math.inf else None

    def _key(self, name: str) -> str:
        unit = f"{self._unit}/" if self._unit and name != _ANGLE else ""
        return f"manufacture/{unit}{name}"

    def _own(self) -> dict[str, float | None]:
        own: dict[str, float | None] = dict.fromkeys(self.rows)
        if self._scene is not None:
            own["min_thickness"] = self._scene.optic.least_thickness or None
            own["min_radius"] = self._scene.run.min_radius
            own["min_tool_radius"] = self._scene.run.min_tool_radius
        return own

    def _stand_in(self, name: str, _: dict[str, Any]) -> list[float | str]:
        own = self._own()[name]
        return [tr("none") if own is None else own]
