"""What a run says of itself in its log: sentences that can be said in another language."""

from itertools import islice

import numpy as np
import pytest

from workbench.design.run import run
from workbench.said import Said

POINT = {"kind": "point", "position": [0, 0, -3], "rays": 4096}
AREA = {"kind": "area", "center": [0, 0, -3], "half_width": [0.1, 0.1]}
SUN = {"kind": "collimated", "rays": [64, 64], "angular_diameter": 1.0}
TWO_FACES = {"shape": "freeform", "control_points": [8, 8], "degree": [3, 3]}


@pytest.mark.parametrize(
    ("changes", "beginning"),
    [
        ({}, "collimated light: "),
        ({"run.method": "paper"}, "fused kernels, "),
        ({"source": POINT}, "samples on the exit face, "),
        ({"source": AREA}, "beams run between points "),
        ({"source": SUN}, "its light is blurred over "),
        ({"lens.entrance": TWO_FACES}, "first lens: "),
        ({"lens.control_points": "auto"}, "control points: "),
        ({"lens.height_range": None}, "heights within "),
    ],
)
def test_notes_have_their_values_apart(make_scene, changes, beginning):
    scene = make_scene({"lens.control_points": [8, 8], "run.iterations": 1, **changes})
    shots = list(islice(run(scene, np.ones(scene.receiver.pixels[::-1])), 2))
    notes = {note for shot in shots for note in shot.notes}
    assert any(note.startswith(beginning) for note in notes), notes
    assert [note for note in notes if not isinstance(note, Said)] == []
