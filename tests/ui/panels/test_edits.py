"""Edits of a scene that has lost the field they are for."""

import pytest

from ui.panels.edits import Edit, edited_scene
from workbench.errors import Refused


@pytest.mark.parametrize(
    "path",
    ["source.position[2]", "elements[0].faces[1].control_points[1]", "run.stages[3].iterations"],
)
def test_an_edit_of_a_field_that_has_gone_is_refused(make_scene, path):
    scene = make_scene({"lens.control_points": "auto"})  # of parallel light, and without stages
    with pytest.raises(Refused, match="no longer has this field") as refused:
        edited_scene(scene, [Edit(path, "change", {path: 7})])
    assert refused.value.path == path
