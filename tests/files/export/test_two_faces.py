"""Files of lenses whose entrance face is freeform, too."""

import numpy as np
import pytest

from tests.files.export.test_solids import is_spline, points_of
from workbench.files.export.iges import write_iges
from workbench.files.export.step import write_step
from workbench.files.export.tables import write_grid_sag, write_points

NETS = {
    "the same net": {"shape": "freeform"},
    "another net": {"shape": "freeform", "control_points": [7, 9]},
    "another degree": {"shape": "freeform", "control_points": [5, 14], "degree": [1, 5]},
}
# OpenCASCADE integrates by Gauss's formula, to which edges and ends within a span are foreign.
EXACT = {"rectangle": 1e-4, "ellipse": 4e-4}
OUTLINES = pytest.mark.parametrize("outline", ["rectangle", "ellipse"])


@pytest.fixture(params=NETS)
def entrance(request):
    return {"version": 2, "lens.entrance": NETS[request.param]}


@pytest.fixture
def two_faced(make_design):
    """A lens of two wavy faces."""

    def make(changes=None, **others):
        return make_design(
            {"version": 2, "lens.entrance": NETS["another net"]} | (changes or {}), **others
        )

    return make


@pytest.fixture
def volume_within(volume):
    """Volume of a lens within its outline: exact in a rectangle, by Gauss's rule in an ellipse."""

    def integral(design):
        if design.outline.whole:
            return volume(design)
        nodes, weights = np.polynomial.legendre.leggauss(100)
        angle = np.linspace(0, 2 * np.pi, 400, endpoint=False)
        radius = ((nodes + 1) / 2)[:, None]
        r_x, r_y = design.net.half_width
        x, y = r_x * radius * np.cos(angle), r_y * radius * np.sin(angle)
        upper, lower = (face.net.at(x, y, face.heights)[0] for face in design.faces)
        mean = (radius * (upper - lower)).mean(axis=1)
        return float((weights / 2) @ mean) * 2 * np.pi * r_x * r_y

    return integral


class TestSolid:
    @OUTLINES
    def test_both_faces_of_a_step_file_are_the_b_splines(
        self, two_faced, entrance, write, read_solid, volume_within, outline
    ):
        design = two_faced(entrance | {"lens.outline": outline})
        path, deviation = write(write_step, design, "lens.step")
        assert deviation.size < (1e-12 if outline == "rectangle" else 1e-5)  # edges cross its rim
        found = read_solid(path)
        assert (found.is_solid, found.is_valid, found.is_closed) == (True, True, True)
        exact = EXACT[outline]
        assert found.volume == pytest.approx(1e3 * volume_within(design), rel=exact)  # cm to mm
        assert len(found.surfaces) == 6
        splines = [surface for surface in found.surfaces if is_spline(surface)]
        assert len(splines) == 2
        for face, surface in zip(design.faces, splines, strict=True):
            x, y, z = np.moveaxis(points_of(surface) / 10, -1, 0)
            assert np.ptp(x) == pytest.approx(2.0)
            assert np.ptp(y) == pytest.approx(1.4)
            np.testing.assert_allclose(z, face.net.at(x, y, face.heights)[0], atol=1e-9)

    @OUTLINES
    def test_iges_is_the_same_solid(self, two_faced, write, read_solid, volume_within, outline):
        design = two_faced({"lens.outline": outline})
        path, deviation = write(write_iges, design, "lens.iges")
        assert deviation.kind == "error of the freeform faces"
        assert deviation.size < 1e-9
        found = read_solid(path)
        assert found.is_valid
        assert found.volume == pytest.approx(1e3 * volume_within(design), rel=EXACT[outline])


class TestFilesOfOneFace:
    pytestmark = pytest.mark.usefixtures("small_grids")

    def test_normals_point_out_of_the_glass(self, two_faced, write):
        for face, sign in zip(two_faced().faces, (1, -1), strict=True):
            path, deviation = write(write_points, face, f"{sign}.xyz")
            x, y, z, *normal = np.loadtxt(path).T
            inside = (np.abs(x) < 1) & (np.abs(y) < 0.7)
            expected, slope_x, slope_y = face.net.at(x, y, face.heights)
            np.testing.assert_allclose(z[inside], expected[inside], atol=1e-12)
            assert (sign * normal[2] > 0).all()
            slopes = np.stack([slope_x, slope_y])[:, inside]
            found = -np.stack(normal[:2])[:, inside] / normal[2][inside]
            np.testing.assert_allclose(found, slopes, atol=1e-9)
            assert deviation.size < 1e-3

    def test_grid_sag_tells_the_thickness_between_both_faces(self, two_faced, write):
        design = two_faced()
        middle = [face.surface(np.zeros(1), np.zeros(1))[0].item() for face in design.faces]
        for number, face in enumerate(design.faces):
            path, deviation = write(write_grid_sag, face, f"{number}.dat")
            thickness = f"{middle[0] - middle[1]:.10g}"
            assert deviation.note == f"thickness at the vertex {thickness} cm"
            assert deviation.size < 1e-14
            n_x, n_y = map(int, path.read_text().split()[:2])
            sag = np.loadtxt(path, skiprows=1)[:, 0].reshape(n_y, n_x)[::-1].T
            corner = face.heights[0, 0] - middle[number]
            assert sag[0, 0] == pytest.approx(corner, abs=1e-12)
