"""Trains of several elements: what is refused before a run."""

import copy

import pytest

from workbench.errors import Refused
from workbench.scene import Scene

TRAIN = {
    "version": 3,
    "unit": "cm",
    "source": {"kind": "point", "position": [0, 0, -10]},
    "elements": [
        {
            "kind": "lens",
            "name": "dome",
            "position": [0, 0, -9],
            "half_width": [2, 2],
            "material": "PMMA",
            "thickness": 1,
            "faces": [{"shape": "plane"}, {"shape": "plane"}],
        },
        {
            "kind": "lens",
            "name": "lens",
            "half_width": [5, 5],
            "material": "PMMA",
            "thickness": 2,
            "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": [8, 8]}],
        },
        {
            "kind": "lens",
            "name": "cover",
            "position": [0, 0, 20],
            "half_width": [9, 9],
            "material": "PMMA",
            "thickness": 1,
            "faces": [{"shape": "plane"}, {"shape": "plane"}],
        },
    ],
    "images": [
        {
            "receiver": {
                "kind": "plane",
                "position": [0, 0, 60],
                "half_width": [9, 9],
                "pixels": [8, 8],
            },
            "target": {"builtin": "tophat"},
        }
    ],
}

FOLD = {
    "kind": "mirror",
    "name": "fold",
    "position": [0, 0, -4],
    "tilt": [45, 0, 0],
    "half_width": [3, 4],
    "face": {"shape": "plane"},
}
FAR = {"kind": "far_field", "half_angle": [9, 9], "pixels": [8, 8]}


def train(change=lambda data: None):
    data = copy.deepcopy(TRAIN)
    change(data)
    return Scene.from_data(data)


def test_the_designed_element_alone_sees_source_and_receiver_through_the_plates():
    scene = train()
    alone = scene.alone
    assert [element.name for element in alone.elements] == ["lens"]
    shift = 1 - 1 / scene.optic.index  # of a plate of thickness 1
    assert alone.source.place[2] == pytest.approx(-10 + shift)
    assert alone.receiver.z == pytest.approx(60 - shift)
    assert Scene.from_data(scene.to_data()) == scene


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (
            lambda data: data["source"].update(position=[0, 0, -8.5]),
            r"source\.position\[2\]: -8.5 is not before the entrance face",
        ),
        (
            lambda data: data["images"][0]["receiver"].update(position=[0, 0, 20.5]),
            "images: a receiver at z = 20.5 may touch the element cover; more than 21",
        ),
        (
            lambda data: data["elements"][0].update(position=[0, 0, -0.5]),
            r"elements\[1\]\.position\[2\]: 0 reaches into dome; at least 0.5",
        ),
        (lambda data: data["elements"][2].update(name="lens"), "is the name of another element"),
        (
            lambda data: data["elements"].insert(1, FOLD),
            r"elements\[2\]\.position: \[0, 0, 0\] is not where light of fold goes",
        ),
        (
            lambda data: (
                data["elements"].__setitem__(2, FOLD | {"position": [0, 0, 20]}),
                data["images"][0].update(receiver=FAR),
            ),
            "light leaves fold at 90 degrees from the z axis, too far for a far field",
        ),
        (
            lambda data: data["elements"][1].update(tilt=[120, 0, 0]),
            r"elements\[1\]\.tilt: light comes to the back of lens, at 120 degrees",
        ),
    ],
)
def test_what_cannot_be_lit_is_refused_where_it_stands(change, sentence):
    with pytest.raises(Refused, match=sentence):
        train(change)


def test_a_lamp_before_a_train_knows_the_unit_of_the_scene():
    lamp = {"kind": "photometric", "file": "lamp.ies", "position": [0, 0, -10]}
    assert train(lambda data: data.update(source=lamp)).source.unit == "cm"
