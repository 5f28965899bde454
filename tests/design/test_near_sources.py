"""How many samples of a lens, and cells of its source, make the image of a near source."""

import pytest

from workbench.design.near_sources import source_cells


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
