"""Design runs on a graphics card."""

from itertools import islice

import pytest
import torch

from resources import path
from workbench.design.run import run
from workbench.files.session import open_design

pytestmark = pytest.mark.skipif(not torch.cuda.is_available(), reason="there is no GPU here")

# Any first lens, image and descent is in one of them. Many points at once, as in *flame-grid*, take
# more memory than most cards have.
EXAMPLES = [
    "tophat",
    "letter",
    "flame-point",
    "sun-plate",
    "phone-torch",
    "led-rectangle",
    "led-dome",
    "wall-washer",
    "street-light",
    "beam-shaper",
    "measured-led",
    "mirror-photo",
    "two-distances",
    "wide-angle",
    "flame-stages",
]


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_run_computes_on_the_card_that_its_scene_asks_for(name):
    task = open_design(path("examples", f"{name}.json"))
    on_card = task.scene.run.model_copy(update={"device": "cuda"})
    scene = task.scene.model_copy(update={"run": on_card})
    snapshots = list(islice(run(scene, task.target), 6))
    assert min(s.merit for s in snapshots[1:]) < snapshots[0].merit
    assert any("on cuda" in note for note in snapshots[-1].notes)
