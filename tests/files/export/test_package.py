"""The package for a shop: what is in it, and what its page of text says."""

from dataclasses import replace
from io import BytesIO
from zipfile import ZipFile

import numpy as np
import pytest
import trimesh

from workbench.files.export.options import Cutting, Drawing
from workbench.files.export.package import write_package

COARSE = Cutting(tool_radius=0.2, scallop=0.01)


@pytest.fixture
def package(make_design):
    def make(changes=None, entrance=None, **more):
        heights = np.full((8, 8), 0.5)
        design = make_design(
            {"lens.control_points": [8, 8], **(changes or {})}, heights, 1e-3, entrance
        )
        design = replace(design, options=more.pop("options", (COARSE,)), **more)
        file = BytesIO()
        deviation = write_package(design, file)
        return ZipFile(file), deviation

    return make


def test_it_holds_each_file_and_a_page_that_names_them(package):
    found, deviation = package(verified="0.61 %", options=(COARSE, Drawing(form_tolerance=2e-4)))
    endings = (".step", ".stl", ".3mf", ".nc", ".pdf", ".dxf", ".inspection.csv")
    assert found.namelist() == ["README.txt", *(f"lens{ending}" for ending in endings)]
    assert found.testzip() is None
    text = " ".join(found.read("README.txt").decode().split())
    assert all(f"lens{ending}: " in text for ending in endings)
    for stated in (
        "Size: 2 × 1.4 cm, outline: rectangle",
        "Form tolerance: 2 µm",
        "Verified error: 0.61 %, the relative L2 difference",
        "middle, top of the stock",
        "lengths in mm",
    ):
        assert stated in text
    mesh = trimesh.load_mesh(BytesIO(found.read("lens.stl")), file_type="stl")
    assert mesh.is_watertight and np.ptp(mesh.bounds, axis=0)[:2] == pytest.approx([20, 14])
    assert found.read("lens.nc").startswith(b"(freeform face of lens)")
    assert deviation.kind.startswith("largest ") and deviation.note == "7 files and README.txt"


def test_the_same_lens_gives_the_same_bytes(package):
    one, two = (package()[0] for _ in range(2))
    assert all(one.read(name) == two.read(name) for name in one.namelist())


def test_a_second_freeform_face_has_its_own_program_and_points(package):
    entrance = {"lens.entrance": {"shape": "freeform", "control_points": [7, 9]}, "version": 2}
    names = package(entrance, np.zeros((7, 9)))[0].namelist()
    assert {"lens.entrance.nc", "lens.entrance.inspection.csv"} < set(names)


def test_what_cannot_be_written_is_left_out_with_its_reason(package):
    found, deviation = package(options=(Cutting(tool_radius=0.2, scallop=1e-9),))
    assert "lens.nc" not in found.namelist() and "lens.pdf" in found.namelist()
    _, text = found.read("README.txt").decode().split("Not in the package")
    assert "lens.nc: " in text and "moves of this cutter" in " ".join(text.split())
    assert deviation.note == "6 files and README.txt, without lens.nc, see there"
