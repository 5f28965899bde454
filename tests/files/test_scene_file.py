import json
import os

import pytest

from workbench.errors import Refused
from workbench.files.scene import read_scene, write_scene


def with_image(scene_data, image):
    return json.dumps({**scene_data, "target": {"image": image}})


def test_a_relative_image_starts_beside_the_scene(tmp_path, scene_data):
    path = tmp_path / "scene.json"
    path.write_text(with_image(scene_data, "images/../flame.png"))
    assert read_scene(path).target.image == str(tmp_path / "flame.png")


@pytest.mark.parametrize(
    "image, stored",
    [
        ("work/flame.png", "flame.png"),
        ("work/images/flämmchen 🔥.png", "images/flämmchen 🔥.png"),
        ("workshop/flame.png", None),
        ("flame.png", None),
    ],
)
def test_an_image_below_the_folder_is_stored_relative(tmp_path, make_scene, image, stored):
    absolute = str(tmp_path / image)
    (tmp_path / "work").mkdir()
    path = tmp_path / "work" / "scene.json"
    write_scene(make_scene({"target": {"image": absolute}}), path)
    written = json.loads(path.read_text(encoding="utf-8"))["images"][0]["target"]["image"]
    assert written == (stored or absolute)
    assert read_scene(path).target.image == absolute


def test_a_missing_file_a_folder_and_a_pipe_are_refused(tmp_path):
    with pytest.raises(Refused, match=r"missing\.json: does not exist"):
        read_scene(tmp_path / "missing.json")
    with pytest.raises(Refused, match="is a folder"):
        read_scene(tmp_path)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(Refused, match="device or pipe"):
        read_scene(tmp_path / "pipe")


@pytest.fixture
def linked(tmp_path, scene_data):
    """A scene in a folder of its own, with its image and lamp, and a link to it elsewhere."""
    real = tmp_path / "real"
    (real / "files").mkdir(parents=True)
    for name in ("F.png", "lamp.ies"):
        (real / "files" / name).touch()
    scene_data["version"] = 2
    scene_data["target"] = {"image": "files/F.png"}
    lamp = {"kind": "photometric", "file": "files/lamp.ies", "position": [0, 0, -1]}
    scene_data["source"] = lamp
    (real / "scene.json").write_text(json.dumps(scene_data))
    try:
        (tmp_path / "link.json").symlink_to(real / "scene.json")
    except OSError:
        pytest.skip("no links can be made here")
    return tmp_path


def test_files_are_found_beside_the_scene_that_a_link_means(linked):
    files = dict(read_scene(linked / "link.json").files())
    assert sorted(files.values()) == [str(linked / "real/files" / n) for n in ("F.png", "lamp.ies")]


def test_backslashes_separate_folders_too(linked, scene_data):
    scene_data["target"] = {"image": "files\\F.png"}
    path = linked / "real/windows.json"
    path.write_text(json.dumps(scene_data))
    assert read_scene(path).target.image == str(linked / "real/files/F.png")
