"""A face for a task that has changed a little sends light where the former one sent it."""

import numpy as np
import pytest

from workbench.design.transport import refitted, transport_start
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.face_light import FaceLight
from workbench.design.transport.start import cells_for
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene
from workbench.targets import load_target

SOURCES = {
    "collimated": {"kind": "collimated"},
    "point": {"kind": "point", "position": [0.1, 0.0, -5.0]},
    "sun": {"kind": "collimated", "angular_diameter": 0.533},
}
EDITS = {
    "index": {"lens": {"refractive_index": 1.55}},
    "distance": {"screen": {"z": 5.5}},
    "size of the image": {"screen": {"half_width": [1.1, 1.1]}},
    "place of the image": {"screen": {"center": [0.2, -0.1]}},
    "pixels": {"screen": {"pixels": [48, 24]}},
}


def scene_of(light="collimated", **changes):
    data = {
        "version": 2,
        "unit": "cm",
        "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [24, 24]},
        "source": SOURCES[light],
        "screen": {"z": 5, "half_width": [1, 1], "pixels": [32, 32]},
        "target": {"builtin": "flame"},
    }
    return Scene.from_data(data | {part: data[part] | new for part, new in changes.items()})


def designed(scene, folder):
    heights = transport_start(scene, load_target(scene, folder))
    assert heights is not None
    return heights


def lands(scene, heights):
    """Where light lands, in parts of the receiver."""
    net = ControlNet.of(scene.optic)
    cells = cells_for(net)
    places = FaceLight(scene, net, SlopeFit(net, cells), cells).goes_to(heights)
    column, row = scene.receiver.to_pixels(*places)
    return np.stack([column / scene.receiver.pixels[0], row / scene.receiver.pixels[1]])


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("edit", EDITS)
def test_light_goes_to_the_same_parts_of_the_image_after_an_edit(source, edit, tmp_path):
    before, scene = scene_of(source), scene_of(source, **EDITS[edit])
    heights = designed(before, tmp_path)
    wanted = lands(before, heights)
    off = lands(scene, refitted(before, heights, scene)) - wanted
    stale = lands(scene, heights) - wanted
    assert np.sqrt(np.square(off).mean()) < 1e-3
    assert edit == "pixels" or np.sqrt(np.square(stale).mean()) > 1e-2


def test_light_of_a_mirror_goes_where_it_went(tmp_path):
    def mirror(z):
        data = scene_of().to_data()
        optic = {"half_width": [1, 1], "control_points": [24, 24]}
        del data["lens"]
        screen = data["screen"] | {"z": z, "center": [3.0, 0.0]}
        return Scene.from_data(data | {"mirror": optic, "screen": screen})

    before, scene = mirror(-5.0), mirror(-5.3)
    heights = designed(before, tmp_path)
    off = lands(scene, refitted(before, heights, scene)) - lands(before, heights)
    assert np.sqrt(np.square(off).mean()) < 2e-3
