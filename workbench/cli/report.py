"""``freeform report``."""

from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path
from typing import BinaryIO

from workbench.analysis.tolerance_fields import Tolerances
from workbench.cli.designed import read_designed
from workbench.files.atomic import check_writable, replacing
from workbench.report.content import HTML, Report, check_ending


def report(
    path: Path,
    files: Sequence[Path],
    rays: int,
    tolerances: tuple[Tolerances, int] | None,
    with_mitsuba: bool,
) -> None:
    """Check the lens of a session and write all that is known of it.

    Raises
    ------
    Refused
        If the session cannot be read or holds no lens, a file cannot be written, a tolerance is
        not possible, or Mitsuba is asked for and not installed.
    RunFailed
        If no light reaches the screen.
    """
    writers = [_writer(file) for file in files]
    session, _ = read_designed(path)
    for file in files:
        check_writable(file)
    from workbench.report.gather import gather  # late: draws, which takes long to import

    dated = datetime.fromtimestamp(path.stat().st_mtime)
    found = gather(session, path.stem, dated, rays, tolerances, with_mitsuba)
    for file, write in zip(files, writers, strict=True):
        with replacing(file) as stream:
            write(found, stream)


def _writer(file: Path) -> Callable[[Report, BinaryIO], None]:
    check_ending(file)
    if file.suffix.lower() in HTML:
        from workbench.report.write import write_html

        return write_html
    from workbench.report.write import write_pdf

    return write_pdf
