import json

import numpy as np
import pytest
from PIL import Image

import resources
from resources import make_resources
from workbench.analysis.derivatives import irradiance_derivative
from workbench.analysis.light_limit import light_limits
from workbench.design.run import run
from workbench.files.session import open_design
from workbench.scene import Scene
from workbench.scene.image import as_viewed
from workbench.scene.paths import with_values
from workbench.targets import load_target

ICONS = ["start", "continue", "pause", "stop", "open", "save", "new", "undo", "redo", "fit-view"]
ICONS += [
    "follow",
    "turn",
    "sculpt",
    "lock",
    "move-source",
    "measure",
    "region",
    "cut-line",
    "logarithmic",
]
examples = pytest.mark.parametrize("example", resources.EXAMPLES, ids=lambda each: each.name)


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


def test_schema_is_that_of_the_scene(made):
    shipped = json.loads(resources.path("scene.schema.json").read_text("utf-8"))
    assert shipped == json.loads((made / "scene.schema.json").read_text("utf-8"))
    assert set(shipped["properties"]) == set(Scene.model_fields)
    assert shipped["required"] == ["source", "elements", "images"]


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
    ("name", "part"),
    # An extended source blurs whatever the lens does.
    [("flame-point", 0.6), ("flame-grid", 0.9), ("flame-x5", 0.6), ("ball-x3", 0.6)],
)
def test_examples_improve(name, part):
    """With fewer rays, pixels and control points than they have, to be done soon."""
    example = _named(name)
    scene = Scene.from_json(example.file.read_bytes())
    few = {"collimated": [128, 128], "point": 20_000, "grid": 30}
    changes = {
        "source.rays": few[scene.source.kind],
        "images[0].receiver.pixels": [48, 48],
        "lens.back.control_points": [16, 16],
        "run.iterations": 10,
    }
    if scene.source.kind == "grid":
        changes["source.points"] = [9, 9]
    scene = with_values(scene, changes)
    states = [s.state for s in run(scene, load_target(scene, example.file.parent))]
    losses = [state.loss for state in states]
    assert min(losses) < part * losses[0]
    _check_light(scene, states)


@pytest.mark.parametrize("name", ["wall-washer", "street-light"])
def test_walls_and_streets_are_lit_better(name):
    """Opened as a person does it, with the lamp's file; with fewer pixels and control points."""
    example = _named(name)
    whole = open_design(example.file).scene
    optic = whole.optic.shaped(control_points=(16, 16))
    receiver = whole.receiver.model_copy(update={"pixels": (48, 48)})
    short = whole.run.model_copy(update={"iterations": 10})
    scene = whole.with_optic(optic).with_receiver(receiver).model_copy(update={"run": short})
    states = [s.state for s in run(scene, load_target(scene, example.file.parent))]
    assert min(state.loss for state in states) < 0.9 * states[0].loss
    assert 0.3 < states[-1].account.efficiency < 0.6  # the cone of the lamp is round
    assert states[-1].account.lost["off_screen"] < 0.05
    _check_light(scene, states)


def _check_light(scene, states):
    """No design brings more light than any lens can, but for rounding and samples of near light."""
    (limit,) = light_limits(scene)
    assert max(state.account.efficiency for state in states) <= limit.most * 1.002


def _named(name):
    return next(each for each in resources.EXAMPLES if each.name == name)


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
    found = irradiance_derivative(scene, {"lens.back": flat}, (4, 4))
    inside = np.count_nonzero(found.map[1:-1, 1:-1])
    assert (np.count_nonzero(found.map) > inside) == reaches_border
    assert abs(found.sum) < sum_below * found.flux
    assert 0.4 < inside / found.map.size < 0.7  # large enough to be seen
