"""Package for a shop: one zip with the part for CAD, printing and cutting, drawing and figures.

A format that cannot hold the part is left out, and the page of text says why.
"""

import io
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import BinaryIO, NamedTuple
from zipfile import ZipFile

from workbench.errors import Refused
from workbench.files.export.cut_plan import check_cutting
from workbench.files.export.design import Design, Deviation
from workbench.files.export.formats import Format, format_of
from workbench.files.export.meshes import zip_entry
from workbench.files.export.options import ORIGINS, Drawing
from workbench.powers import written

__all__ = ["check_cutting", "write_package"]
README = "README.txt"
_WIDTH = 88  # letters of a line
_ENDINGS = {
    ".step": "exact solid for CAD and CAM, lengths in {unit}",
    ".stl": "mesh, lengths in {mesh_unit}",
    ".3mf": "mesh for printing, which states its unit: {mesh_unit}",
    ".nc": "program for the machine, lengths in mm; its first lines state stock, cutters and zero",
    ".pdf": "drawing with datums, form tolerance and inspection points",
    ".dxf": "the drawing for CAD, in full size",
    ".inspection.csv": "coordinates and normals of the inspection points, mm",
}
_OF_FACE = ".nc", ".inspection.csv"  # also of a freeform entrance face


class _Member(NamedTuple):
    """A file of the package, or why it is not there."""

    name: str
    about: str
    content: bytes | None
    remark: str


def write_package(design: Design, file: BinaryIO) -> Deviation:
    """Write the zip; times of its entries are fixed, so the same lens gives the same file.

    Raise Refused if no format can hold the part.
    """
    members, largest = [], None
    for ending, found in _listed(design):
        stream = io.BytesIO()
        name = f"{design.optic.name}{ending}"
        about = _ENDINGS[ending.removeprefix(".entrance")]
        about = about.format(unit=design.unit, mesh_unit=design.mesh_unit)
        try:
            deviation = found.load()(design, stream)
        except Refused as refused:
            members.append(_Member(name, about, None, str(refused)))
            failure = refused
            continue
        remark = f"{deviation.kind} {written(deviation.size, deviation.unit, 2)}"
        note = f"; {deviation.note}" if deviation.note else ""
        members.append(_Member(name, about, stream.getvalue(), f"{remark}{note}"))
        if largest is None or deviation.size > largest.size:
            largest = deviation
    if largest is None:
        raise failure
    with ZipFile(file, "w") as package:
        package.writestr(zip_entry(README), "\n".join(_page(design, members)))
        for each in members:
            if each.content is not None:
                package.writestr(zip_entry(each.name), each.content)
    count = sum(each.content is not None for each in members)
    note = f"{count} files and {README}"
    missing = ", ".join(each.name for each in members if each.content is None)
    if missing:
        note += f", without {missing}, see there"
    return largest._replace(kind=f"largest {largest.kind}", note=note)


def _listed(design: Design) -> Iterator[tuple[str, Format]]:
    """Endings of the package's files and their formats."""
    fronts = [""] if design.optic.designed_front is None else ["", ".entrance"]
    for ending in _ENDINGS:
        for front in fronts if ending in _OF_FACE else [""]:
            yield front + ending, format_of(Path(f"{design.optic.name}{front}{ending}"))


def _page(design: Design, members: Sequence[_Member]) -> Iterator[str]:
    """Lines of the text page."""
    optic, verified, tolerance = design.optic, design.verified, design.chosen(Drawing)
    size = " × ".join(f"{2 * r:.6g}" for r in optic.half_width)
    yield f"{optic.name}: package for manufacture"
    yield ""
    facts = {
        "Material": design.material,
        "Size": f"{size} {design.unit}, outline: {optic.outline}",
        "Axes": "x to the right and y up, seen from +z; z is the optical axis. The axis of the "
        "part is x = y = 0 in all files but the program, where the zero is: "
        f"{ORIGINS[design.cutting.origin]}.",
        "Form tolerance": "not stated"
        if tolerance.form_tolerance is None
        else written(tolerance.form_tolerance, design.unit),
        "Verified error": "not known: freeform validate computes it"
        if verified is None
        else f"{verified}, the relative L2 difference of its light from the wanted image by the "
        "independent check",
        "Loss of the run": written(design.result.state.loss),
    }
    for name, text in facts.items():
        yield from _hanging(f"{name}: {text}")
    for title, there in (("Files", True), ("Not in the package", False)):
        some = [each for each in members if (each.content is not None) == there]
        if some:
            yield from ("", title, "")
        for each in some:
            yield from _hanging(
                f"{each.name}: {each.about}. {each.remark[:1].upper()}{each.remark[1:]}."
            )
    yield ""


def _hanging(text: str) -> list[str]:
    return textwrap.wrap(text, _WIDTH, subsequent_indent="    ", break_long_words=False)
