"""Design runs on a graphics card."""

from itertools import islice

import pytest

from resources import path
from tests.graphics_card import EXAMPLES, NEEDED, computed_on
from workbench.design.run import run
from workbench.files.session import open_design

pytestmark = NEEDED


# Many points at once, as in *flame-grid*, take more memory than most cards have.
@pytest.mark.parametrize("name", ["tophat", *EXAMPLES, "flame-stages"])
def test_a_run_computes_on_the_card_that_its_scene_asks_for(name):
    task = open_design(path("examples", f"{name}.json"))
    snapshots = list(islice(run(computed_on("cuda", task.scene), task.target), 6))
    assert min(s.merit for s in snapshots[1:]) < snapshots[0].merit
    assert any("on cuda" in note for note in snapshots[-1].notes)
