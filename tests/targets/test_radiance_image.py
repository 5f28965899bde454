"""Light from Radiance HDR."""

import numpy as np
import pytest

from tests.targets.damaged import check_damaged
from workbench.targets.image import read_picture

HEAD = "#?RADIANCE\n# made here\nFORMAT=32-bit_rle_{}\nEXPOSURE=2\n{}\n{}\n"
WEIGHTS = np.array([0.2126, 0.7152, 0.0722])


@pytest.fixture
def colours(rng):
    """Light of 5 × 12 pixels that RGBE holds exactly."""
    colours = rng.integers(0, 128, (5, 12, 3)) * 2.0 ** rng.integers(-4, 5, (5, 12, 1))
    colours[2, 3] = 0
    return colours


def rgbe(colours):
    largest = np.frexp(colours.max(axis=-1))[1]
    pixels = np.zeros((*colours.shape[:2], 4), np.uint8)
    pixels[..., :3] = np.ldexp(colours, (8 - largest)[..., None])
    pixels[..., 3] = np.where(colours.max(axis=-1) > 0, largest + 128, 0)
    return pixels


def packed(pixels):
    """Lines packed channel by channel: a run, then values as they are."""
    content = b""
    for line in pixels:
        content += bytes([2, 2, 0, len(line)])
        for channel in line.T:
            content += bytes([len(channel), *channel])
    return content


def save(
    path, pixels, size=None, kind="rgbe", more="", magic="#?RADIANCE", pack=np.ndarray.tobytes
):
    rows, columns = pixels.shape[:2]
    head = HEAD.format(kind, more, size or f"-Y {rows} +X {columns}").replace("#?RADIANCE", magic)
    path.write_bytes(head.encode() + pack(pixels))
    return path


@pytest.mark.parametrize(
    ("size", "stored"),
    [
        ("-Y 5 +X 12", lambda p: p),
        ("+Y 5 +X 12", lambda p: p[::-1]),
        ("-Y 5 -X 12", lambda p: p[:, ::-1]),
        ("+X 12 -Y 5", lambda p: p.transpose(1, 0, 2)),
        ("-X 12 +Y 5", lambda p: p[::-1, ::-1].transpose(1, 0, 2)),
    ],
)
def test_pictures_stand_upright(tmp_path, colours, size, stored):
    path = save(tmp_path / "a.hdr", np.ascontiguousarray(stored(rgbe(colours))), size)
    np.testing.assert_allclose(read_picture(path).light, colours @ WEIGHTS, rtol=1e-6)


def test_xyze_and_primaries_count(tmp_path, colours):
    path = save(tmp_path / "a.hdr", rgbe(colours), kind="xyze")
    np.testing.assert_allclose(read_picture(path).light, colours[..., 1], rtol=1e-6)
    primaries = "PRIMARIES= 0.64 0.33 0.21 0.71 0.15 0.06 0.3127 0.329\n"
    path = save(tmp_path / "a.hdr", rgbe(colours), more=primaries)
    adobe = colours @ np.array([0.2973, 0.6274, 0.0753])
    np.testing.assert_allclose(read_picture(path).light, adobe, rtol=1e-3)


@pytest.mark.parametrize("pack", [np.ndarray.tobytes, packed])
def test_damaged_files_are_read_or_refused(tmp_path, rng, pack):
    whole = save(tmp_path / "a.hdr", rgbe(rng.random((6, 20, 3))), pack=pack).read_bytes()
    path = tmp_path / "b.hdr"
    check_damaged(whole, path, rng, 150, 10)
