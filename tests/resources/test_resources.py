import json
import math
import re
import xml.etree.ElementTree as ET
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import resources
from resources import drawings, make_resources
from workbench.analysis.derivatives import irradiance_derivative
from workbench.design.run import run
from workbench.files.session import open_design
from workbench.measured.rays import read_rays
from workbench.scene import Scene
from workbench.scene.viewing import as_viewed, viewed_from
from workbench.targets import load_target

ICONS = ["start", "continue", "pause", "stop", "open", "save", "new", "undo", "redo", "fit-view"]
ICONS += ["follow", "turn", "sculpt", "lock", "move-source", "region", "cut-line", "logarithmic"]
IN_STYLE_SHEETS = ["dock-close", "dock-float"]  # which cannot replace their colour
examples = pytest.mark.parametrize("example", resources.EXAMPLES, ids=lambda each: each.name)
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("resources")
    make_resources.make(folder)
    return folder


def test_the_script_makes_every_file_that_ships_and_no_other(made):
    def generated(folder):
        found = {
            file
            for pattern in ("targets/*", "examples/*", "lights/*", "manual/fields.md", "*.json")
            for file in folder.glob(pattern)
        }
        return {file.relative_to(folder) for file in found}

    assert generated(made) == generated(resources.path())
    assert {*resources.path("examples").iterdir()} == {each.file for each in resources.EXAMPLES}


def test_the_page_of_fields_is_up_to_date(made):
    page = (made / "manual" / "fields.md").read_text("utf-8")
    assert page == resources.path("manual", "fields.md").read_text("utf-8")
    for field in Scene.fields():
        assert not field.tip or f"| `{field.name}` | {field.title}" in page


@pytest.mark.parametrize("size", make_resources.SIZES)
@pytest.mark.parametrize("shape", make_resources.SHAPES)
def test_target_images_are_as_the_script_makes_them(made, shape, size):
    _same_images(made, f"{shape}-{size}.png", size)


@pytest.mark.parametrize("name", make_resources.DRAWINGS)
def test_drawings_are_as_the_script_makes_them(made, name):
    size = make_resources.DRAWING_SIZE
    _same_images(made, f"{name}-{size}.png", size)


def test_the_photograph_has_every_grey():
    with Image.open(resources.path("targets", "photo-256.png")) as image:
        used = np.bincount(np.asarray(image).ravel(), minlength=256)
    assert (used > 0).all()


@pytest.mark.parametrize("size", make_resources.RECTANGLES)
def test_even_rectangles_are_as_the_script_makes_them(made, size):
    across, up = size
    name = f"rectangle-{across}x{up}.png"
    for folder in (made, resources.path()):
        with Image.open(folder / "targets" / name) as image:
            lit = np.asarray(image)
        assert lit.shape == (up + 20, across + 20)
        assert (lit[10:-10, 10:-10] == 255).all() and lit.sum() == 255 * up * across


def test_the_rays_of_the_led_are_as_the_script_makes_them(made):
    new, shipped = (
        _rays_of(folder / "lights" / "led.tm25ray") for folder in (made, resources.path())
    )
    np.testing.assert_allclose(shipped.position, new.position, atol=1e-6)
    np.testing.assert_allclose(shipped.direction, new.direction, atol=1e-6)
    np.testing.assert_array_equal(shipped.flux, new.flux)


def test_the_led_shines_as_lambert_says():
    file = resources.path("lights", "led.tm25ray")
    assert file.stat().st_size < 300_000
    rays = _rays_of(file)
    assert rays.total == pytest.approx(1, abs=1e-4)
    assert np.abs(rays.position[:, :2]).max() <= 0.5 and not rays.position[:, 2].any()
    for degrees in (15, 30, 45, 60, 75):  # the light within an angle is its squared sine
        inside = rays.flux[rays.direction[:, 2] > math.cos(math.radians(degrees))].sum()
        assert inside == pytest.approx(math.sin(math.radians(degrees)) ** 2, abs=1e-3)


def _rays_of(path):
    with path.open("rb") as file:
        return read_rays(path, file)


def _same_images(made, name, size):
    with (
        Image.open(made / "targets" / name) as new,
        resources.path("targets", name).open("rb") as file,
    ):
        shipped = Image.open(BytesIO(file.read()))
        assert (shipped.mode, shipped.size) == ("L", (size, size))
        np.testing.assert_allclose(np.asarray(shipped, float), np.asarray(new, float), atol=1)


@examples
def test_examples_are_as_the_script_makes_them(made, example):
    new = made / "examples" / example.file.name
    assert example.file.read_text("utf-8") == new.read_text("utf-8")


def test_schema_is_that_of_the_scene(made):
    shipped = json.loads(resources.path("scene.schema.json").read_text("utf-8"))
    assert shipped == json.loads((made / "scene.schema.json").read_text("utf-8"))
    assert set(shipped["properties"]) == set(Scene.model_fields)
    assert shipped["required"] == ["source", "target"]
    either = (("lens", "mirror"), ("screen", "far_field"))
    assert shipped["allOf"] == [
        {"oneOf": [{"required": [name]} for name in pair]} for pair in either
    ]


@examples
def test_examples_find_their_targets(example):
    scene = Scene.from_json(example.file.read_bytes())
    target = load_target(scene, example.file.parent)
    # Each pixel of the screen is one of the image, or as many whole ones along both axes.
    with Image.open(example.file.parent / scene.target.image) as image:
        pixels = np.asarray(image, float)
    (rows, columns), whole = target.shape, pixels.shape[0] // target.shape[0]
    drawn = pixels.reshape(rows, whole, columns, whole).mean((1, 3))
    np.testing.assert_allclose(255 * as_viewed(scene, target), drawn, atol=1e-9)


@pytest.mark.parametrize(
    "name", ["sun-plate", "phone-torch", "led-rectangle", "wall-washer", "street-light"]
)
def test_pictures_on_walls_and_streets_read_right_from_the_side_of_the_light(name):
    assert viewed_from(Scene.from_json(_named(name).file.read_bytes())) == "front"


def test_examples_say_what_to_look_for():
    assert len({each.name for each in resources.EXAMPLES}) == len(resources.EXAMPLES)
    titles = {(each.group, each.title) for each in resources.EXAMPLES}
    assert len(titles) == len(resources.EXAMPLES)
    for each in resources.EXAMPLES:
        assert each.look.endswith(".") and 30 < len(each.look) <= 100, each.name


@pytest.mark.parametrize("magnification", [1, 3, 5])
def test_bases_of_the_magnifications_just_fill_their_screens(magnification):
    """A ray at the rim of the undesigned lens meets the rim of the screen, along each axis."""
    scene = Scene.from_json(_named(f"flame-x{magnification}").file.read_bytes())
    lens, screen = scene.optic, scene.receiver
    r = lens.half_width[0]
    z, near = lens.base.height_at(np.array([r, r - 1e-6]), 0.0)
    incident = math.atan((z - near) / 1e-6)
    deflection = math.asin(lens.index * math.sin(incident)) - incident  # away from the axis
    met = r + (screen.z - z) * math.tan(deflection)
    assert met == pytest.approx(screen.half_width[0], rel=0.03)


@pytest.mark.parametrize(
    ("name", "part"),
    # An extended source blurs whatever the lens does.
    [("flame-point", 0.6), ("flame-grid", 0.9), ("flame-x5", 0.6), ("ball-x3", 0.6)],
)
def test_examples_improve(name, part):
    """With fewer rays, pixels and control points than they have, to be done soon."""
    example = _named(name)
    data = json.loads(example.file.read_bytes())
    few = {"collimated": [128, 128], "point": 20_000, "grid": 30}
    data["source"]["rays"] = few[data["source"]["kind"]]
    data["screen"]["pixels"] = [48, 48]
    data["lens"]["control_points"] = [16, 16]
    data["run"]["iterations"] = 20
    scene = Scene.from_data(data)
    losses = [
        snapshot.state.loss for snapshot in run(scene, load_target(scene, example.file.parent))
    ]
    assert min(losses) < part * losses[0]


@pytest.mark.parametrize("name", ["wall-washer", "street-light"])
def test_walls_and_streets_are_lit_better(name):
    """Opened as a person does it, with the lamp's file; with fewer pixels and control points."""
    example = _named(name)
    whole = open_design(example.file).scene
    optic = whole.optic.model_copy(update={"control_points": (16, 16)})
    receiver = whole.receiver.model_copy(update={"pixels": (48, 48)})
    short = whole.run.model_copy(update={"iterations": 10})
    scene = whole.with_optic(optic).with_receiver(receiver).model_copy(update={"run": short})
    states = [s.state for s in run(scene, load_target(scene, example.file.parent))]
    assert min(state.loss for state in states) < 0.9 * states[0].loss
    assert 0.3 < states[-1].account.efficiency < 0.6  # the cone of the lamp is round
    assert states[-1].account.lost["off_screen"] < 0.05


def test_the_lamp_is_as_the_script_makes_it(made):
    new, shipped = (at / "lights" / "led.ies" for at in (made, resources.path()))
    assert shipped.read_bytes() == new.read_bytes()


def test_the_street_is_drawn_so_that_the_road_is_even():
    light = drawings.street(256)
    angles = np.radians(40) * ((np.arange(256) + 0.5) / 128 - 1)
    onto = (np.cos(angles) * np.cos(angles[:, None])) ** 3  # of the angle from the vertical
    lit = light > 0
    assert 0.2 < lit.mean() < 0.5 and np.ptp((light * onto)[lit]) < 1e-12
    assert light.max() == 1 and np.array_equal(light, light[::-1, ::-1])


def test_the_staged_example_goes_from_one_point_to_many():
    scene = Scene.from_json(_named("flame-stages").file.read_bytes())
    stages = [(part.source.kind, part.run.iterations) for part in scene.stage_scenes()]
    assert stages == [("point", 200), ("grid", 100)]


def _named(name):
    return next(each for each in resources.EXAMPLES if each.name == name)


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
    assert {p.stem for p in resources.path("icons").iterdir()} == {
        *ICONS,
        *IN_STYLE_SHEETS,
        "workbench",
    }


@pytest.mark.parametrize(
    ("name", "sum_below", "reaches_border"),
    [
        ("derivative-degree3-filter3", 1e-14, False),
        ("derivative-degree3-filter11", 1e-14, False),
        ("derivative-degree5-filter3", 1e-5, True),
    ],
)
def test_derivative_examples_are_the_cases_of_the_paper(name, sum_below, reaches_border):
    scene = Scene.from_json(_named(name).file.read_bytes())
    flat = np.full(scene.optic.net_shape, scene.optic.base.height)
    found = irradiance_derivative(scene, {"exit": flat}, (4, 4))
    inside = np.count_nonzero(found.map[1:-1, 1:-1])
    assert (np.count_nonzero(found.map) > inside) == reaches_border
    assert abs(found.sum) < sum_below * found.flux
    assert 0.4 < inside / found.map.size < 0.7  # large enough to be seen
