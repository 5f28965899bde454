"""Where the light is wanted: a screen, or directions in the far field."""

from collections.abc import Callable, Iterable, Sequence, Set
from typing import Any

from ui.panels.edits import value_at
from ui.panels.fields import Changes, ChoiceRow, Row
from ui.panels.panel import Panel
from ui.panels.rows import Rows
from ui.words import tr
from workbench.files.session import Session
from workbench.scene import AnyReceiver, FieldDescription
from workbench.scene.kinds import summary_of


class ReceiverPanel(Panel):
    """Bound to whichever of some parts of the scene is there.

    Parameters
    ----------
    fields : sequence of FieldDescription
        The fields of the scene of which one holds the receiver.
    """

    def __init__(self, *fields: FieldDescription) -> None:
        self._titles = {field.name: tr(field.title) for field in fields}
        self._kinds = receiver_kinds(fields)
        rows = Rows(lambda: self.session.scene)
        first, *others = fields
        choice = ChoiceOfReceiver(fields, self._change)
        super().__init__(tr(first.title), [choice, *rows.of_part(first.parts[0], first.name)])
        for field in others:
            self._add_rows(rows.of_part(field.parts[0], field.name), tr(field.title))

    def show_session(self, session: Session, present: Set[Row], pending: Set[str]) -> None:
        """Show the receiver that is there, under its own heading."""
        super().show_session(session, present, pending)
        self._heading.setText(self._titles[_given(session.scene, self._titles)])

    def _change(self, name: str) -> Changes | None:
        scene = self.session.scene
        if getattr(scene, name) is not None:
            return None
        kind = self._kinds[name]
        made = kind.model_validate(kind.defaults_for(scene))
        changes: Changes = dict.fromkeys(self._titles)
        return changes | {name: made.model_dump(mode="json", exclude_none=True)}


class ChoiceOfReceiver(ChoiceRow):
    """Which of some parts the receiver is.

    Parameters
    ----------
    fields : sequence of FieldDescription
        The fields of which one holds it.
    change : callable
        What another one of them changes.
    holder : str
        Path of what has these fields; empty for the scene.
    """

    def __init__(
        self,
        fields: Sequence[FieldDescription],
        change: Callable[[str], Changes | None],
        holder: str = "",
    ) -> None:
        titles = {field.name: tr(field.title) for field in fields}
        before = f"{holder}." if holder else ""
        super().__init__(
            before + fields[0].name,
            tr("Kind"),
            " ".join(f"{titles[field.name]}: {tr(summary_of(field.parts[0]))}" for field in fields),
            list(titles.items()),
            read=lambda scene: _given(value_at(scene, holder) if holder else scene, titles),
            changes=change,
        )

    def concerns(self, path: str) -> bool:
        """A refusal of the whole part."""
        return path == self.path

    def _is_there(self, scene: Any) -> bool:
        return True


def receiver_kinds(fields: Sequence[FieldDescription]) -> dict[str, type[AnyReceiver]]:
    """What stands in each of some fields."""
    return {
        field.name: part
        for field in fields
        for part in field.parts
        if issubclass(part, AnyReceiver)
    }


def _given(holder: Any, names: Iterable[str]) -> str:
    return next((name for name in names if getattr(holder, name, None) is not None), "")
