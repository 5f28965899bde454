"""A report as PDF."""

from typing import BinaryIO

from workbench.pictures.report import Pages
from workbench.report.content import Report


def write_pdf(report: Report, file: BinaryIO) -> None:
    """Write a report.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    pages = Pages(report.subtitle)
    pages.title(report.title, report.subtitle)
    for section in report.sections:
        pages.heading(section.title)
        if section.note:
            pages.note(section.note)
        pages.rows(section.rows, heads=bool(section.pictures))
        for picture in section.pictures:
            pages.picture(picture.draw, picture.height)
    pages.write(file, report.title, report.dated)
