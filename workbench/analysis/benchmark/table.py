"""Tables that print as Markdown and as JSON."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class TableColumn:
    """A column.

    Attributes
    ----------
    name : str
        Its key in JSON, and the attribute of a row that it shows.
    heading : str
        What people read; empty for a column that only JSON has.
    form : str
        Format specification of its values, such as ".1%".
    """

    name: str
    heading: str
    form: str = ""


@dataclass(frozen=True)
class Table:
    """Rows under a title.

    Attributes
    ----------
    title : str
        What the rows are.
    columns : tuple of TableColumn
        What is known of each.
    rows : sequence
        Anything with the columns' names as attributes; None for what does not apply.
    note : str
        What has to be known to read it.
    """

    title: str
    columns: tuple[TableColumn, ...]
    rows: Sequence[Any]
    note: str = ""

    def to_markdown(self) -> str:
        """Title, table and note, without the columns that have no heading."""
        seen = [column for column in self.columns if column.heading]
        lines = [
            [column.heading for column in seen],
            ["---"] * len(seen),
            *([_shown(getattr(row, c.name), c.form) for c in seen] for row in self.rows),
        ]
        body = "\n".join(f"| {' | '.join(cells)} |" for cells in lines)
        note = f"\n{self.note}\n" if self.note else ""
        return f"### {self.title}\n\n{body}\n{note}"

    def to_data(self) -> list[dict[str, Any]]:
        """The rows as plain dictionaries."""
        return [
            {column.name: getattr(row, column.name) for column in self.columns} for row in self.rows
        ]


def _shown(value: Any, form: str) -> str:
    if value is None:
        return "–"
    return (format(value, form) if form else str(value)).replace("|", "\\|")
