"""The example scenes of benchmarks, and the tables of their results."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

import resources
from resources.parts import bspline, lens, screen
from resources.pictures import DRAWN, picture
from workbench.arrays import Array, Mask
from workbench.design.net import definite
from workbench.design.run import run
from workbench.design.snapshot import History, Result
from workbench.geometry.faces import NO_LOCKS
from workbench.scene import Scene
from workbench.scene.paths import with_values
from workbench.targets import load_target

NO_CHANGES: Mapping[str, Any] = MappingProxyType({})

Notify = Callable[[str, str], None]
"""Called now and then with the name of a measurement and its progress."""


@dataclass(frozen=True, eq=False)
class BenchmarkTask:
    """A scene and its target."""

    name: str
    group: str
    scene: Scene
    target: Array  # (n_y, n_x), the target image

    @classmethod
    def of(
        cls, name: str, image: Array | None = None, changes: Mapping[str, Any] = NO_CHANGES
    ) -> "BenchmarkTask":
        """Read a shipped example.

        `image` (n_y, n_x): the target, in place of the example's own; `changes`: values that differ
        from the example's, by their paths; see `workbench.scene.paths`.
        """
        shipped = next(each for each in resources.EXAMPLES if each.name == name)
        scene = with_values(Scene.from_json(shipped.file.read_bytes()), changes)
        target = load_target(scene, shipped.file.parent) if image is None else image
        return cls(name, shipped.group, definite(scene, target), target)

    @classmethod
    def picture(cls, name: str, pixels: int) -> "BenchmarkTask":
        """A picture of `resources.pictures` in collimated light; see there for what is refused."""
        file = BytesIO()
        picture(name, pixels).save(file, "PNG")
        scene = Scene.from_data(
            {
                "version": 3,
                "unit": "cm",
                "source": {"kind": "collimated"},
                "elements": [lens([1, 1], 0.5, 1.5, bspline())],
                "images": [
                    {
                        "receiver": screen(5, [1, 1], [pixels, pixels]),
                        "target": {
                            "image": f"{name}.png",
                            "tone": "linear" if name in DRAWN else "srgb",
                        },
                    }
                ],
            }
        )
        target = load_target(scene, Path(), file.getvalue())
        return cls(name, "Pictures", definite(scene, target), target)

    def designed(
        self, notify: Callable[[str], None], locked: Mapping[str, Mask] = NO_LOCKS
    ) -> Result:
        """Run the design to its end; ``locked`` as for `run`."""
        history = History()
        for snapshot in run(self.scene, self.target, locked=locked):
            notify(f"iteration {snapshot.iteration}")
            history.add(snapshot)
        found = history.result()
        assert found is not None  # a run begins with a lens
        return found

    def save(self, folder: Path) -> Path:
        """Write the scene and its target into a folder, and return the scene file."""
        np.save(folder / "target.npy", self.target)
        scene = with_values(self.scene, {"images[0].target": {"image": "target.npy"}})
        file = folder / "scene.json"
        file.write_text(scene.to_json(), "utf-8")
        return file


@dataclass(frozen=True)
class TableColumn:
    """Column of a table."""

    name: str  # key in JSON, and attribute of a row
    heading: str  # empty for a column of JSON alone
    form: str = ""  # format specification, such as ".1%"


@dataclass(frozen=True)
class Table:
    """Rows under a title."""

    title: str
    columns: tuple[TableColumn, ...]
    rows: Sequence[Any]  # with the columns' names as attributes; None where a value is missing
    note: str = ""

    def to_markdown(self) -> str:
        """Title, table and note, without columns that have no heading."""
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
