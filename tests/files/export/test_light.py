"""Intensity and rays of the finished lens, read again by us and by other programs' readers."""

import re

import numpy as np
import photompy
import pyldt
import pytest

from workbench.files.export.far_light import directions_of
from workbench.files.export.photometric import write_ies, write_ldt
from workbench.files.export.tables import leaving
from workbench.measured.photometry import read_photometry


@pytest.fixture
def design(make_design):
    """A plate before light of a point: intensity behind it is that before it, but for losses."""
    source = {"kind": "point", "position": [0.0, 0.0, -1.0], "rays": 60_000}
    changes = {"source": source, "lens.half_width": [1.0, 1.0], "lens.reflection": "none"}
    return make_design(changes, np.full((12, 10), 0.5))


def opened(path, read):
    with path.open("rb") as file:
        return read(path, file)


WRITERS = [("lens.ies", write_ies), ("lens.ldt", write_ldt)]


CAP = 2 * np.pi * (1 - 1 / np.sqrt(3))  # all light of the point goes into a cone around the face


def behind_the_plate(direction):
    """Intensity that leaves a square plate of half its half-width in thickness, cd.

    A ray enters at tan a from the axis, and leaves tan b / 2 beside that, within the square.
    """
    x, y, z = np.moveaxis(direction, -1, 0)
    sin = np.hypot(x, y)
    way = 1 / z + 0.5 / np.sqrt(1.5**2 - sin**2)
    return 1000 / CAP * (np.maximum(np.abs(x), np.abs(y)) * way <= 1)


def distance(table, wanted, half, cells):
    """Relative L2 distance of a table from an intensity, by the means in cells of H and V."""
    finer = 10
    angle = (2 * (np.arange(cells * finer) + 0.5) / (cells * finer) - 1) * half
    h, v = np.meshgrid(angle, angle)
    seen = directions_of(h, v)
    weight = np.cos(np.radians(v))
    off, known = (
        (weight * values).reshape(cells, finer, cells, finer).sum(axis=(1, 3))
        for values in (table.at(seen) - wanted(seen), wanted(seen))
    )
    return np.linalg.norm(off) / np.linalg.norm(known)


@pytest.mark.parametrize(("name", "writer"), WRITERS)
def test_the_stated_error_is_the_distance_from_the_closed_form(design, write, name, writer):
    """Behind a plate a point shines as before it, within the square of the plate."""
    path, deviation = write(writer, design, name)

    table = opened(path, read_photometry)

    found = distance(table, behind_the_plate, 40.0, 48)
    assert deviation.unit == "%"
    assert found < 0.02
    assert found < 1.2 * deviation.size / 100
    assert table.lumens == pytest.approx(1000 * leaving(design).flux.sum(), rel=0.01)


@pytest.mark.usefixtures("coarse_tables")
def test_other_programs_read_the_same_intensity(design, write):
    ies, _ = write(write_ies, design, "lens.ies")
    ldt, _ = write(write_ldt, design, "lens.ldt")
    ours = opened(ies, read_photometry)

    theirs = photompy.IESFile.read(ies).photometry.expanded()
    around, gamma = np.random.default_rng(1).random((2, 200)) * [[360.0], [60.0]]
    seen = np.radians(around), np.radians(gamma)
    direction = np.stack(
        [np.sin(seen[1]) * np.cos(seen[0]), -np.sin(seen[1]) * np.sin(seen[0]), np.cos(seen[1])],
        axis=-1,
    )
    stated = np.array([theirs.get_intensity(g, c) for g, c in zip(gamma, around, strict=True)])
    assert np.allclose(ours.at(direction), stated.ravel(), rtol=1e-6, atol=1e-6)
    other = pyldt.LdtReader.read(ldt)
    assert np.allclose(other.intensities, ours.candela[:-1], rtol=1e-5, atol=1e-5)
    assert other.header.lamp_flux == [1000.0]


@pytest.mark.usefixtures("coarse_tables")
def test_a_narrow_beam_is_as_wide_as_it_is(make_design, write):
    """A tilted plate before the sun sends its light into a disc of 0.53°, all around one plane."""
    sun = {"kind": "collimated", "angular_diameter": 0.53, "rays": [64, 64]}
    changes = {"source": sun, "lens.half_width": [1.0, 1.0], "lens.control_points": [12, 10]}
    plane = make_design(changes)
    x, y = plane.net.positions
    design = make_design(changes, 0.5 + 0.4 * x[:, None] + 0 * y)

    path, deviation = write(write_ies, design, "narrow.ies")

    table, rays = opened(path, read_photometry), leaving(design)
    lit = table.candela > 0.5 * table.candela.max()
    aside, wide = np.ptp(table.gamma[lit.any(axis=0)]), rays.direction[:, 0]
    assert aside == pytest.approx(np.ptp(np.degrees(np.arcsin(wide))), rel=0.15)
    assert table.candela.size < 50_000
    assert table.lumens == pytest.approx(1000 * rays.flux.sum(), rel=0.01)
    assert deviation.size < 8


@pytest.mark.usefixtures("coarse_tables")
def test_files_have_the_flux_the_size_and_the_date_of_the_lens(make_design, write):
    source = {"kind": "area", "center": [0, 0, -1.5], "half_width": [0.05, 0.05], "flux": 200}
    for outline in ("rectangle", "ellipse"):
        changes = {"source": source, "lens.outline": outline, "lens.half_width": [1.0, 1.0]}
        design = make_design(changes, np.full((12, 10), 0.5))
        (ies, deviation), (ldt, _) = (
            write(writer, design, f"{outline}.{name}") for name, writer in WRITERS
        )
        words = ies.read_text().split("TILT=NONE")[1].split()
        sign = 1 if outline == "rectangle" else -1
        assert [float(word) for word in words[:3]] == [1, 200, 1]
        assert [float(word) for word in words[6:10]] == [2, 0.02 * sign, 0.02 * sign, 0]
        assert re.search(r"\[ISSUEDATE\] \d{4}-\d\d-\d\d", ies.read_text())
        header = pyldt.LdtReader.read(ldt).header
        width = 20.0 if outline == "rectangle" else 0.0
        assert (header.length, header.width, header.height) == (20.0, width, 0.0)
        assert (header.length_lum_area, header.width_lum_area) == (20.0, width)
        assert header.lamp_flux == [200.0]
        tables = [opened(path, read_photometry) for path in (ies, ldt)]
        assert tables[0].lumens == pytest.approx(tables[1].lumens, rel=1e-4)
        assert tables[0].lumens == pytest.approx(2 * header.lorl, rel=1e-4)
        assert tables[0].lumens == pytest.approx(200 * leaving(design).flux.sum(), rel=0.01)
        assert "of 200 lm" in deviation.note
