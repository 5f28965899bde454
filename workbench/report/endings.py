"""What endings of files say about the form of a report."""

from pathlib import Path

from workbench.errors import Refused
from workbench.said import Said

HTML, PDF = (".html", ".htm"), (".pdf",)


def check_ending(file: Path) -> None:
    """Find out whether a file can be a report.

    Raises
    ------
    Refused
        If its ending tells no form of one.
    """
    if file.suffix.lower() not in (*HTML, *PDF):
        known = ", ".join((*HTML, *PDF))
        raise Refused(
            str(file), Said("has no ending that tells a format; one of {endings}", endings=known)
        )
