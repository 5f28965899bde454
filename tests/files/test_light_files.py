"""Sessions keep what files of light hold, as they keep the picture of a target."""

import json
import shutil
from dataclasses import replace

import pytest

from tests.lamps import crooked_lamp, downlight
from tests.scenes import changed
from workbench.design import picture
from workbench.design.light_files import why_light_is_not_kept
from workbench.design.task import with_task
from workbench.errors import Refused
from workbench.files.references import files_of
from workbench.files.scene import write_scene
from workbench.files.session import open_design, read_session, write_session
from workbench.measured.lamps import intensity_of
from workbench.scene import Scene


@pytest.fixture
def scene_file(tmp_path):
    source = crooked_lamp(tmp_path) | {"file": "crooked.ies"}
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(changed({"source": source, "version": 2})))
    return path


def test_a_scene_file_names_its_lamp_beside_it(scene_file, tmp_path):
    session = open_design(scene_file)

    assert session.scene.source.file == str(tmp_path / "crooked.ies")
    write_scene(session.scene, tmp_path / "again.json")
    assert json.loads((tmp_path / "again.json").read_text())["source"]["file"] == "crooked.ies"
    assert ("source.file", tmp_path / "crooked.ies") in files_of(scene_file)


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


def test_the_lamp_of_a_session_stays_when_its_file_changes(scene_file, tmp_path):
    session = open_design(scene_file)
    lumens = intensity_of(session.scene.source).lumens
    write_session(session, tmp_path / "lamp.freeform")
    (tmp_path / "crooked.ies").write_text((tmp_path / downlight(tmp_path)["file"]).read_text())

    assert intensity_of(read_session(tmp_path / "lamp.freeform").scene.source).lumens == lumens


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


def test_a_missing_lamp_is_refused_in_a_sentence(scene_file, tmp_path):
    (tmp_path / "crooked.ies").unlink()

    with pytest.raises(Refused, match=r"^source\.file: '.*crooked\.ies' does not exist"):
        open_design(scene_file)


def test_a_damaged_lamp_of_a_stage_is_refused_with_the_stage(scene_file, tmp_path):
    data = json.loads(scene_file.read_text())
    data["run"]["stages"] = [{"iterations": 2, "source": downlight(tmp_path)}]
    (tmp_path / "downlight.ies").write_text("TILT=NONE")
    scene_file.write_text(json.dumps(data))

    with pytest.raises(Refused, match=r"^run\.stages\[0\]\.source\.file: .* is cut off"):
        open_design(scene_file)


def test_a_large_file_is_needed_wherever_the_design_is(scene_file, tmp_path, monkeypatch):
    monkeypatch.setattr(picture, "LARGEST_PICTURE", 100)

    session = open_design(scene_file)

    assert why_light_is_not_kept(session.scene).startswith("The design does not keep ")
    write_session(session, tmp_path / "lamp.freeform")
    assert intensity_of(read_session(tmp_path / "lamp.freeform").scene.source).lumens > 0
    (tmp_path / "crooked.ies").unlink()
    with pytest.raises(Refused, match=r"^source\.file: .* does not exist"):
        intensity_of(read_session(tmp_path / "lamp.freeform").scene.source)


def test_an_edit_of_the_file_takes_the_other_lamp(scene_file, tmp_path):
    session = open_design(scene_file)
    other = session.scene.source.model_copy(update={"file": downlight(tmp_path)["file"]})

    after = with_task(session, session.scene.altered(source=other), tmp_path)

    assert list(after.scene.light_files) == [str(tmp_path / "downlight.ies")]
    assert after.scene.light_files[str(tmp_path / "downlight.ies")] is not None
    assert replace(after, scene=session.scene).scene.light_files == session.scene.light_files
