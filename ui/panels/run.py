"""How the design is found, and what it costs."""

from collections.abc import Set
from typing import Any

from PySide6.QtWidgets import QLabel

from ui.panels.fields import Row
from ui.panels.panel import PartPanel
from ui.panels.rows import Make, value_row
from ui.words import tr
from workbench.design.parametrisation import memory_bytes, parameter_count
from workbench.process import as_bytes


class RunPanel(PartPanel):
    """Bound to ``scene.run``."""

    def own_rows(self) -> dict[str, Make]:
        """What is optimised comes with its size."""
        return {"parametrisation": lambda field, path: [value_row(field, path), _SizeRow()]}


class _SizeRow(Row):
    """What a parametrisation costs, known before it is built."""

    def __init__(self) -> None:
        super().__init__(
            "run.parameters",
            tr("Parameters"),
            tr(
                "How many numbers are optimised, and the memory that they take with "
                "their gradient and the optimiser's two moments. A network that does not "
                "fit is refused at the start."
            ),
        )
        self._text = QLabel()
        self._add(self._text)

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        """Show what a scene's parametrisation comes to."""
        self._text.setText(f"{parameter_count(scene):,} ({as_bytes(memory_bytes(scene))})")

    @property
    def text(self) -> str:
        """What is shown."""
        return self._text.text()

    def _is_there(self, scene: Any) -> bool:
        return True
