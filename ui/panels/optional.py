"""Rows for what may be left out of the scene: faintly, or by a word, they tell what then counts."""

from collections.abc import Callable, Sequence
from typing import Any

from ui.panels.edits import value_at
from ui.panels.fields import Changes, ChoiceRow, NumberRow, Row


class OptionalRow(NumberRow):
    """A number, or two of them, that may be left empty.

    Parameters
    ----------
    stand_in : callable
        The numbers that count instead, of a scene as plain data, or words where none does; shown
        faintly.
    """

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        stand_in: Callable[[dict[str, Any]], Sequence[float | str]],
        unit: str = "",
        *,
        between: str = "",
        whole: bool = False,
        present: Callable[[dict[str, Any]], bool] | None = None,
    ) -> None:
        super().__init__(
            path,
            label,
            tip,
            unit,
            between=between,
            whole=whole,
            present=present or (lambda data: True),
        )
        self._stand_in = stand_in

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show the scene's numbers, or none, before what stands in for them."""
        Row.show_scene(self, data, pending)
        stand_ins = self._stand_in(data)
        for (path, editor), stand_in in zip(self.editors.items(), stand_ins, strict=True):
            faint = stand_in if isinstance(stand_in, str) else format(stand_in, "g")
            editor.setPlaceholderText(faint)
            if path not in pending:
                value = value_at(data, path)
                editor.show_value("" if value is None else format(value, ".12g"))

    def _commit(self, path: str, text: str) -> None:
        if not text.strip():
            self._tell(path, {self.path: None})
        elif path == self.path:
            self._tell(path, {path: self.editors[path].typed(text)})
        else:  # a number alone counts for both
            texts = [editor.text().strip() or text for editor in self.editors.values()]
            values = [e.typed(t) for e, t in zip(self.editors.values(), texts, strict=True)]
            self._tell(path, {self.path: values})


class KindRow(ChoiceRow):
    """The kind of a part of the scene.

    Parameters
    ----------
    path : str
        Where the part is; its kind is told by the field ``kind``.
    begin : callable
        A new part of a kind, as plain data.
    otherwise : str
        What a person reads for there being no such part, where it may be left out.
    """

    def __init__(
        self,
        path: str,
        label: str,
        tip: str,
        kinds: Sequence[tuple[str, str]],
        begin: Callable[[str], dict[str, object]],
        otherwise: str = "",
    ) -> None:
        none = [("", otherwise)] if otherwise else []
        super().__init__(
            f"{path}.kind", label, tip, [*none, *kinds], read=self._read_kind, changes=self._change
        )
        self._part = path
        self._begin = begin
        self._shown = ""

    def show_scene(self, data: dict[str, Any], pending: set[str]) -> None:
        """Show the part's kind."""
        super().show_scene(data, pending)
        self._shown = self._read_kind(data)

    def present(self, data: dict[str, Any]) -> bool:
        """Always: there is a choice also where there is no part."""
        return True

    def concerns(self, path: str) -> bool:
        """Whether a refusal of ``path`` belongs to this row; one of the whole part does."""
        return path == self._part or super().concerns(path)

    def _read_kind(self, data: dict[str, Any]) -> str:
        kind = value_at(data, self.path)
        return "" if kind is None else str(kind)

    def _change(self, kind: str) -> Changes | None:
        if kind == self._shown:
            return None
        return {self._part: self._begin(kind) if kind else None}
