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


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_reals_are_read_as_the_same_number(value):
    text = _real(value)
    assert re.fullmatch(r"-?\d+\.\d*(E[+-]\d+)?", text)
    assert float(text) == value
