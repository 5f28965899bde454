"""A row for what may be left out of the scene: faintly it tells what then counts."""

from collections.abc import Callable, Sequence, Set
from typing import Any

from ui.panels.edits import holder_of, value_at
from ui.panels.fields import NumberRow, Row
from workbench.scene import Measure


class OptionalRow(NumberRow):
    """A number, or two of them, that may be left empty.

    Parameters
    ----------
    stand_in : callable
        The numbers that count instead, of a scene or plain data, or words where none does; shown
        faintly.
    """

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        measure: Measure,
        stand_in: Callable[[Any], Sequence[float | str]],
        between: str = "",
        count: int = 2,
        whole: bool = False,
    ) -> None:
        super().__init__(path, label, tip, measure, between, count, whole)
        self._stand_in = stand_in

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        """Show the scene's numbers, or none, before what stands in for them."""
        Row.show_scene(self, scene, pending)
        stand_ins = self._stand_in(scene)
        for (path, editor), stand_in in zip(self.editors.items(), stand_ins, strict=True):
            faint = stand_in if isinstance(stand_in, str) else format(stand_in, "g")
            editor.setPlaceholderText(faint)
            if path not in pending:
                value = value_at(scene, path)
                editor.show_value("" if value is None else format(value, ".12g"))

    def _is_there(self, scene: Any) -> bool:
        return holder_of(scene, self.path)[0] is not None

    def _commit(self, path: str, text: str) -> None:
        if not text.strip():
            self._tell(path, {self.path: None})
        elif path == self.path:
            self._tell(path, {path: self.editors[path].typed(text)})
        else:  # a number alone counts for both
            texts = [editor.text().strip() or text for editor in self.editors.values()]
            values = [e.typed(t) for e, t in zip(self.editors.values(), texts, strict=True)]
            self._tell(path, {self.path: values})
