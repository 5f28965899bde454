import io
import struct
import zlib

import numpy as np
import pillow_heif
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


@pytest.mark.parametrize("name", ["a.png", "a.tif", "a.bmp", "a.gif", "a.pgm", "a.jp2", "a.PNG"])
def test_grey_levels_are_linear_and_exact(tmp_path, name):
    path = saved(tmp_path, Image.fromarray(LEVELS), name)
    np.testing.assert_allclose(read_image(path), LEVELS / 255, atol=1e-15)


def test_lossless_webp_and_tga(tmp_path):
    grey = Image.fromarray(LEVELS)
    path = saved(tmp_path, grey.convert("RGB"), "a.webp", lossless=True)
    np.testing.assert_allclose(read_image(path), LEVELS / 255, atol=1e-15)
    np.testing.assert_allclose(read_image(saved(tmp_path, grey, "a.tga")), LEVELS / 255)


def test_jpeg_to_its_own_precision(tmp_path):
    smooth = np.tile(np.linspace(20, 220, 32).astype(np.uint8), (32, 1))
    path = saved(tmp_path, Image.fromarray(smooth), "a.jpg", quality=95)
    np.testing.assert_allclose(read_image(path), smooth / 255, atol=3 / 255)


def test_the_ending_of_a_picture_does_not_matter(tmp_path):
    path = saved(tmp_path, Image.fromarray(LEVELS), "picture", format="PNG")
    np.testing.assert_array_equal(read_image(path), LEVELS / 255)


@pytest.mark.parametrize("ending", ["png", "tif"])
def test_sixteen_bits_keep_their_precision(tmp_path, ending):
    levels = np.array([[0, 1, 256], [257, 40001, 65535]], dtype=np.uint16)
    read = read_image(saved(tmp_path, Image.fromarray(levels), f"a.{ending}"))
    ratio = read / read.max()  # only ratios count
    np.testing.assert_allclose(ratio, levels / 65535, rtol=1e-15)


def test_float_tiff(tmp_path):
    levels = np.array([[0.0, 0.25], [1e6, 3.0]], dtype=np.float32)
    read = read_image(saved(tmp_path, Image.fromarray(levels), "a.tif"))
    np.testing.assert_array_equal(read, levels)


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


def test_srgb_weighs_light_not_stored_values(tmp_path):
    picture = Image.new("RGB", (1, 1), (255, 127, 0))
    read = read_image(saved(tmp_path, picture, "a.png"), tone=SRGB)
    assert read.item() == pytest.approx(0.2126 + 0.7152 * 0.212231, rel=1e-4)


def test_light_and_stored_values_of_a_tone_are_inverse():
    values = np.linspace(0, 1, 1001)
    np.testing.assert_allclose(SRGB.stored(SRGB.light(values)), values, atol=1e-7)
    assert np.all(np.diff(SRGB.light(values)) > 0)


@pytest.mark.parametrize("ending", ["npy", "tif"])
def test_numbers_are_no_shades_of_a_monitor(tmp_path, ending):
    path = tmp_path / f"a.{ending}"
    if ending == "npy":
        np.save(path, np.ones((2, 3)))
    else:
        Image.fromarray(np.ones((2, 3), np.float32)).save(path)
    with pytest.raises(Refused, match="'srgb' is for shades") as caught:
        read_image(path, tone=SRGB)
    assert caught.value.path == "target.tone"
    assert read_image(path).max() == 1


def test_transparency_lies_over_black(tmp_path):
    rgba = np.full((2, 2, 4), 255, dtype=np.uint8)
    rgba[..., 3] = [[0, 51], [102, 255]]
    alpha = np.array([[0, 0.2], [0.4, 1]])
    image = Image.fromarray(rgba)
    np.testing.assert_allclose(read_image(saved(tmp_path, image, "a.png")), alpha, rtol=1e-12)
    grey_alpha = saved(tmp_path, image.convert("LA"), "b.png")
    np.testing.assert_allclose(read_image(grey_alpha), alpha, rtol=1e-12)


@pytest.mark.parametrize("black", [0, 1])  # transparent edges are rounded to one or the other
def test_a_black_drawing_on_a_transparent_ground_is_light_by_its_opacity(tmp_path, black):
    rgba = np.full((2, 2, 4), black, dtype=np.uint8)
    rgba[..., 3] = [[0, 51], [102, 255]]
    image = Image.fromarray(rgba)
    for picture, name in ((image, "a.png"), (image.convert("LA"), "b.png")):
        read = read_image(saved(tmp_path, picture, name))
        np.testing.assert_allclose(read, [[0, 0.2], [0.4, 1]], rtol=1e-12)


def test_black_without_anything_transparent_stays_black(tmp_path):
    path = saved(tmp_path, Image.new("RGBA", (3, 2), (0, 0, 0, 255)), "a.png")
    np.testing.assert_array_equal(read_image(path), np.zeros((2, 3)))


def test_a_dark_colour_beside_a_bright_one_keeps_its_own_brightness(tmp_path):
    rgba = np.array([[[0, 0, 0, 255], [255, 255, 255, 255], [9, 9, 9, 0]]], dtype=np.uint8)
    read = read_image(saved(tmp_path, Image.fromarray(rgba), "a.png"))
    np.testing.assert_allclose(read, [[0, 1, 0]], atol=1e-12)


def test_transparent_colour_of_a_palette_is_black(tmp_path):
    image = Image.fromarray(np.array([[0, 1], [1, 0]], dtype=np.uint8)).convert("P")
    image.putpalette([255, 255, 255, 255, 255, 255])
    path = saved(tmp_path, image, "a.gif", transparency=1, optimize=False)
    np.testing.assert_array_equal(read_image(path), [[1, 0], [0, 1]])


def test_first_frame_counts(tmp_path):
    frames = [Image.new("L", (4, 4), level) for level in (255, 0)]
    path = tmp_path / "a.gif"
    frames[0].save(path, save_all=True, append_images=frames[1:])
    np.testing.assert_array_equal(read_image(path), np.ones((4, 4)))


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


def test_npy_is_released_after_reading(tmp_path):
    path = tmp_path / "a.npy"
    np.save(path, np.ones((2, 2)))
    read = read_image(path)
    np.save(path, np.zeros((2, 2)))
    np.testing.assert_array_equal(read, np.ones((2, 2)))


@pytest.mark.parametrize(
    ("array", "said"),
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
def test_unusable_arrays_are_refused(tmp_path, array, said):
    path = tmp_path / "a.npy"
    np.save(path, array, allow_pickle=True)
    assert said in refusal(path)


def test_forged_header_takes_no_memory(tmp_path):
    path = tmp_path / "a.npy"
    header = {"descr": "<f8", "fortran_order": False, "shape": (10_000, 10_000)}
    with open(path, "wb") as file:
        np.lib.format.write_array_header_1_0(file, header)
    assert "not a whole .npy" in refusal(path)


FOREIGN = [
    b"",
    b"no array",
    b"PK\x03\x04",
    b"\x93NUMPY\x01\x00",
    b"\x93NUMPY\x02\x00\xff\xff\xff\xff{}",
    b"\x93NUMPY\x01\x00\x60\xea" + b"(" * 60_000,
    b"\x93NUMPY\x01\x00\x60\x00" + b"{1: 2, [3]: 4}".ljust(96),
    b"\x93NUMPY\x01\x00\x60\x00"
    + b"{'descr': '|u1', 'fortran_order': False, 'shape': (True, 4)}".ljust(95)
    + b"\n123",
]


@pytest.mark.parametrize("content", FOREIGN)
def test_foreign_content_named_npy_is_refused(tmp_path, content):
    path = tmp_path / "a.npy"
    path.write_bytes(content)
    refusal(path)


def test_missing_file_and_folder_are_refused(tmp_path):
    assert "not an existing file" in refusal(tmp_path / "missing.png")
    assert "is a folder" in refusal(tmp_path)


@pytest.mark.parametrize("ending", ["png", "npy"])
def test_refusal_of_the_operating_system_is_passed_on(tmp_path, ending):
    # A name that no file system takes stands for every error that the system may answer with.
    assert "cannot be read: " in refusal(tmp_path / ("x" * 300 + "." + ending))


@pytest.mark.parametrize(
    "content", [b"", b"hello", b"%!PS-Adobe-3.0 EPSF-3.0\n", bytes(500), b"<p>"]
)
def test_other_files_are_refused(tmp_path, content):
    path = tmp_path / "a.png"
    path.write_bytes(content)
    assert "not an image" in refusal(path)


@pytest.mark.parametrize("kind", ["PNG", "JPEG", "TIFF", "BMP", "GIF", "WEBP", "PPM", "JPEG2000"])
def test_half_a_file_is_refused(tmp_path, kind):
    noise = np.random.default_rng(0).integers(0, 256, (64, 64), dtype=np.uint8)
    buffer = io.BytesIO()
    Image.fromarray(noise).save(buffer, kind)
    whole = buffer.getvalue()
    path = tmp_path / "a.img"
    path.write_bytes(whole[: len(whole) // 2])
    refusal(path)


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


def test_light_is_averaged_and_not_its_shades(tmp_path):
    Image.fromarray(np.tile(np.array([0, 255], np.uint8), (1, LARGEST_SIDE))).save(
        tmp_path / "a.png"
    )
    np.testing.assert_allclose(read_picture(tmp_path / "a.png", tone=SRGB).light, 0.5)


@pytest.mark.parametrize("order", ["<", ">"])
def test_16_bits_with_zero_as_white_are_read(tmp_path, order):
    levels = np.array([[0, 1, 40_000], [65_535, 7, 512]], dtype=f"{order}u2")
    path = tmp_path / "a.tif"
    path.write_bytes(tiff(levels, order))
    np.testing.assert_allclose(read_image(path), 1 - levels / 65535)


def test_16_bits_of_a_pgm_are_shades(tmp_path):
    levels = np.array([[0, 1, 40_000], [65_535, 7, 512]], np.uint16)
    found = read_picture(saved(tmp_path, Image.fromarray(levels), "a.pgm"), tone=SRGB)
    np.testing.assert_allclose(found.light, SRGB.light(levels / 65535))


@pytest.mark.parametrize("length", [4, 8, 12, 40])
def test_the_beginning_of_a_tiff_is_no_image(tmp_path, length):
    (tmp_path / "a.tif").write_bytes((b"II*\0" + bytes(60))[:length])
    assert "not an image" in refusal(tmp_path / "a.tif")


def tiff(levels, order):
    """An uncompressed TIFF of 16 bits in which zero is white."""
    rows, columns = levels.shape
    entries = [
        (256, 4, columns),
        (257, 4, rows),
        (258, 3, 16),
        (259, 3, 1),
        (262, 3, 0),
        (273, 4, 8),
        (277, 3, 1),
        (278, 4, rows),
        (279, 4, levels.nbytes),
    ]
    table = struct.pack(f"{order}H", len(entries)) + b"".join(
        struct.pack(f"{order}HHI", tag, kind, 1)
        + struct.pack(f"{order}I" if kind == 4 else f"{order}H2x", value)
        for tag, kind, value in entries
    )
    mark = b"II*\0" if order == "<" else b"MM\0*"
    data = levels.tobytes()
    return mark + struct.pack(f"{order}I", 8 + len(data)) + data + table + bytes(4)


def test_a_picture_of_a_phone_is_read(tmp_path):
    pillow_heif.register_heif_opener()
    levels = np.kron(LEVELS, np.ones((8, 8), np.uint8))
    read = read_image(saved(tmp_path, Image.fromarray(levels), "a.heic", quality=-1))
    assert read.shape == levels.shape and np.abs(read - levels / 255).max() < 0.02


def test_the_number_of_frames_is_mentioned(tmp_path):
    frames = [Image.new("L", (4, 4), level) for level in (255, 0)]
    frames[0].save(tmp_path / "a.tif", save_all=True, append_images=frames[1:])
    found = read_picture(tmp_path / "a.tif")
    assert found.light.min() == 1 and "2 frames" in found.remarks[0]
