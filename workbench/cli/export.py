"""``freeform export``."""

from collections.abc import Sequence
from pathlib import Path

from workbench.cli.designed import read_designed
from workbench.files.export.cutting import Cutting
from workbench.files.export.write import export as write_all


def export(
    path: Path, files: Sequence[Path], chord_error: float | None, cutting: Cutting, mesh_unit: str
) -> None:
    """Write the lens of a session and its light in the formats that the endings tell.

    Raises
    ------
    Refused
        If the session cannot be read or holds no lens or one that is no body, or a file cannot be
        written. At the end, if a format cannot hold what is asked; the other files are written.
    RunFailed
        If another program's library that is needed fails.
    """
    session, _ = read_designed(path)
    for written in write_all(session, files, chord_error, cutting, mesh_unit):
        print(written.sentence, flush=True)
