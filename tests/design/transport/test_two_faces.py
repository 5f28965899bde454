"""First lenses of two faces that share the bending of the light."""

import numpy as np
import pytest

from workbench.design.run import run
from workbench.design.transport.first_design import first_error, first_of
from workbench.design.transport.two_faces import split_start
from workbench.geometry.surface import freeform_nets

FREEFORM = {
    "lens.entrance": {"shape": "freeform", "control_points": [16, 16]},
    "lens.control_points": [16, 16],
    "lens.height_range": None,
    "screen.pixels": [24, 24],
}


@pytest.mark.parametrize(
    "source",
    [
        {"kind": "collimated"},
        {"kind": "point", "position": [0.0, 0.0, -1.5]},
    ],
    ids=["parallel", "near point"],
)
def test_light_that_needs_no_turn_finds_two_flat_faces(make_scene, source):
    scene = make_scene({**FREEFORM, "source": source, "screen.half_width": [5.0, 5.0]})
    plate = next(run(scene, np.ones((24, 24)))).state.irradiance
    heights = split_start(scene, plate)
    turned = split_start(scene, np.eye(24))
    # The rim of the light of a plate lies within pixels, which few control points follow.
    for face, z in heights.items():
        assert np.ptp(z[2:-2, 2:-2]) < 0.15 * np.ptp(turned[face])


class TestOneFaceIsFixed:
    @pytest.fixture
    def scene(self, make_scene):
        return make_scene({**FREEFORM, "screen.half_width": [1.5, 1.5]})

    @pytest.fixture
    def disc(self):
        across = np.linspace(-1, 1, 24)
        return (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)

    @pytest.fixture
    def fixed(self, scene):
        """Heights of an undesigned face with a wave of this height on it."""

        def heights(face, wave):
            net = freeform_nets(scene.optic)[face]
            x, y = net.positions
            level = next(run(scene, np.ones((24, 24)))).state.heights[face].mean()
            return level + wave * np.cos(3 * x)[:, None] * np.cos(2 * y)

        return heights

    @pytest.mark.parametrize("face", ["lens.front", "lens.back"])
    @pytest.mark.parametrize("wave", [0.0, 0.02])
    def test_the_other_one_sends_the_light_where_it_should_go(self, scene, disc, fixed, face, wave):
        given = fixed(face, wave)
        first = first_of(scene, disc, {face: given})
        np.testing.assert_array_equal(first.heights[face], given)
        other = {"lens.front": "lens.back", "lens.back": "lens.front"}[face]
        level = np.full_like(first.heights[other], first.heights[other].mean())
        assert first_error(scene, disc, first.heights) < 0.35 * first_error(
            scene, disc, {face: given, other: level}
        )

    @pytest.mark.parametrize("face", ["lens.front", "lens.back"])
    def test_a_run_begins_with_it(self, scene, disc, fixed, face):
        start = {each: fixed(each, 0.0) for each in ("lens.front", "lens.back")}
        locked = {face: np.ones_like(start[face], dtype=bool)}
        undesigned, first, *_ = run(scene, disc, locked=locked)
        np.testing.assert_array_equal(first.state.heights[face], undesigned.state.heights[face])
        assert first.state.loss < 0.35**2 * undesigned.state.loss
