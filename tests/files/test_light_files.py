"""Sessions keep what files of light hold, as they keep the picture of a target."""

import json
import shutil

import pytest

from tests.lamps import crooked_lamp, downlight
from tests.scenes import changed
from workbench.design.task import with_task
from workbench.files.session import open_design, read_session, write_session
from workbench.measured.lamps import intensity_of
from workbench.scene import Scene


@pytest.fixture
def scene_file(tmp_path):
    source = crooked_lamp(tmp_path) | {"file": "crooked.ies"}
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(changed({"source": source, "version": 2})))
    return path


def test_a_session_needs_its_lamp_no_more(scene_file, tmp_path):
    session = open_design(scene_file)
    write_session(session, tmp_path / "lamp.freeform")
    lumens = intensity_of(session.scene.source).lumens
    (tmp_path / "crooked.ies").unlink()
    there = tmp_path / "there"
    there.mkdir()
    shutil.move(tmp_path / "lamp.freeform", there)

    opened = read_session(there / "lamp.freeform")

    assert intensity_of(opened.scene.source).lumens == lumens
    again = with_task(opened, Scene.from_data(opened.scene.to_data()), there)
    assert intensity_of(again.scene.source).lumens == lumens


def test_lamps_of_stages_are_kept_as_well(scene_file, tmp_path):
    other = downlight(tmp_path) | {"position": [0.0, 0.0, -3.0]}
    data = json.loads(scene_file.read_text())
    data["run"]["stages"] = [{"iterations": 2, "source": other}]
    scene_file.write_text(json.dumps(data))
    write_session(open_design(scene_file), tmp_path / "lamp.freeform")
    (tmp_path / "downlight.ies").unlink()

    scene = read_session(tmp_path / "lamp.freeform").scene

    assert intensity_of(scene.run.stages[0].source).lumens > 0
    assert set(scene.light_files) == {str(tmp_path / n) for n in ("crooked.ies", "downlight.ies")}
