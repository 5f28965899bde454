"""Tables that print as Markdown and as JSON."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class TableColumn:
    """A column."""

    name: str  # its key in JSON, and the attribute of a row that it shows
    heading: str  # what people read; empty for a column that only JSON has
    form: str = ""  # format specification of its values, such as ".1%"


@dataclass(frozen=True)
class Table:
    """Rows under a title."""

    title: str  # what the rows are
    columns: tuple[TableColumn, ...]  # what is known of each
    # Anything with the columns' names as attributes; None for what does not apply.
    rows: Sequence[Any]
    note: str = ""  # what has to be known to read it

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
