import numpy as np
import pytest

from workbench.files.export.maps import write_exr

OpenEXR = pytest.importorskip("OpenEXR")


@pytest.mark.parametrize("pixels", [[32, 32], [5, 3], [1, 1]])
def test_another_reader_finds_the_same(make_design, write, pixels):
    design = make_design({"screen.pixels": pixels, "screen.half_width": [2.0, 1.0]})
    path, deviation = write(write_exr, design, "lens.irradiance.exr")
    with OpenEXR.File(str(path)) as file:
        header, (name,) = dict(file.header()), file.channels()
        found = file.channels()[name].pixels
    wanted = design.result.state.irradiance
    assert name == "Y"
    assert found.dtype == np.float32
    assert np.array_equal(found, wanted.astype(np.float32))
    assert deviation.size == np.abs(found - wanted).max() < 1e-7
    assert deviation.unit == "1/cm^2"
    assert "Quantity irradiance, Unit 1/cm^2, Length unit cm" in header["comments"]
    n_x, n_y = pixels
    if min(pixels) > 1:
        assert header["pixelAspectRatio"] == pytest.approx(2 * n_y / n_x)
