import json
import os
from pathlib import Path

import pytest

from workbench.errors import Refused
from workbench.files.scene import LARGEST_TEXT, read_scene, write_scene


def with_image(scene_data, image):
    return json.dumps({**scene_data, "target": {"image": image}})


def test_round_trip(tmp_path, make_scene):
    scene = make_scene({"lens.refractive_index": 1.4910000000000001, "screen.z": 1 / 3 + 1})
    write_scene(scene, tmp_path / "scene.json")
    assert read_scene(tmp_path / "scene.json") == scene


def test_a_byte_order_mark_does_no_harm(tmp_path, make_scene):
    path = tmp_path / "scene.json"
    path.write_text(make_scene().to_json(), encoding="utf-8-sig")
    assert read_scene(path) == make_scene()


def test_a_field_that_is_given_twice_is_refused(tmp_path, make_scene):
    path = tmp_path / "scene.json"
    text = make_scene().to_json()
    path.write_text(text.replace('"z": 5.0', '"z": 6.0, "z": 5.0'))
    with pytest.raises(Refused, match=r"^screen\.z: is given twice"):
        read_scene(path)


def test_a_relative_image_starts_beside_the_scene(tmp_path, scene_data):
    path = tmp_path / "scene.json"
    path.write_text(with_image(scene_data, "images/../flame.png"))
    assert read_scene(path).target.image == str(tmp_path / "flame.png")


def test_a_relative_path_of_the_scene_starts_in_the_current_folder(
    tmp_path, scene_data, monkeypatch
):
    (tmp_path / "scene.json").write_text(with_image(scene_data, "flame.png"))
    monkeypatch.chdir(tmp_path)
    assert read_scene(Path("scene.json")).target.image == str(tmp_path / "flame.png")


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
    written = json.loads(path.read_text(encoding="utf-8"))["target"]["image"]
    assert written == (stored or absolute)
    assert read_scene(path).target.image == absolute


def test_a_name_that_is_no_text_is_refused(tmp_path, make_scene):
    scene = make_scene({"target": {"image": "flame.png"}})
    image = os.fsdecode(b"/elsewhere/fl\xff.png")
    target = scene.target.model_copy(update={"image": image})
    with pytest.raises(Refused, match=r"target\.image") as caught:
        write_scene(scene.model_copy(update={"target": target}), tmp_path / "scene.json")
    str(caught.value).encode()
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize(
    "content, reason",
    [
        (b"", "not valid JSON"),
        (b"{", "not valid JSON"),
        (b"[1]", "not an object"),
        (b"\x89PNG\r\n\x1a\n", "neither a session nor a scene in UTF-8 text"),
        ("{\u201eunit\u201c: 1}".encode("utf-16"), "UTF-8"),
        (b"[" * 100_000, "not valid JSON"),
        (b" " * (LARGEST_TEXT + 1), f"more than {LARGEST_TEXT} bytes"),
    ],
)
def test_file_without_a_scene_is_refused_by_its_name(tmp_path, content, reason):
    path = tmp_path / "scene.json"
    path.write_bytes(content)
    with pytest.raises(Refused, match=reason) as caught:
        read_scene(path)
    assert caught.value.path == str(path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "part, field, value, path",
    [
        ("lens", "control_points", [3, 3], "lens.control_points[0]"),
        ("lens", "thickness", 1, "lens.thickness"),
        ("screen", "z", "far", "screen.z"),
        ("run", "iterations", -1, "run.iterations"),
    ],
)
def test_an_impossible_scene_is_refused_by_its_field(
    tmp_path, scene_data, part, field, value, path
):
    scene_data[part][field] = value
    (tmp_path / "scene.json").write_text(json.dumps(scene_data))
    with pytest.raises(Refused) as caught:
        read_scene(tmp_path / "scene.json")
    assert caught.value.path == path


def test_a_missing_file_a_folder_and_a_pipe_are_refused(tmp_path):
    with pytest.raises(Refused, match=r"missing\.json: does not exist"):
        read_scene(tmp_path / "missing.json")
    with pytest.raises(Refused, match="is a folder"):
        read_scene(tmp_path)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(Refused, match="device or pipe"):
        read_scene(tmp_path / "pipe")


def test_a_file_that_may_not_be_read_is_refused(tmp_path, monkeypatch, make_scene):
    path = tmp_path / "scene.json"
    write_scene(make_scene(), path)

    def deny(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(type(path), "open", deny)
    with pytest.raises(Refused, match=r"scene.json: cannot be read: Permission denied$"):
        read_scene(path)


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


def test_files_beside_the_link_come_first(linked):
    (linked / "files").mkdir()
    (linked / "files" / "F.png").touch()
    files = dict(read_scene(linked / "link.json").files())
    assert files["target.image"] == str(linked / "files/F.png")
    assert str(linked / "real/files/lamp.ies") in files.values()


def test_a_missing_file_is_named_beside_the_link(linked):
    (linked / "real/files/F.png").unlink()
    assert read_scene(linked / "link.json").image == str(linked / "files/F.png")


def test_backslashes_separate_folders_too(linked, scene_data):
    scene_data["target"] = {"image": "files\\F.png"}
    path = linked / "real/windows.json"
    path.write_text(json.dumps(scene_data))
    assert read_scene(path).image == str(linked / "real/files/F.png")
    (linked / "real" / "files\\F.png").touch()  # a name of its own, where names may have one
    assert read_scene(path).image == str(linked / "real" / "files\\F.png")
