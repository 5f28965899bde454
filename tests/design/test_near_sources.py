"""How many samples of a lens, and cells of its source, make the image of a near source."""

import pytest
import torch

from resources import path
from workbench.design.limits import bounded, undesigned
from workbench.design.near_sources import fitting_source_cells, source_cells
from workbench.files.session import open_design

FAR_OR_SHARP = {
    "sun": {"kind": "collimated", "angular_diameter": 0.533, "rays": [16, 16]},
    "point": {"kind": "point", "position": [0, 0, -2.0]},
    "grid": {
        "kind": "grid",
        "center": [0, 0, -2.0],
        "half_width": [0.3, 0.3],
        "points": [3, 3],
        "rays": 64,
    },
}


@pytest.mark.parametrize("source", FAR_OR_SHARP.values(), ids=FAR_OR_SHARP)
def test_only_light_of_an_emitter_runs_between_its_origins(make_scene, source):
    assert source_cells(make_scene({"version": 2, "source": source})) is None


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
@pytest.mark.parametrize("width", [0.001, 0.1, 0.3, 0.5, 0.9])
@pytest.mark.parametrize("mirrored", [(False, False), (True, False), (False, True), (True, True)])
def test_grids_of_a_source_have_rows_in_pairs_and_the_middle_where_half_is_traced(
    make_scene, outline, width, mirrored
):
    led = {"kind": "area", "center": [0, 0, -1.0], "half_width": [width, width / 2]}
    scene = make_scene({"version": 2, "source": led | {"outline": outline}})
    across, up = source_cells(scene, mirrored).of_source
    assert across >= 2
    assert across % 2 == 0
    if mirrored[1]:
        assert up % 4 == 2
    else:
        assert up >= 3
        assert up % 2 == 1


@pytest.fixture
def cells_of(make_scene):
    """Samples of the lens and cells of the source, by its half-width and control points along x."""

    def cells(width, points):
        led = {"kind": "area", "center": [0, 0, -1.0], "half_width": [width, width]}
        changes = {"lens.control_points": [points, 2 * points], "screen.pixels": [80, 100]}
        return source_cells(make_scene({"version": 2, "source": led} | changes))

    return cells


def test_wider_sources_and_more_control_points_need_more(cells_of):
    assert cells_of(0.4, 40).origins > cells_of(0.1, 40).origins
    assert (cells_of(0.1, 40).x, cells_of(0.1, 40).y) == (180, 360)


def test_fine_nets_need_no_more_than_pixels_but_each_control_point_is_seen(cells_of):
    assert (cells_of(0.1, 100).x, cells_of(0.1, 100).y) == (288, 380)


@pytest.mark.parametrize("name", ["led-dome", "phone-torch"])
def test_samples_of_a_lens_are_near_each_other_unless_its_source_is_tiny(name):
    scene = open_design(path("examples", f"{name}.json")).scene
    heights = {face: torch.tensor(z) for face, z in undesigned(bounded(scene)).items()}
    mirrored = (True, True)
    assert fitting_source_cells(scene, heights, mirrored) == source_cells(scene, mirrored)
    tiny = scene.model_copy(update={"source": scene.source.shrunk(0.01)})
    assert fitting_source_cells(tiny, heights, mirrored) is None
