"""Part drawing as PDF and DXF, and inspection points, read by other programs."""

import csv
import io
from dataclasses import replace

import numpy as np
import pytest
from ezdxf import recover
from pypdf import PdfReader

from tests.analysis.lenses import net_of
from workbench.files.export.inspection import write_inspection
from workbench.files.export.options import Drawing
from workbench.pictures.part.sheet import write_drawing, write_dxf


def wedge(x, y):
    return 0.6 + 0.1 * y + 0 * x


@pytest.fixture
def make_part(make_design):
    def make(changes=None, **options):
        changes = {"lens.half_width": [1.0, 0.5]} | (changes or {})
        heights = net_of(make_design(changes).scene, wedge)
        drawing = Drawing(**options)
        return replace(make_design(changes, heights), face="lens.back", options=(drawing,))

    return make


def written(writer, design):
    file = io.BytesIO()
    return file, writer(design, file)


def test_a_dxf_holds_the_part_in_full_size(make_part, tmp_path):
    file, deviation = written(write_dxf, make_part())
    path = tmp_path / "lens.dxf"
    path.write_bytes(file.getvalue())
    document, audit = recover.readfile(path)
    assert document.dxfversion == "AC1009" and not audit.errors and not audit.fixes
    front, upright, level = (
        np.array([vertex.dxf.location.vec2 for vertex in each.vertices])
        for each in document.modelspace().query('POLYLINE[layer=="PART"]')
    )
    assert np.ptp(front, axis=0) == pytest.approx([20, 10])  # mm, of 2 × 1 cm
    assert np.ptp(upright, axis=0) == pytest.approx([6.5, 10])
    assert np.ptp(level, axis=0) == pytest.approx([20, 6])
    texts = {text.plain_text() for text in document.modelspace().query("TEXT")}
    assert {"20", "10", "overall 6.5", "centre 6", "A–A", "B–B", "D", "E", "F", "25"} <= texts
    assert deviation.size == pytest.approx(0, abs=1e-12)


def test_a_pdf_states_tolerance_material_and_points(make_part):
    file, _ = written(write_drawing, make_part(form_tolerance=5e-4, inspection_points=3))
    reader = PdfReader(file)
    text = "\n".join(page.extract_text() for page in reader.pages)
    assert reader.metadata.title == "lens: part drawing"
    for found in ("profile within 0.005 mm to D,", "Inspection points", "overall 6.5", "datum D"):
        assert found in text
    assert "-4.5000" in text and "6.4500" in text  # z of the point at y = 4.5 mm


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_inspection_points_are_on_the_face_with_normals_outwards(make_part, outline):
    design = make_part({"lens.outline": outline}, inspection_points=4)
    file, deviation = written(write_inspection, design)
    comment, *lines = file.getvalue().decode().splitlines()
    assert comment.startswith("# inspection points")
    rows = list(csv.DictReader(lines))
    x, y, z, *normal = np.array([list(map(float, row.values()))[1:] for row in rows]).T
    assert len(rows) == 16 and [row["number"] for row in rows][:2] == ["1", "2"]
    assert z == pytest.approx(6 + 0.1 * y, abs=1e-6)
    assert pytest.approx(np.tile([0, -0.1, 1] / np.sqrt(1.01), (16, 1))) == np.array(normal).T
    assert design.outline.contains(x / 10, y / 10).all()
    assert deviation.size < 1e-7
