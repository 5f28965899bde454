import csv
from dataclasses import replace

import numpy as np
import pytest

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.interfaces import DielectricBoundary
from workbench.analysis.tracing.surfaces.spline import SplineFace
from workbench.files.export.tables import write_rays, write_tm25
from workbench.measured.rays import read_rays
from workbench.scene.paths import with_values


def load(path):
    with path.open(newline="") as file:
        head, *rows = csv.reader(file)
    return head, np.array(rows, dtype=float).T


@pytest.fixture
def gentle(make_design, rng):
    def make(source):
        return make_design({"source": source}, 0.5 + 0.01 * rng.random((12, 10)))

    return make


def meet(design, places):
    """Rays along the axis, and where they meet the exit face."""
    start = np.column_stack([places, np.zeros(len(places))])
    rays = TracedRays(start, np.array([[0.0, 0.0, 1.0]]), np.ones(len(places)))
    return rays, SplineFace(design.scene.optic, design.heights, "left_side").meet(rays)


def test_collimated_light_by_another_tracer(gentle, write):
    design = gentle({"kind": "collimated", "rays": [48, 32]})
    path, deviation = write(write_rays, design, "lens.rays.csv")
    assert deviation.kind == "rounding"
    assert deviation.size < 1e-12
    head, (x, y, z, cos_x, cos_y, cos_z, flux) = load(path)
    assert head == ["x [cm]", "y [cm]", "z [cm]", "cos x", "cos y", "cos z", "flux"]
    across, up = (np.arange(48) + 0.5) / 24 - 1, 0.7 * ((np.arange(32) + 0.5) / 16 - 1)
    places = np.stack(np.meshgrid(across, up, indexing="ij"), axis=-1).reshape(-1, 2)
    rays, crossings = meet(design, places)
    behind, lost = DielectricBoundary(1.5, 1.0, "fresnel_exit").turn(rays, crossings)
    assert (crossings.flux == 1).all()
    assert not lost["total_reflection"].any()
    at, (d_x, d_y, d_z) = behind.position.T, behind.direction.T
    path = (5.0 - at[2]) / d_z
    assert x == pytest.approx(at[0] + d_x * path, abs=1e-12)
    assert y == pytest.approx(at[1] + d_y * path, abs=1e-12)
    assert (z == 5.0).all()
    way = np.column_stack([x - places[:, 0], y - places[:, 1], 5.0 - at[2]])
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    assert np.column_stack([cos_x, cos_y, cos_z]) == pytest.approx(way, abs=1e-12)
    assert flux == pytest.approx(0.96 * behind.flux / len(places), rel=1e-9)


def test_rays_of_several_lines_have_their_wavelengths_in_both_formats(make_design, write):
    glass = {"lens.refractive_index": "N-BK7", "lens.wavelength_um": 0.55}
    one = make_design({"source.rays": [10, 10], **glass}, np.full((12, 10), 0.5))
    lines = {"source.wavelength_um": None, "source.spectrum": [[0.45, 1], [0.6, 3]]}
    design = replace(one, scene=with_values(one.scene, lines))
    for name, writer in (("lens.rays.csv", write_rays), ("lens.tm25ray", write_tm25)):
        path, _ = write(writer, design, name)
        with path.open("rb") as file:
            rays = read_rays(path, file)
        blue = rays.wavelength_nm == 450
        assert set(rays.wavelength_nm[~blue]) == {600}
        assert rays.flux[blue].sum() == pytest.approx(rays.flux.sum() / 4, rel=5e-3)
