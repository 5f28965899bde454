"""The regions of a scene: a list of them, and the settings of the one that is chosen."""

from collections.abc import Set
from typing import Any

from ui.panels.fields import Row, TextRow
from ui.panels.listed import ListedPanel
from ui.panels.region_list import RegionListRow
from ui.panels.rows import Rows
from ui.words import tr
from workbench.files.session import Session
from workbench.scene import FieldDescription, Kinds


class RegionsPanel(ListedPanel):
    """Bound to ``scene.regions``."""

    def __init__(self, field: FieldDescription) -> None:
        self._field = field
        self._list = RegionListRow(tr("Watched"), tr(field.tip))
        super().__init__(tr(field.title), self._list)

    def show_list(self, session: Session) -> None:
        """List the regions of the scene."""
        self._list.show_regions(session.scene)

    def name_of(self, number: int) -> str:
        """Its number, from 1."""
        return tr("Region {number}").format(number=number + 1)

    def rows_of(self, number: int) -> list[Row]:
        """Shape, place and size of a region."""
        kinds = self._field.mark(Kinds)
        assert kinds is not None  # they are of several kinds
        rows = Rows(lambda: self.session.scene, {"corners": _corner_rows})
        return rows.of_kinds(self._field, kinds, f"regions[{number}]", tr("Shape"))


class CornersRow(TextRow):
    """Places as text: two numbers each, with a semicolon between places."""

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        """Show the scene's places, the first ones where there is no room for all."""
        super().show_scene(scene, pending)
        if self.path not in pending:
            self.editor.home(False)

    def text_of(self, value: Any) -> str:
        """Numbers and semicolons."""
        return "; ".join(f"{x:.6g}, {y:.6g}" for x, y in value)

    def value_of(self, text: str) -> object:
        """Numbers of places; the text itself where it has others, which the scene refuses."""
        try:
            return [[float(number) for number in place.split(",")] for place in text.split(";")]
        except ValueError:
            return text


def _corner_rows(field: FieldDescription, path: str) -> list[Row]:
    """Places are typed as one line."""
    return [
        CornersRow(
            path,
            tr(field.title),
            f"{tr(field.tip)} {tr('As x, y; x, y; …')}",
            measure=field.measure,
        )
    ]
