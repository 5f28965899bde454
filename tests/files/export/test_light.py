"""Intensity and rays of the finished lens, read again by us and by other programs' readers."""

import numpy as np
import photompy
import pyldt
import pytest

from workbench.files.export.leaving import leaving
from workbench.files.export.photometric import intensity_of_rays, write_ies, write_ldt
from workbench.files.export.tm25 import write_tm25
from workbench.measured.photometry import read_photometry
from workbench.measured.rays import read_rays


@pytest.fixture
def design(make_design):
    """A plate before light of a point: intensity behind it is that before it, but for losses."""
    source = {"kind": "point", "position": [0.0, 0.0, -1.0], "rays": 60_000}
    changes = {"source": source, "lens.half_width": [1.0, 1.0], "lens.reflection": "none"}
    return make_design(changes, np.full((12, 10), 0.5))


def opened(path, read):
    with path.open("rb") as file:
        return read(path, file)


def off(table, rays):
    """How far the flux of a table is from that of the rays, of 1000 lm."""
    return abs(table.lumens / (1000 * rays.flux.sum()) - 1)


def inner(gamma):
    return (gamma > 5) & (gamma < 35)  # where all light that enters leaves


@pytest.mark.parametrize("name", ["lens.ies", "lens.ldt"])
def test_intensity_behind_a_plate_is_that_before_it(design, write, name):
    writer = write_ldt if name.endswith("ldt") else write_ies
    path, deviation = write(writer, design, name)

    table = opened(path, read_photometry)

    out = leaving(design).flux.sum()
    assert table.lumens == pytest.approx(1000 * out, rel=0.01)
    assert deviation.size < 0.01
    assert "rays" in deviation.note
    # Into the cone around the face, of all 1000 lm.
    cap = 2 * np.pi * (1 - 1 / np.sqrt(3))
    mean = table.candela[:, inner(table.gamma)].mean()
    assert mean == pytest.approx(1000 / cap, rel=0.02)
    assert (table.candela[:, table.gamma > 60] == 0).all()


def test_other_programs_read_the_same_intensity(design, write):
    ies, _ = write(write_ies, design, "lens.ies")
    ldt, _ = write(write_ldt, design, "lens.ldt")
    ours = opened(ies, read_photometry)

    theirs = photompy.IESFile.read(ies).photometry
    assert np.allclose(theirs.values, ours.candela, rtol=1e-5)
    assert np.allclose(theirs.thetas, ours.gamma)
    other = pyldt.LdtReader.read(ldt)
    assert np.allclose(other.intensities, ours.candela[:-1], rtol=1e-5, atol=1e-6)
    assert other.header.isym == 0 and other.header.lamp_flux == [1000.0]


def test_light_that_is_bent_aside_is_on_its_side(make_design, write):
    """A prism that is thicker at +x bends light to +x, which is C0, and one at +y to C270."""
    x, y = np.linspace(-1, 1, 12)[:, None], np.linspace(-1, 1, 10)
    for heights, plane in ((0.5 + 0.2 * x + 0 * y, 0.0), (0.5 + 0.2 * y + 0 * x, 270.0)):
        design = make_design({"lens.half_width": [1.0, 1.0]}, heights)
        path, _ = write(write_ies, design, f"prism-{plane:g}.ies")
        table = opened(path, read_photometry)
        brightest, _ = np.unravel_index(table.candela.argmax(), table.candela.shape)
        assert table.c[brightest] % 360 == plane


@pytest.mark.parametrize("name", ["lens.ies", "lens.ldt"])
@pytest.mark.parametrize("wide", [0.0, 0.02, 0.5])
def test_flux_of_the_file_is_that_of_the_rays_at_the_pole(make_design, write, name, wide):
    """A plate sends all parallel light into the nadir; a bulge sends it around there."""
    x, y = np.linspace(-1, 1, 12)[:, None], np.linspace(-1, 1, 10)
    design = make_design({"lens.half_width": [1.0, 1.0]}, 0.5 - wide * (x**2 + y**2) / 2)

    path, deviation = write(write_ldt if name.endswith("ldt") else write_ies, design, name)

    table, rays = opened(path, read_photometry), leaving(design)
    assert off(intensity_of_rays(rays, design.scene.optic), rays) < 1e-9
    assert deviation.size == pytest.approx(off(table, rays), rel=1e-3, abs=1e-15)
    assert deviation.size < 1e-5  # six digits stand in the file


@pytest.mark.parametrize("name", ["mirror.ies", "mirror.ldt"])
def test_light_of_a_mirror_is_around_the_nadir(make_mirror, write, name):
    design = make_mirror()

    path, deviation = write(write_ldt if name.endswith("ldt") else write_ies, design, name)

    table, rays = opened(path, read_photometry), leaving(design)
    assert off(intensity_of_rays(rays, design.scene.optic), rays) < 1e-9
    assert deviation.size == pytest.approx(off(table, rays), rel=1e-3, abs=1e-15)
    assert deviation.size < 1e-5
    assert "nadir is −z" in deviation.note
    assert (table.candela[:, table.gamma > 90] == 0).all()
    # Where a lamp with this file shines if it is turned about x, so that its nadir is −z.
    backwards = rays.direction * [1, -1, -1]
    assert np.average(table.at(backwards) > 0, weights=rays.flux) > 0.999


def test_light_that_a_mirror_sends_aside_is_on_its_side(make_mirror, write):
    """What is reflected to +x is in C0; what is reflected to +y, towards −z, is in C90."""
    x, y = np.linspace(-1, 1, 7)[:, None], np.linspace(-1, 1, 6)
    for heights, plane in ((0.2 * x + 0 * y, 0.0), (0.2 * y + 0 * x, 90.0)):
        path, _ = write(write_ies, make_mirror({}, heights), f"tilted-{plane:g}.ies")
        table = opened(path, read_photometry)
        brightest, _ = np.unravel_index(table.candela.argmax(), table.candela.shape)
        assert table.c[brightest] % 360 == plane


def test_rays_behind_the_lens_are_read_again(design, write):
    path, deviation = write(write_tm25, design, "lens.tm25ray")

    found, rays = opened(path, read_rays), leaving(design)

    assert found.unit == "mm"
    assert np.allclose(found.position, 10 * rays.position, atol=1e-5)
    assert np.allclose(found.direction, rays.direction, atol=1e-6)
    assert found.total == pytest.approx(rays.flux.sum(), rel=1e-5)
    assert np.allclose(found.position[:, 2], 5.0, atol=1e-5)
    assert deviation.size < 1e-6
