"""Report as a self-contained HTML file, and as PDF."""

import base64
import io
from collections.abc import Iterator, Sequence
from html import escape
from typing import BinaryIO

from workbench.pictures.report import Pages, to_png
from workbench.report.content import PagePicture, Report, Section, Table

_STYLE = """
:root { color-scheme: light dark; --ink: #1d232b; --pale: #5d6673; --line: #d9dee5; --paper: #fff; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e8ee; --pale: #9aa4b2; --line: #363d48; --paper: #171b21; }
}
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 54rem; margin: 2.5rem auto; padding: 0 1.25rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .4rem; border-bottom: 1px solid var(--line); }
p { color: var(--pale); margin: .3rem 0 .8rem; }
dl { columns: 17rem 2; column-gap: 2rem; margin: 0; }
dl div { display: flex; gap: 1rem; break-inside: avoid; padding: .15rem 0; }
dt { flex: 0 0 11.5rem; color: var(--pale); overflow-wrap: anywhere; }
dd { margin: 0; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: normal; color: var(--pale); }
th, td { padding: .2rem .6rem .2rem 0; vertical-align: top;
  border-bottom: 1px solid var(--line); overflow-wrap: anywhere; }
figure { margin: 1rem 0; break-inside: avoid; }
img { display: block; width: 100%; background: #fff; border-radius: 6px; }
figcaption { font-size: .87rem; color: var(--pale); }
@page { size: A4; margin: 16mm; }
@media print {
  :root { --ink: #000; --pale: #444; --line: #bbb; --paper: #fff; }
  html { font-size: 12px; }
  body { font-size: 9.5pt; max-width: none; margin: 0; padding: 0; }
  h2, p { break-after: avoid; }
}
"""


def write_html(report: Report, file: BinaryIO) -> None:
    """Write a report with embedded pictures; raise OSError if that fails."""
    for part in _parts(report):
        file.write(f"{part}\n".encode())


def _parts(report: Report) -> Iterator[str]:
    title = escape(report.title)
    yield "<!doctype html>"
    yield f'<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
    yield '<meta name="viewport" content="width=device-width, initial-scale=1">'
    yield f"<style>{_STYLE}</style></head><body>"
    yield f"<h1>{title}</h1>"
    yield f"<p>{escape(report.subtitle)}</p>"
    for section in report.sections:
        yield from _section(section)
    yield "</body></html>"


def _section(section: Section) -> Iterator[str]:
    yield f"<section><h2>{escape(section.title)}</h2>"
    if section.note:
        yield f"<p>{escape(section.note)}</p>"
    if section.table:
        yield from _table(section.table)
    if section.rows:
        yield "<dl>"
        for name, value in section.rows:
            yield f"<div><dt>{escape(name)}</dt><dd>{escape(value)}</dd></div>"
        yield "</dl>"
    for picture in section.pictures:
        yield _figure(picture)
    yield "</section>"


def _table(table: Table) -> Iterator[str]:
    yield "<table><thead>"
    yield _cells("th", table.header)
    yield "</thead><tbody>"
    for row in table.rows:
        yield _cells("td", row)
    yield "</tbody></table>"


def _cells(tag: str, texts: Sequence[str]) -> str:
    cells = "".join(f"<{tag}>{escape(text)}</{tag}>" for text in texts)
    return f"<tr>{cells}</tr>"


def _figure(picture: PagePicture) -> str:
    png = io.BytesIO()
    to_png(picture.draw, picture.height, png)
    data = base64.b64encode(png.getbuffer()).decode()
    name = escape(picture.name)
    image = f'<img src="data:image/png;base64,{data}" alt="{name}">'
    return f"<figure>{image}<figcaption>{name}</figcaption></figure>"


def write_pdf(report: Report, file: BinaryIO) -> None:
    """Write a report; raise OSError if that fails."""
    pages = Pages(report.subtitle)
    pages.title(report.title, report.subtitle)
    for section in report.sections:
        pages.heading(section.title)
        if section.note:
            pages.note(section.note)
        if section.table:
            pages.table(section.table.header, section.table.rows)
        pages.rows(section.rows, heads=bool(section.pictures))
        for picture in section.pictures:
            pages.picture(picture.draw, picture.height)
    pages.write(file, report.title, report.dated)
