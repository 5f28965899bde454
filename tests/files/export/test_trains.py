"""Trains of several elements as solids, read by OpenCASCADE."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.files.export.conftest import designed
from workbench.errors import Refused
from workbench.files.export.meshes import write_stl
from workbench.files.export.step import write_step
from workbench.files.export.step_train import write_step_train
from workbench.files.export.write import designed_element
from workbench.geometry.frames import Frame
from workbench.scene import ConicFace, Diffuser, Mirror, Scene

LENS = {"kind": "lens", "thickness": 2.0, "material": {"index": 1.5}}
PLANE = {"shape": "plane"}
BOWL = {"shape": "conic", "radius": 20.0, "conic": -1.0}  # sag r² / 40
TURNED = (10.0, -25.0, 40.0)


@pytest.fixture
def train(rng):
    """A dome, the designed lens, two turned paraboloids, a turned mirror, and a diffuser."""
    scene = Scene.from_data(
        {
            "version": 3,
            "source": {"kind": "point", "position": [0, 0, -9]},
            "elements": [
                LENS
                | {"name": "dome", "position": [0, 0, -8], "half_width": [1.2, 1.2]}
                | {"outline": "ellipse", "faces": [PLANE, {"shape": "conic", "radius": -1.5}]},
                LENS
                | {"name": "lens", "half_width": [3, 2]}
                | {"faces": [PLANE, {"shape": "bspline", "control_points": [6, 5]}]},
                LENS
                | {"name": "bowl", "position": [0.5, 0, 8], "half_width": [3, 2], "tilt": TURNED}
                | {"faces": [PLANE, BOWL]},
                LENS
                | {"name": "dish", "position": [0, 1, 14], "half_width": [3, 2], "tilt": TURNED}
                | {"outline": "ellipse", "faces": [BOWL, PLANE]},
            ],
            "images": [
                {
                    "receiver": {"kind": "plane", "position": [0, 0, 40], "half_width": [9, 9]}
                    | {"pixels": [8, 8]},
                    "target": {"builtin": "ball"},
                }
            ],
        }
    )
    face = {"shape": "conic", "radius": -20.0, "conic": -1.0}
    mirror = Mirror.model_validate(
        {"kind": "mirror", "name": "mirror", "position": (0, 0, 24), "half_width": (3, 2)}
        | {"tilt": TURNED, "face": face, "thickness": 0.5}
    )
    # Which is no solid.
    diffuser = Diffuser.model_validate(
        {"kind": "diffuser", "name": "diffuser", "position": (0, 0, 30), "half_width": (3, 2)}
        | {"scatter": {"kind": "lambertian"}}
    )
    scene = scene.model_copy(update={"elements": (*scene.elements, mirror, diffuser)})
    heights = 2.0 + 0.1 * rng.normal(size=scene.optic.net_shape)
    return designed(scene, {"lens.back": heights}, rng, None)


def corners(element, low, high):
    """Corners of a block with the outline of an element, in the scene."""
    r_x, r_y = element.half_width
    own = np.array([[x, y, z] for x in (-r_x, r_x) for y in (-r_y, r_y) for z in (low, high)])
    frame = Frame.at(element.position, element.tilt)
    return own @ frame.rotation.T + frame.position


@pytest.mark.parametrize("writer", [write_step, write_stl])
def test_a_conic_front_of_the_designed_lens_is_refused(train, write, writer):
    front = ConicFace.model_validate(BOWL)
    optic = train.scene.optic.model_copy(update={"faces": (front, train.scene.optic.faces[1])})
    with pytest.raises(Refused, match=r"elements\[1\].faces\[0\]"):
        write(writer, replace(train, scene=train.scene.with_optic(optic)), "lens.step")


def test_each_element_is_a_solid_in_its_place(train, write, read_solid, volume):
    path, deviation = write(write_step_train, train, "train.step")
    assert deviation.size < 1e-7
    dome, lens, bowl, dish, mirror = read_solid(path).solids
    assert all(each.is_valid and each.is_closed for each in (dome, lens, bowl, dish, mirror))
    cap = 2 * math.pi / 3 * (1.5**3 - (1.5**2 - 1.2**2) ** 1.5)
    mean = 3**2 + 2**2  # r² is a third of that on a rectangle, a quarter on an ellipse
    assert dome.volume == pytest.approx(math.pi * 1.2**2 * (2 - 1.5) + cap, rel=1e-7)
    assert lens.volume == pytest.approx(volume(train), rel=1e-6)
    assert bowl.volume == pytest.approx(24 * (2 + mean / 3 / 40), rel=1e-7)
    assert dish.volume == pytest.approx(6 * math.pi * (2 - mean / 4 / 40), rel=1e-7)
    # The face rises towards its vertex; the back is 0.5 behind that.
    assert mirror.volume == pytest.approx(24 * (0.5 + mean / 3 / 40), rel=1e-7)
    assert dome.box == pytest.approx(np.array([[-1.2, -1.2, -8], [1.2, 1.2, -6]]), abs=1e-6)
    elements = train.scene.elements
    for solid, element, low, high in (
        (bowl, elements[2], 0.0, 2 + mean / 40),
        (mirror, elements[4], -mean / 40, 0.5),
    ):
        block = corners(element, low, high)
        assert solid.box == pytest.approx(
            np.array([block.min(axis=0), block.max(axis=0)]), abs=2e-6
        )
    text = path.read_text()
    assert all(f"MANIFOLD_SOLID_BREP('{each.name}'" in text for each in elements[:-1])


def test_designed_elements_are_exported_together_and_by_name(rng, write, read_solid):
    """Two lenses, of which the second is turned; each has its own B-spline face."""
    net = {"shape": "bspline", "control_points": [6, 5]}
    front, back = (LENS | {"faces": [PLANE, net], "half_width": r} for r in ([3, 2], [4, 3]))
    scene = Scene.from_data(
        {
            "version": 3,
            "source": {"kind": "collimated"},
            "elements": [
                front | {"name": "first"},
                back | {"name": "second", "position": [0, 0, 9], "tilt": [20, 0, 0]},
            ],
            "images": [
                {
                    "receiver": {"kind": "plane", "position": [0, 0, 60], "half_width": [9, 9]}
                    | {"pixels": [8, 8]},
                    "target": {"builtin": "ball"},
                }
            ],
        }
    )
    rise = np.outer(np.linspace(0, 0.5, 6), np.ones(5))  # which adds 0.25 in the mean
    design = designed(scene, {"first.back": 2 + rise, "second.back": 11 + 2 * rise}, rng, None)
    path, _ = write(write_step_train, design, "two.train.step")
    first, second = read_solid(path).solids
    assert first.volume == pytest.approx(24 * 2.25, rel=1e-7)
    assert second.volume == pytest.approx(48 * 2.5, rel=1e-7)
    assert second.box[0, 2] < 8 and first.box[0, 2] == pytest.approx(0, abs=1e-6)
    for element, solid in zip(scene.elements, (first, second), strict=True):
        path, _ = write(write_step, design.of(element), f"{element.name}.step")
        assert read_solid(path).volume == pytest.approx(solid.volume, rel=1e-7)
    with pytest.raises(Refused, match="third is no designed element; first, second"):
        designed_element(scene, "third")
