"""A row for numbers that the program may choose: faintly it shows what it took."""

from collections.abc import Set
from typing import Any

from PySide6.QtWidgets import QCheckBox

from ui.panels.edits import value_at
from ui.panels.fields import NumberRow, Row
from ui.words import tr
from workbench.scene import AutoNet, Measure
from workbench.scene.auto_net import AUTO


class AutoRow(NumberRow):
    """Numbers, or a tick that leaves them to the program.

    A number that is typed takes the tick away, and no number brings it back.
    """

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        measure: Measure,
        between: str = "",
        count: int = 2,
        whole: bool = False,
    ) -> None:
        super().__init__(path, label, tip, measure, between, count, whole)
        self.box = QCheckBox(tr("Auto"))
        self.box.setAccessibleName(tr("{label}, automatic").format(label=label))
        self.box.setToolTip(f"<p>{tip}</p>")
        self._editors.addWidget(self.box)
        self._shape: tuple[int, ...] | None = None  # what counts now
        self._auto = False
        self.box.clicked.connect(self._choose)

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        """Show the scene's numbers, or what the program has chosen."""
        Row.show_scene(self, scene, pending)
        self._unit.hide()  # what was chosen stands in the fields
        value = value_at(scene, self.path)
        self._auto = auto = isinstance(value, AutoNet)
        # An entrance face takes what the exit face has.
        self._shape = (value.shape or scene.optic.known_shape) if auto else value
        if self.path not in pending:
            self.box.setChecked(auto)
        numbers = self._shape or (tr("auto"),) * len(self.editors)
        for (path, editor), number in zip(self.editors.items(), numbers, strict=True):
            editor.setPlaceholderText(str(number))
            if not pending & {path, self.path}:
                editor.show_value("" if auto else str(number))

    def _choose(self, auto: bool) -> None:
        """Take the numbers that count now, or leave them to the program."""
        self._tell(self.path, {self.path: AUTO if auto or self._shape is None else [*self._shape]})

    def _commit(self, path: str, text: str) -> None:
        texts = [editor.text().strip() for editor in self.editors.values()]
        if not text.strip():
            self._tell(self.path, {self.path: AUTO})
        elif all(texts) and not self._auto:
            self._tell(path, {path: self.editors[path].typed(text)})
        else:  # a number alone counts for both
            values = [e.typed(t or text) for e, t in zip(self.editors.values(), texts, strict=True)]
            self._tell(self.path, {self.path: values})
