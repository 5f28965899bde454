"""Formats of measured surfaces, by files of other programs where there are some."""

import io
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from workbench.errors import Refused
from workbench.measured.surfaces import PictureScale, read_surface

X, Y = np.linspace(-3, 3, 13), np.linspace(-2, 2, 9)
Z = 0.1 * X + 0.02 * Y[:, None] ** 2 + 0.003 * X * Y[:, None]  # (n_y, n_x)
POINTS = np.stack([each.ravel() for each in np.broadcast_arrays(X, Y[:, None], Z)], axis=1)


def read(name, content, scale=None):
    return read_surface(Path(name), io.BytesIO(content), scale)


def same(found, points=POINTS, tolerance=1e-12):
    (patch,) = found.patches
    places = [(each[:, :2] / np.abs(points).max()).round(4) for each in (patch, points)]
    ours, theirs = (np.lexsort(each.T) for each in places)
    np.testing.assert_allclose(patch[ours], points[theirs], rtol=0, atol=tolerance)


def text(delimiter=" ", comma=False, header="", more=""):
    file = io.StringIO()
    np.savetxt(file, POINTS, "%.15g", delimiter, header=header, comments="")
    written = file.getvalue()
    return ((written.replace(".", ",") if comma else written) + more).encode()


@pytest.mark.parametrize(
    "content",
    [
        text(),
        text("\t", comma=True),
        text(";", comma=True),
        text(" ", comma=True),
        text(","),
        text(", "),
        text("; "),
        b"\xef\xbb\xbf" + text(),
        text().replace(b"\n", b"\r\n"),
        text().decode().encode("utf-16"),
        b"# profiler 7\n# 13 x 9\n" + text(),
    ],
)
def test_text_with_any_separator(content):
    found = read("part.txt", content)
    same(found)
    assert found.unit is None and not found.missing


def test_titles_name_units_of_columns():
    found = read("part.csv", text(",", header="x [mm],y [mm],z [um]"))
    assert found.unit == "mm"
    same(found, POINTS * [1, 1, 1e-3])
    assert read("part.xyz", text(header="unit (µm)")).unit == "µm"


def test_further_columns_and_missing_points():
    content = b"\n".join(line + b" 0 0 1" for line in text().splitlines())
    found = read("part.xyz", content + b"\n7 7 NaN 0 0 1\n8 8 BAD\n")
    same(found)
    assert found.missing == 2


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "no line of it begins with three numbers"),
        (b"1 2 3\n" * 20, "20 points with a height; at least 100"),
        (text() + b"1 2\n", "its line 118 has no x, y and z: '1 2'"),
        (text() + b"1 2 high\n", "its line 118 has no x, y and z"),
    ],
)
def test_text_that_is_refused(content, reason):
    with pytest.raises(Refused, match=reason):
        read("part.xyz", content)


def test_unknown_ending_is_refused():
    with pytest.raises(Refused, match=r"part\.doc: is no measured surface; \.xyz"):
        read("part.doc", b"")


def test_esri_grid():
    heights = Z[::-1].copy()
    heights[0, 0] = -9999
    rows = "\n".join(" ".join(f"{z:.15g}" for z in row) for row in heights)
    header = "ncols 13\nnrows 9\nxllcenter -3\nyllcenter -2\ncellsize 0.5\nNODATA_value -9999\n"
    found = read("part.asc", (header + rows).encode())
    assert found.missing == 1
    there = ~((POINTS[:, 0] == -3) & (POINTS[:, 1] == 2))
    same(found, POINTS[there])
    with pytest.raises(Refused, match="116 heights; 13 × 9"):
        read("part.asc", (header + rows).rpartition(" ")[0].encode())


def sdf(kind, values, z_scale, size=None):
    header = struct.pack(
        "<8s10s12s12sHHddddBBB",
        *(b"bISO-1.0", b"profiler", b"281120261200", b"281120261200"),
        *(len(X), len(Y), 0.5e-3, 0.5e-3, z_scale, -1.0, 0, kind, 0),
    )
    return (header + values.tobytes())[:size]


ORIGIN = POINTS - [-3, -2, 0]  # of files that hold no origin


@pytest.mark.parametrize(
    ("kind", "type_", "step"), [(7, "<f8", 0), (3, "<f4", 0), (6, "<i4", 1e-9), (5, "<i2", 1e-7)]
)
def test_binary_surface_data_file(kind, type_, step):
    metres = Z * 1e-3
    stored = (metres / step).round() if step else metres
    stored = stored.astype(type_)
    for missing in [np.iinfo(type_).min] if step else [np.nan, np.finfo(type_).max]:
        stored[0, 0] = missing
        found = read("part.sdf", sdf(kind, stored, step or 1.0))
        assert (found.unit, found.missing) == ("m", 1)
        same(found, ORIGIN[1:] * 1e-3, max(step, 1e-10))


def test_text_surface_data_file():
    heights = "\n".join(f"{z:.15g}" for z in Z.ravel()[:-1]) + "\nBAD\n"
    content = (
        "aISO-1.0\nManufacID = profiler\nCreateDate = 281120261200\nModDate = 281120261200\n"
        "NumPoints = 13\nNumProfiles = 9\nXscale = 5e-4\nYscale = 5e-4\nZscale = 1e-3\n"
        "Zresolution = -1\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n"
        f"{heights}*\n<end/>\n*\n"
    )
    found = read("part.sdf", content.encode())
    assert found.missing == 1
    same(found, ORIGIN[:-1] * 1e-3)


def test_surface_data_files_that_are_refused():
    values = Z.astype("<f8")
    for content, reason in (
        (sdf(7, values, 1.0, -1), "cut off"),
        (sdf(9, values, 1.0), "DataType is 9"),
        (sdf(7, values, 0.0), "greater than 0"),
        (b"solid", "neither with aISO"),
    ):
        with pytest.raises(Refused, match=reason):
            read("part.sdf", content)


X3P = """<?xml version="1.0"?><p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1>
<Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>
<CX><AxisType>I</AxisType><DataType>D</DataType><Increment>5e-4</Increment><Offset>0</Offset></CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>5e-4</Increment><Offset>0</Offset></CY>
<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ></Axes></Record1><Record3><MatrixDimension>
<SizeX>13</SizeX><SizeY>9</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataLink>
<PointDataLink>bindata/data.bin</PointDataLink></DataLink></Record3></p:ISO5436_2>"""


def x3p(main=X3P, size=None):
    file = io.BytesIO()
    values = (Z * 1e-3).astype("<f8")
    values[-1, -1] = np.nan
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("main.xml", main)
        archive.writestr("bindata/data.bin", values.tobytes()[:size])
    return file.getvalue()


def test_x3p():
    found = read("part.x3p", x3p())
    assert (found.unit, found.missing) == ("m", 1)
    same(found, ORIGIN[:-1] * 1e-3)


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (x3p(size=-8), "cut off"),
        (x3p(X3P.replace("SizeX", "Size")), "no Record3/MatrixDimension/SizeX"),
        (x3p("<p"), "damaged"),
        (b"PK", "damaged"),
    ],
)
def test_x3p_that_is_refused(content, reason):
    with pytest.raises(Refused, match=reason):
        read("part.x3p", content)


def box_with_a_wave():
    """A closed body whose top is a wave: bottom and walls are no part of it."""
    body = trimesh.creation.box((6, 4, 1)).subdivide_to_size(0.3)
    top = body.vertices[:, 2] > 0.49
    body.vertices[top, 2] += 0.1 * np.cos(body.vertices[top, 0])
    return body, body.vertices[top]


@pytest.mark.parametrize("kind", ["stl", "stl_ascii"])
def test_patches_of_stl(kind):
    body, top = box_with_a_wave()
    content = body.export(file_type=kind)
    found = read("part.stl", content if isinstance(content, bytes) else content.encode())
    tops = [patch for patch in found.patches if patch[:, 2].min() > 0.3]
    assert len(tops) == 1 and len(found.patches) > 1
    # In single precision.
    expected = np.unique(top.astype(np.float32), axis=0)
    np.testing.assert_allclose(np.unique(tops[0], axis=0), expected, rtol=0, atol=1e-6)


def test_stl_that_is_refused():
    content = box_with_a_wave()[0].export(file_type="stl")
    for wrong, reason in ((content[:-10], "cut off"), (b"solid\nendsolid\n", "0 triangles")):
        with pytest.raises(Refused, match=reason):
            read("part.stl", wrong)


def picture(values, kind):
    file = io.BytesIO()
    Image.fromarray(values).save(file, kind)
    return file.getvalue()


def test_pictures_with_a_given_scale():
    low, high = Z.min(), Z.max()
    grey = np.rint((Z[::-1] - low) / (high - low) * 65535).astype(np.uint16)
    scale = PictureScale(0.5, low, high)
    same(read("part.png", picture(grey, "PNG"), scale), ORIGIN, 1e-5)
    same(read("part.tif", picture(grey, "TIFF"), scale), ORIGIN, 1e-5)
    floats = picture(Z[::-1].astype(np.float32), "TIFF")
    same(read("part.tif", floats, PictureScale(0.5)), ORIGIN, 1e-7)


@pytest.mark.parametrize(
    ("content", "scale", "reason"),
    [
        (picture(np.zeros((20, 20), np.uint16), "PNG"), None, "no scale"),
        (picture(np.zeros((20, 20), np.uint8), "PNG"), PictureScale(1), "16 bits"),
        (b"\x89PNG\r\n\x1a\n", PictureScale(1), "damaged"),
    ],
)
def test_pictures_that_are_refused(content, scale, reason):
    with pytest.raises(Refused, match=reason):
        read("part.png", content, scale)
