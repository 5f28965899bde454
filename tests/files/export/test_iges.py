import pytest

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
