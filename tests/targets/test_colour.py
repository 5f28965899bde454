"""Light by the colour profile of a picture, or by the chunks of a PNG."""

import struct
import zlib

import numpy as np
import pytest
from PIL import Image

from workbench.targets.colour import SRGB
from workbench.targets.image import read_picture
from workbench.targets.picture import Picture

D65 = 0.3127, 0.3290
SRGB_COLORANTS = (
    (0.43607, 0.22249, 0.01392),
    (0.38515, 0.71687, 0.09708),
    (0.14307, 0.06061, 0.71410),
)


def profile(gamma, colorants=None):
    """An ICC profile: of grey, or of red, green and blue."""

    def place(xyz):
        return struct.pack(">4s4x3i", b"XYZ ", *(round(v * 65536) for v in xyz))

    curve = struct.pack(">4s4xIH2x", b"curv", 1, round(gamma * 256))
    tags = {b"wtpt": place((0.9642, 1, 0.8249)), b"cprt": b"text\0\0\0\0none\0\0\0\0"}
    tags[b"desc"] = struct.pack(">4s4xI", b"desc", 5) + b"Mine\0" + bytes(79)
    if colorants is None:
        tags[b"kTRC"] = curve
    else:
        for name, xyz in zip(b"rgb", colorants, strict=True):
            tags[bytes([name]) + b"XYZ"] = place(xyz)
            tags[bytes([name]) + b"TRC"] = curve
    table, content, begin = b"", b"", 132 + 12 * len(tags)
    for tag, part in tags.items():
        table += struct.pack(">4s2I", tag, begin + len(content), len(part))
        content += part
    space = b"GRAY" if colorants is None else b"RGB "
    head = struct.pack(
        ">I4xI4s4s4s12x4s28x3i48x",
        begin + len(content),
        0x02400000,
        b"mntr",
        space,
        b"XYZ ",
        b"acsp",
        63190,
        65536,
        54061,
    )
    return head + struct.pack(">I", len(tags)) + table + content


def with_chunks(path, chunks):
    """A PNG with chunks behind its header."""
    content = path.read_bytes()
    added = b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in chunks.items()
    )
    path.write_bytes(content[:33] + added + content[33:])


def grey(value=128, mode="L"):
    return Image.fromarray(np.array([[value, 255]], np.uint8)).convert(mode)


def read(tmp_path, image, name="a.png", tone=SRGB, **options) -> Picture:
    path = tmp_path / name
    image.save(path, **options)
    return read_picture(path, tone=tone)


@pytest.mark.parametrize("name", ["a.png", "a.jpg", "a.tif", "a.webp", "a.avif", "a.heic"])
@pytest.mark.parametrize("gamma", [1.0, 1.8])
def test_the_curve_of_a_profile_counts(tmp_path, name, gamma):
    import pillow_heif

    pillow_heif.register_heif_opener()
    lossless = (
        {} if name.endswith(("png", "tif", "jpg")) else {"quality": -1 if "heic" in name else 100}
    )
    if name == "a.webp":
        lossless = {"lossless": True}
    image = Image.fromarray(np.full((16, 16, 3), 128, np.uint8))
    image.paste((255, 255, 255), (0, 8, 16, 16))
    found = read(tmp_path, image, name, icc_profile=profile(gamma, SRGB_COLORANTS), **lossless)
    assert found.light[3, 3] / found.light[12, 12] == pytest.approx((128 / 255) ** gamma, abs=6e-3)
    (remark,) = found.remarks
    assert "Mine" in remark and "target.tone" in remark and name in remark


@pytest.mark.parametrize(
    "content",
    [b"no profile", profile(1.8, SRGB_COLORANTS)[:300], bytes(500), profile(1.8)],
    ids=["text", "cut off", "zeros", "of grey"],
)
def test_a_profile_that_cannot_be_used_is_reported_and_ignored(tmp_path, content):
    found = read(tmp_path, grey(mode="RGB"), icc_profile=content)
    assert found.light[0, 0] == pytest.approx(0.21586, abs=1e-5)
    (remark,) = found.remarks
    assert "cannot be used" in remark and "\n" not in remark


def gama(gamma):
    return {b"gAMA": struct.pack(">I", round(gamma * 1e5))}


def chrm(white, primaries):
    numbers = [round(v * 1e5) for pair in (white, *primaries) for v in pair]
    return {b"cHRM": struct.pack(">8I", *numbers)}


@pytest.mark.parametrize(
    ("chunks", "expected"),
    [
        (gama(1.0), 128 / 255),
        (gama(1 / 1.8), (128 / 255) ** 1.8),
        (gama(1.0) | {b"sRGB": b"\0"}, 0.21586),
        ({}, 0.21586),
        (chrm(D65, ((0.6, 0.3), (0.2, 0.7), (0.1, 0.1))), 0.21586),  # says nothing of greys
        (gama(0.0), 0.21586),
    ],
)
def test_chunks_of_a_png_tell_the_curve(tmp_path, chunks, expected):
    path = tmp_path / "a.png"
    grey().save(path)
    with_chunks(path, chunks)
    assert read_picture(path, tone=SRGB).light[0, 0] == pytest.approx(expected, abs=1e-4)
