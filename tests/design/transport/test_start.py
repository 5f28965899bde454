"""First lenses by transport."""

import numpy as np
import pytest

from tests.measured.photometry.files import ies
from workbench.analysis.validation import validate
from workbench.design.limits import undesigned
from workbench.design.transport import transport_start
from workbench.scene import Scene

SOURCES = {
    "collimated": {"kind": "collimated", "rays": [64, 64]},
    "point": {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 4096},
    "aside": {"kind": "point", "position": [0.8, -0.3, -4.0], "rays": 4096},
    "grid": {
        "kind": "grid",
        "center": [0.0, 0.0, -5.0],
        "half_width": [0.02, 0.02],
        "points": [3, 3],
        "rays": 500,
    },
}


@pytest.fixture
def corner():
    """An image without any symmetry: a bright corner, a dim bar."""
    image = np.zeros((32, 32))
    image[4:16, 5:13] = 1.0
    image[20:26, 6:28] = 0.3
    return image


FLAT = {"shape": "flat", "height": 0.5}
CONVEX = {"shape": "sphere", "height": 0.5, "radius": 4.0, "form": "convex"}


@pytest.mark.parametrize(
    ("source", "base"), [*((source, FLAT) for source in SOURCES), ("aside", CONVEX)]
)
def test_the_first_lens_sends_light_near_its_target(make_scene, corner, source, base):
    scene = make_scene(
        {
            "source": SOURCES[source],
            "lens.base": base,
            "lens.control_points": [40, 36],
            "lens.height_range": None,
        }
    )
    heights = transport_start(scene, corner)
    seen = validate(scene, corner, {"lens.back": heights}, 50_000)
    before = validate(scene, corner, undesigned(scene.optic), 20_000)
    assert seen.relative_l2 < 0.35 < before.relative_l2_corrected
    assert seen.account.lost["off_screen"] < 0.01 and seen.account.lost["total_reflection"] < 0.001


def test_the_light_of_a_lamp_that_shines_to_one_side_is_spread_as_wanted(make_scene, tmp_path):
    c, gamma = np.arange(0, 361, 15.0), np.arange(0, 91, 5.0)
    turned, steep = np.radians(c)[:, None], np.radians(gamma)
    candela = 1000 * np.cos(steep) * (1 + 0.9 * np.sin(2 * steep) * np.cos(turned)) ** 2
    lamp = tmp_path / "lamp.ies"
    lamp.write_text(ies(c, gamma, candela))
    source = {"kind": "photometric", "file": str(lamp), "position": [0, 0, -1.5]}
    scene = make_scene(
        {
            "version": 2,
            "source": source,
            "lens.control_points": [40, 40],
            "lens.height_range": None,
            "screen.half_width": [1.5, 1.5],
        }
    )
    wanted = np.pad(np.ones((16, 16)), 8)
    heights = transport_start(scene, wanted)
    assert validate(scene, wanted, {"lens.back": heights}, 200_000).relative_l2_corrected < 0.2


def test_a_base_with_total_reflection_is_replaced_by_a_plate(make_scene, corner):
    # At an index of 3 no light leaves a face steeper than 19.5°: here that is all but the middle,
    # where none arrives from a point so far aside.
    scene = make_scene(
        {
            "source": SOURCES["aside"] | {"position": [3.0, 0.0, -4.0]},
            "lens.refractive_index": 3.0,
            "lens.base": {"shape": "sphere", "height": 1.0, "radius": 1.45, "form": "concave"},
            "lens.height_range": None,
            "lens.control_points": [24, 24],
        }
    )
    heights = transport_start(scene, corner)
    assert validate(scene, corner, {"lens.back": heights}, 200_000).relative_l2 < 0.5


def test_a_mirror_that_leans_sends_light_to_its_places(corner):
    scene = Scene.from_data(
        {
            "version": 2,
            "mirror": {"half_width": [15.0, 15.0], "control_points": [48, 48]},
            "source": SOURCES["collimated"],
            "screen": {
                "z": -60.0,
                "center": [60.0, 0.0],
                "tilt": [0.0, -45.0],
                "half_width": [20.0, 20.0],
                "pixels": [32, 32],
            },
            "target": {"builtin": "tophat"},
        }
    )
    heights = transport_start(scene, corner)
    found = validate(scene, corner, {"mirror.face": heights}, 200_000)
    assert found.relative_l2 < 0.13
