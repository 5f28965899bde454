"""Light from OpenEXR."""

import numpy as np
import OpenEXR
import pytest

from tests.targets.damaged import check_damaged
from workbench.errors import Refused
from workbench.targets.image import read_picture


@pytest.fixture
def save(tmp_path):
    def save(channels, **header):
        path = tmp_path / "a.exr"
        kinds = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
        OpenEXR.File(kinds | header, dict(channels)).write(str(path))
        return path

    return save


@pytest.fixture
def colours(rng):
    return {name: rng.random((5, 7)).astype(np.float32) for name in "RGB"}


def test_what_is_displayed_is_read(save, colours):
    windows = {"displayWindow": ((10, 20), (13, 28)), "dataWindow": ((8, 22), (14, 26))}
    try:
        path = save(
            {"Y": colours["R"]},
            **{
                name: tuple(np.array(corner, np.int32) for corner in each)
                for name, each in windows.items()
            },
        )
    except Exception as error:
        pytest.skip(f"this library writes no windows: {error}")
    light = read_picture(path).light
    assert light.shape == (9, 4)
    np.testing.assert_allclose(light[2:7], colours["R"][:, 2:6])
    assert not light[:2].any() and not light[7:].any()


def test_chromaticities_weigh_the_channels(save, colours):
    adobe = (0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.329)
    found = read_picture(save(colours, chromaticities=adobe))
    red, green, blue = (colours[name].astype(float) for name in "RGB")
    expected = 0.2973 * red + 0.6274 * green + 0.0753 * blue
    np.testing.assert_allclose(found.light, expected, rtol=1e-3)


@pytest.mark.parametrize(("value", "stated"), [(np.nan, "NaN"), (np.inf, "infinite"), (-50, "-3")])
def test_impossible_light_is_refused(save, colours, value, stated):
    colours["G"][2, 3] = value
    with pytest.raises(Refused, match=stated):
        read_picture(save(colours))


def test_damaged_files_are_read_or_refused(save, colours, tmp_path, rng):
    whole = save(colours).read_bytes()
    path = tmp_path / "b.exr"
    for cut in (40, len(whole) - 1):
        path.write_bytes(whole[:cut])
        with pytest.raises(Refused):
            read_picture(path)
    check_damaged(whole, path, rng, 6, 4)
