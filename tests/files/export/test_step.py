import getpass
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.files.export.step import _real, write_step

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
PLACES = np.linspace(0, 1, 41)


def is_spline(surface):
    return type(surface).__name__ == "Geom_BSplineSurface"


def points_of(surface):
    """Points of a surface at equal steps of its parameters, shape (m, m, 3)."""
    return np.array(
        [[(p.X(), p.Y(), p.Z()) for p in map(surface.Value, [u] * 41, PLACES)] for u in PLACES]
    )


def expected(design):
    r_x, r_y = design.net.half_width
    x, y = (2 * PLACES - 1) * r_x, (2 * PLACES - 1) * r_y
    z = design.surface(x, y)[0]
    return np.stack(np.broadcast_arrays(x[:, None], y, z), axis=-1)


class TestReadByOpenCascade:
    def check(self, design, write, read_solid, volume):
        path, deviation = write(write_step, design, "lens.step")
        assert deviation[:3] == ("rounding", 0.0, design.unit)
        found = read_solid(path)
        assert found.is_solid
        assert found.is_valid
        assert found.is_closed
        unit = MILLIMETRES[design.unit]
        # OpenCASCADE integrates by Gauss's formula, to which edges are foreign.
        exact = 1e-6 if min(design.net.degree) > 1 else 1e-4
        assert found.volume == pytest.approx(volume(design) * unit**3, rel=exact)
        assert len(found.surfaces) == 6
        splines = [surface for surface in found.surfaces if is_spline(surface)]
        others = [type(s).__name__ for s in found.surfaces if not is_spline(s)]
        assert others == ["Geom_Plane"] * 5
        (surface,) = splines
        size = unit * max(design.net.half_width)
        apart = np.abs(points_of(surface) - unit * expected(design)).max()
        assert apart < 1e-9 * size
        return surface

    @pytest.mark.parametrize("unit", MILLIMETRES)
    def test_units(self, make_design, write, read_solid, volume, unit):
        self.check(make_design({"unit": unit}), write, read_solid, volume)

    @pytest.mark.parametrize("degree", [(1, 1), (1, 3), (2, 5), (7, 7)])
    def test_degrees(self, make_design, write, read_solid, volume, degree):
        surface = self.check(make_design({"lens.degree": list(degree)}), write, read_solid, volume)
        assert (surface.UDegree(), surface.VDegree()) == degree
        assert (surface.NbUPoles(), surface.NbVPoles()) == (12, 10)

    @pytest.mark.parametrize("shape", [(4, 4), (4, 9), (64, 48)])
    def test_nets(self, make_design, write, read_solid, volume, shape):
        design = make_design({"lens.control_points": list(shape)})
        self.check(design, write, read_solid, volume)

    def test_a_flat_lens_has_the_volume_of_a_box(self, make_design, write, read_solid):
        design = make_design({"unit": "mm"}, heights=np.full((12, 10), 0.5))
        path, _ = write(write_step, design, "lens.step")
        assert read_solid(path).volume == pytest.approx(2.0 * 1.4 * 0.5, rel=1e-12)

    def test_a_lens_beside_the_origin(self, make_design, write, read_solid, volume):
        heights = 10.5 + 0.1 * np.random.default_rng(0).random((12, 10))
        changes = {"lens.entrance_z": 10.0, "lens.base.height": 10.5, "screen.z": 15.0}
        self.check(make_design(changes, heights), write, read_solid, volume)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_reals_are_read_as_the_same_number(value):
    text = _real(value)
    assert re.fullmatch(r"-?\d+\.\d*(E[+-]\d+)?", text)
    assert float(text) == value


class TestText:
    def text(self, make_design, write, name="lens.step", **settings):
        path, _ = write(write_step, make_design(**settings), name)
        return path.read_bytes().decode("ascii")

    def test_neither_user_nor_time(self, make_design, write):
        text = self.text(make_design, write)
        header = text[: text.index("DATA;")]
        assert getpass.getuser() not in text
        assert re.findall(r"\d{4}-\d\d-\d\d", header) == ["1970-01-01"]

    def test_the_same_lens_gives_the_same_file(self, make_design, write):
        heights = np.random.default_rng(0).random((12, 10))
        first = self.text(make_design, write, "a.step", heights=heights)
        assert self.text(make_design, write, "b.step", heights=heights) == first

    def test_references_lead_to_entities(self, make_design, write):
        text = self.text(make_design, write)
        defined = re.findall(r"^#(\d+)=", text, re.MULTILINE)
        assert defined == [str(i) for i in range(1, len(defined) + 1)]
        assert set(re.findall(r"[,(=]#(\d+)", text)) < set(defined)

    def test_reals_have_a_point(self, make_design, write):
        heights = np.full((12, 10), 0.5)
        heights[3, 4] = 1e-5
        heights[5, 6] = 123456789012345678.0
        text = self.text(make_design, write, heights=heights)
        assert "1.E-05)" in text
        assert "1.2345678901234568E+17)" in text
