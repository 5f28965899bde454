"""Drawing of a part for a shop, as PDF and DXF: dimensions, datums, inspection points."""

from typing import BinaryIO

from workbench.files.export.design import Design, Deviation
from workbench.files.export.inspection import Inspection
from workbench.files.export.options import Drawing
from workbench.pictures import report
from workbench.pictures.part.drawing import BASE, FOOT, SIDE, PartDrawing
from workbench.powers import written
from workbench.units import ratio


def write_drawing(design: Design, file: BinaryIO) -> Deviation:
    """Write the drawing as PDF: a view with sections, notes, and the table of points."""
    drawing = _drawing(design)
    unit, points = drawing.unit, Inspection.of(design)
    name = f"{design.optic.name}: part drawing"
    pages = report.Pages("Freeform Lens Workbench")
    pages.title(name, f"Dimensions in {unit}, scale {drawing.scale_in_words} on A4")
    pages.picture(drawing.draw, drawing.height)
    pages.rows(_rows(design, unit))
    pages.heading("Inspection points of the freeform face")
    pages.note(
        "x and y are measured from the axis of the part, which is in the middle between its sides "
        f"and parallel to them; z is measured from datum {BASE} at the axis."
    )
    factor = float(ratio(design.unit, unit))
    rows = [
        (str(number), *(f"{each:.4f}" for each in factor * place), *(f"{n:.5f}" for n in normal))
        for number, (place, normal) in enumerate(zip(*points, strict=True), 1)
    ]
    columns = (f"x ({unit})", f"y ({unit})", f"z ({unit})", "normal x", "normal y", "normal z")
    pages.table(("number", *columns), rows)
    pages.write(file, name)
    return _deviation(design, drawing, f"scale {drawing.scale_in_words}")


def write_dxf(design: Design, file: BinaryIO) -> Deviation:
    """Write the drawing as DXF, revision 12, the part in full size."""
    drawing = _drawing(design)
    drawing.write_dxf(file)
    return _deviation(design, drawing, f"full size in {drawing.unit}")


def _drawing(design: Design) -> PartDrawing:
    points = Inspection.of(design).place[:, :2]
    heights = design.result.state.heights
    return PartDrawing(design.optic, heights, design.unit, report.WIDTH, points)


def _rows(design: Design, unit: str) -> list[tuple[str, str]]:
    """Material, datums and the tolerance of the form."""
    optic, factor = design.optic, float(ratio(design.unit, unit))
    whole = "sides" if design.outline.whole else "rim"
    rows = [
        ("projection", "first angle, front view seen from +z"),
        ("material", design.material),
        (f"datum {BASE}", "the other side of the part"),
        (f"datums {SIDE}, {FOOT}", f"{whole} at −x and at −y"),
        ("width, height", " × ".join(f"{2 * factor * r:.4g}" for r in optic.half_width)),
    ]
    tolerance = design.chosen(Drawing).form_tolerance
    stated = "not stated"
    if tolerance is not None:
        stated = f"profile within {written(factor * tolerance)} {unit} to {BASE}, {SIDE}, {FOOT}"
    return [*rows, ("freeform face", stated)]


def _deviation(design: Design, drawing: PartDrawing, note: str) -> Deviation:
    off = drawing.chord_error * float(ratio(drawing.unit, design.unit))
    return Deviation("drawn sections off by", off, design.unit, note)
