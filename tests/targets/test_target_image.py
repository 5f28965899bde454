import io
import struct
import zlib

import numpy as np
import pytest
from PIL import Image, ImageOps

from workbench.errors import Refused
from workbench.targets.colour import SRGB
from workbench.targets.image import read_picture
from workbench.targets.picture import LARGEST_SIDE


def read_image(path, *options, **tone):
    return read_picture(path, *options, **tone).light


LEVELS = np.array([[0, 50, 100, 150], [200, 255, 3, 7], [1, 2, 30, 90]], dtype=np.uint8)


def saved(tmp_path, image, name, **options):
    path = tmp_path / name
    image.save(path, **options)
    return path


def refusal(path):
    with pytest.raises(Refused) as caught:
        read_image(path)
    assert caught.value.path == "target.image"
    assert str(path) in caught.value.reason
    assert "\n" not in caught.value.reason
    return caught.value.reason


@pytest.mark.parametrize(
    ("colour", "grey"),
    [((255, 0, 0), 0.2126), ((0, 255, 0), 0.7152), ((0, 0, 255), 0.0722), ((51, 51, 51), 0.2)],
)
def test_colour_becomes_grey_by_rec_709(tmp_path, colour, grey):
    image = Image.new("RGB", (3, 2), colour)
    for picture in (image, image.quantize(4)):  # the second one has a palette
        read = read_image(saved(tmp_path, picture, "a.png"))
        np.testing.assert_allclose(read, np.full((2, 3), grey), rtol=1e-12)


@pytest.mark.parametrize(
    ("stored", "light"),
    # IEC 61966-2-1; 188 is what monitors show as half the light, 10 lies on the straight line.
    [(0, 0.0), (10, 10 / 255 / 12.92), (127, 0.21223), (188, 0.50289), (255, 1.0)],
)
def test_srgb_is_decoded_as_a_monitor_does(tmp_path, stored, light):
    for picture in (Image.new("L", (3, 2), stored), Image.new("RGB", (3, 2), (stored,) * 3)):
        read = read_image(saved(tmp_path, picture, "a.png"), tone=SRGB)
        np.testing.assert_allclose(read, np.full((2, 3), light), atol=1e-5)
    deep = Image.fromarray(np.full((2, 3), 257 * stored, np.uint16))
    np.testing.assert_allclose(
        read_image(saved(tmp_path, deep, "b.png"), tone=SRGB), np.full((2, 3), light), atol=1e-5
    )


@pytest.mark.parametrize("name", ["a.tif", "a.png", "a.webp"])
@pytest.mark.parametrize("orientation", range(1, 9))
def test_orientation_in_the_file_is_honoured(tmp_path, name, orientation):
    exif = Image.Exif()
    exif[0x0112] = orientation
    image = Image.fromarray(LEVELS)
    path = saved(tmp_path, image, name, exif=exif, lossless=True)
    image.getexif()[0x0112] = orientation
    upright = np.asarray(ImageOps.exif_transpose(image))
    np.testing.assert_allclose(read_image(path), upright / 255, atol=1e-15)


@pytest.mark.parametrize("dtype", ["u1", ">u2", "i8", "f2", "f4", ">f8", "?"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_npy_holds_the_values_themselves(tmp_path, dtype, order):
    levels = np.array([[0, 1, 1], [1, 0, 0]], dtype=dtype, order=order)
    path = tmp_path / "a.npy"
    np.save(path, levels)
    read = read_image(path)
    assert read.dtype == np.float64
    np.testing.assert_array_equal(read, levels.astype(float))


@pytest.mark.parametrize(
    ("array", "stated"),
    [
        (np.array([[1.0, np.nan]]), "NaN"),
        (np.array([[1.0, np.inf]]), "infinite"),
        (np.array([[1.0, -0.5]]), "-0.5"),
        (np.ones(3), "1 dimensions"),
        (np.ones((2, 2, 3)), "3 dimensions"),
        (np.ones((2, 0)), "0 × 2 pixels"),
        (np.ones((2, 2), dtype=complex), "complex128"),
        (np.array([["a", "b"]]), "<U1"),
        (np.array([[{}, 1]], dtype=object), "type object"),
    ],
)
def test_unusable_arrays_are_refused(tmp_path, array, stated):
    path = tmp_path / "a.npy"
    np.save(path, array, allow_pickle=True)
    assert stated in refusal(path)


@pytest.mark.parametrize("kind", ["PNG", "JPEG", "TIFF", "BMP", "GIF", "WEBP", "PPM", "JPEG2000"])
def test_damaged_files_are_read_or_refused(tmp_path, kind):
    random = np.random.default_rng(1)
    buffer = io.BytesIO()
    Image.fromarray(random.integers(0, 256, (16, 16), dtype=np.uint8)).save(buffer, kind)
    whole = np.frombuffer(buffer.getvalue(), dtype=np.uint8)
    path = tmp_path / "a.img"
    for _ in range(100):
        damaged = whole.copy()
        damaged[random.integers(0, min(len(whole), 300), 3)] = random.integers(0, 256, 3)
        path.write_bytes(damaged.tobytes())
        try:
            read = read_image(path)
        except Refused as refused:
            assert refused.path == "target.image"
        else:
            assert read.ndim == 2
            assert np.isfinite(read).all()
            assert read.min() >= 0


@pytest.mark.parametrize("size", [(20_000, 20_000), (60_000, 60_000)])
def test_too_many_pixels_are_refused_before_they_are_decoded(tmp_path, size):
    def chunk(name, data):
        return (
            struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        )

    header = struct.pack(">IIBBBBB", *size, 8, 0, 0, 0, 0)
    path = tmp_path / "bomb.png"
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(bytes(1000)))
        + chunk(b"IEND", b"")
    )
    assert "at most 268 million" in refusal(path)


@pytest.mark.parametrize("name", ["a.png", "a.npy"])
@pytest.mark.parametrize("shape", [(LARGEST_SIDE + 3, 4), (5, 2 * LARGEST_SIDE + 1)])
def test_a_larger_picture_is_reduced_to_its_means(tmp_path, name, shape):
    levels = np.random.default_rng(2).integers(0, 256, shape, dtype=np.uint8)
    if name == "a.npy":
        np.save(tmp_path / name, levels / 255)
    else:
        Image.fromarray(levels).save(tmp_path / name)
    found = read_picture(tmp_path / name)
    factor = -(-max(shape) // LARGEST_SIDE)
    assert found.light.shape == tuple(-(-size // factor) for size in shape)
    first = levels[:factor, :factor] / 255
    last = levels[tuple(np.s_[(size - 1) // factor * factor :] for size in shape)] / 255
    assert found.light[0, 0] == pytest.approx(first.mean())
    assert found.light[-1, -1] == pytest.approx(last.mean())
    (remark,) = found.remarks
    assert f"{shape[1]} × {shape[0]} pixels" in remark and "is reduced to" in remark


@pytest.mark.parametrize("order", ["<", ">"])
def test_16_bits_with_zero_as_white_are_read(tmp_path, order):
    levels = np.array([[0, 1, 40_000], [65_535, 7, 512]], dtype=f"{order}u2")
    tags = {256: 3, 257: 2, 258: 16, 259: 1, 262: 0, 273: 8, 277: 1, 278: 2, 279: levels.nbytes}
    table = struct.pack(f"{order}H", len(tags))
    for tag, value in tags.items():
        table += struct.pack(f"{order}HHIH2x", tag, 3, 1, value)
    begin = (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(f"{order}I", 8 + levels.nbytes)
    (tmp_path / "a.tif").write_bytes(begin + levels.tobytes() + table + bytes(4))
    np.testing.assert_allclose(read_image(tmp_path / "a.tif"), 1 - levels / 65535)
