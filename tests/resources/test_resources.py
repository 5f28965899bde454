import json
import re
import xml.etree.ElementTree as ET
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import resources
from resources import make_resources
from workbench.scene import Scene
from workbench.targets import load_target

ICONS = ["start", "continue", "pause", "stop", "open", "save", "new", "undo", "redo", "fit-view"]
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("resources")
    make_resources.make(folder)
    return folder


def test_the_script_makes_every_file_that_ships_and_no_other(made):
    def generated(folder):
        found = {*folder.glob("targets/*"), *folder.glob("examples/*"), *folder.glob("*.json")}
        return {file.relative_to(folder) for file in found}

    assert generated(made) == generated(resources.path())
    assert {p.stem for p in resources.path("examples").iterdir()} == set(resources.EXAMPLES)


@pytest.mark.parametrize("size", make_resources.SIZES)
@pytest.mark.parametrize("shape", make_resources.SHAPES)
def test_target_images_are_as_the_script_makes_them(made, shape, size):
    name = f"{shape}-{size}.png"
    with (
        Image.open(made / "targets" / name) as new,
        resources.path("targets", name).open("rb") as file,
    ):
        shipped = Image.open(BytesIO(file.read()))
        assert (shipped.mode, shipped.size) == ("L", (size, size))
        np.testing.assert_allclose(np.asarray(shipped, float), np.asarray(new, float), atol=1)


@pytest.mark.parametrize("name", [f"examples/{n}.json" for n in resources.EXAMPLES])
def test_examples_are_as_the_script_makes_them(made, name):
    assert resources.path(name).read_text("utf-8") == (made / name).read_text("utf-8")


def test_schema_is_that_of_the_scene(made):
    shipped = json.loads(resources.path("scene.schema.json").read_text("utf-8"))
    assert shipped == json.loads((made / "scene.schema.json").read_text("utf-8"))
    assert set(shipped["properties"]) == set(Scene.model_fields)
    assert shipped["required"] == ["lens", "source", "screen", "target"]


@pytest.mark.parametrize("name", resources.EXAMPLES)
def test_examples_find_their_targets(name):
    file = resources.path("examples", f"{name}.json")
    scene = Scene.from_json(file.read_bytes())
    target = load_target(scene, file.parent)
    # The image fits the screen pixel by pixel: nothing is resampled.
    with Image.open(file.parent / scene.target.image) as image:
        np.testing.assert_allclose(255 * target, np.asarray(image), atol=1e-9)


def test_a_path_leads_to_a_shipped_file():
    assert isinstance(resources.path("icons"), Path)
    assert resources.path("icons", "start.svg").is_file()


@pytest.mark.parametrize("name", ICONS)
def test_icons_are_drawn_in_one_colour_that_can_be_replaced(name):
    text = resources.path("icons", f"{name}.svg").read_text("utf-8")
    root = ET.fromstring(text)
    assert root.tag == f"{SVG}svg"
    assert root.get("viewBox") == "0 0 24 24"
    assert set(re.findall(r"#[0-9a-fA-F]+", text)) == {"#666"}


def test_every_icon_is_known():
    assert {p.stem for p in resources.path("icons").iterdir()} == {*ICONS, "workbench"}
