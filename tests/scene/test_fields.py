"""Fields describe themselves: units, titles and the schema of a new one follow by themselves."""

from typing import Annotated

import pytest

from workbench.levels import Level
from workbench.scene import (
    LENGTH,
    CollimatedSource,
    GridSource,
    Image,
    Kinds,
    Lens,
    PointSource,
    Scene,
    SplineFace,
)
from workbench.scene.fields import Measure, about
from workbench.scene.part import Part, Positive
from workbench.scene.run import Stage


def parts(part=Scene):
    """All parts that a scene may have, each once."""
    found = {part: None}
    for field in part.fields():
        for kind in field.parts:
            found |= dict.fromkeys(parts(kind))
    return found


FILE = {
    "format",
    "version",
    "kind",
    "method",
    "shape",
    "builtin",
}  # no values to choose by themselves


def test_every_field_has_a_title_and_a_tip():
    for part in parts():
        for field in part.fields():
            if field.name not in FILE or field.optional:
                assert field.tip.endswith("."), (part, field.name)
                assert part.model_fields[field.name].title, (part, field.name)


def test_the_schema_says_what_the_fields_say():
    for part in parts():
        check_schema(part, part.model_json_schema())


def check_schema(part, schema):
    for field in part.fields():
        stated = schema["properties"][field.name]
        if field.tip:
            # Where there is one kind only, it is that which has the title.
            kind = (
                schema["$defs"][stated["$ref"].rpartition("/")[2]] if "$ref" in stated else stated
            )
            assert kind["title"] == field.title
            assert stated["description"] == field.tip
        if words := field.measure.words_in("length"):
            assert stated["unit"] == words


def test_a_field_states_its_limits():
    parts = Lens, SplineFace, Stage
    limits = {field.name: field.limits for part in parts for field in part.fields()}
    assert limits["degree"] == "From 1 to 7."
    assert limits["iterations"] == "From 1 to 1000000."
    assert limits["thickness"] == limits["half_width"] == ""


def test_fields_of_a_kind_come_before_those_of_all_kinds():
    (target,) = (field for field in Image.fields() if field.name == "target")
    names = [field.name for field in target.parts[1].fields()]
    assert names == ["builtin", "radius", "padding", "blur", "invert", "viewed_from"]


def test_a_new_field_is_converted_and_described():
    class Holder(Part):
        ledge: Annotated[
            tuple[Positive, Positive],
            LENGTH,
            about("Ledge", "What the holder needs.", max_length=2),
        ]
        torque: Annotated[float, Measure("N·m", "newton metres"), about("Torque", "Of its screws.")]

    held = Holder(ledge=(2.0, 3.0), torque=0.5).scaled(10)
    assert (held.ledge, held.torque) == ((20.0, 30.0), 0.5)
    ledge, torque = Holder.fields()
    assert (ledge.title, ledge.number, ledge.count) == ("Ledge", float, 2)
    assert (ledge.measure.sign_in("mm"), torque.measure.sign_in("mm")) == ("mm", "N·m")


@pytest.mark.parametrize(
    ("power", "sign"), [(1, "mm"), (2, "mm²"), (-1, "mm⁻¹")], ids=["length", "area", "per length"]
)
def test_a_measure_is_a_power_of_the_unit(power, sign):
    assert Measure(power=power).sign_in("mm") == sign


GRID = {"kind": "grid", "center": [0, 1, -3], "half_width": [0.3, 0.2], "points": [2, 3]}


def test_another_kind_keeps_the_fields_that_both_kinds_have(make_scene):
    scene = make_scene({"source": GRID | {"emission": "lambertian", "rays": 7}})
    kinds = next(field for field in Scene.fields() if field.name == "source").mark(Kinds)
    point = kinds.exchanged(scene.source, PointSource, scene)
    assert (point.position, point.emission) == ((0, 1, -3), "lambertian")
    assert point.rays == 500_000  # rays of one point of a grid are another thing
    assert kinds.exchanged(point, CollimatedSource, scene) == CollimatedSource(kind="collimated")


def test_a_source_that_is_new_stands_in_front_of_its_lens(make_scene):
    scene = make_scene(
        {"lens.half_width": [2.0, 1.0], "lens.base": {"height": 1.0}, "lens.entrance_z": -1.0}
    )
    kinds = next(field for field in Scene.fields() if field.name == "source").mark(Kinds)
    grid = kinds.exchanged(scene.source, GridSource, scene)
    assert (grid.position, grid.half_width) == ((0, 0, -11), (1, 0.5))


def test_a_value_differs_from_its_default_whatever_the_unit(make_scene):
    scene = make_scene({"lens.half_width": [1.0, 0.3]})
    for seen in (scene, scene.in_unit("mm"), scene.in_unit("inch")):
        lens = seen.optic
        assert not lens.differs("min_thickness") and not lens.differs("half_width")
    assert scene.altered(run=scene.run.altered(seed=3)).run.differs("seed")


def test_what_a_scene_has_to_say_is_in_view():
    required = {
        field.name
        for part in parts()
        for field in part.fields()
        if part.model_fields[field.name].is_required() and field.level is not Level.JOB
    }
    # The name heads the rows of its element; numbers of points and pixels only resolve.
    assert required <= {"name", "points", "pixels"}
