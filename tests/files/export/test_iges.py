import getpass
import sys

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.files.export.iges import write_iges

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}


@pytest.mark.parametrize("unit", MILLIMETRES)
def test_read_by_opencascade(make_design, write, read_solid, volume, unit, capfd):
    design = make_design({"unit": unit})
    path, deviation = write(write_iges, design, "lens.iges")
    assert capfd.readouterr() == ("", "")
    assert deviation.kind == "error of the exit face"
    assert deviation.unit == unit
    assert deviation.size < 1e-8
    found = read_solid(path)
    assert found.is_solid
    assert found.is_valid
    assert found.is_closed
    assert found.volume == pytest.approx(volume(design) * MILLIMETRES[unit] ** 3, rel=1e-6)


def test_neither_user_nor_time(make_design, write):
    heights = np.random.default_rng(0).random((12, 10))
    paths = [write(write_iges, make_design(heights=heights), name)[0] for name in ("a", "b")]
    first, second = (path.read_bytes() for path in paths)
    assert first == second
    assert getpass.getuser().encode() not in first
    assert b"15H19700101.000000" in first


def test_the_extra_is_named_where_it_is_missing(make_design, write, monkeypatch):
    monkeypatch.setitem(sys.modules, "OCP.IGESControl", None)
    with pytest.raises(Refused, match=r"\.iges: needs OpenCASCADE, .*workbench\[iges\]"):
        write(write_iges, make_design(), "lens.iges")
