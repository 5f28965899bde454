"""Rows follow from what fields say: a new field or kind is in the form without another file."""

from typing import Annotated, Literal

import pytest
from pydantic import ConfigDict

from ui.panels.fields import CheckRow, ChoiceRow, NumberRow, TextRow
from ui.panels.optional import OptionalRow
from ui.panels.panel import Panel
from ui.panels.rows import KindRow, Rows, value_row
from workbench.scene import LENGTH, Kinds, PointSource, Scene
from workbench.scene.fields import PLACE, Choices, Measure, about
from workbench.scene.part import Part, Positive


class Holder(Part):
    """Holds a lens."""

    ledge: Annotated[Positive, LENGTH, about("Ledge", "What it rests on.")]
    screws: Annotated[tuple[int, int, int], PLACE, about("Screws", "Of each size.")]
    torque: Annotated[float | None, Measure("N·m"), about("Torque", "Of a screw.", ge=0, le=5)]
    glued: Annotated[bool, about("Glued", "Whether it is.")]
    metal: Annotated[
        Literal["al", "brass"], Choices((("al", "Aluminium"),)), about("Metal", "Of its ring.")
    ]
    maker: Annotated[str, about("Maker", "Who has it.")]


def test_each_field_has_the_row_of_its_type(qtbot):
    rows = {field.name: value_row(field, f"holder.{field.name}") for field in Holder.fields()}
    panel = Panel("Holder", list(rows.values()))
    qtbot.addWidget(panel)
    assert {name: type(row) for name, row in rows.items()} == {
        "ledge": NumberRow,
        "screws": NumberRow,
        "torque": OptionalRow,
        "glued": CheckRow,
        "metal": ChoiceRow,
        "maker": TextRow,
    }
    assert rows["ledge"].label.text() == "Ledge" and "What it rests on." in rows["ledge"].toolTip()
    assert "Of a screw. From 0 to 5." in rows["torque"].toolTip()
    assert len(rows["screws"].editors) == 3
    rows["torque"].show_scene({"unit": "mm", "holder": {"torque": None}}, set())
    assert rows["torque"].editors["holder.torque"].placeholderText() == "none"
    rows["ledge"].show_scene({"unit": "mm", "holder": {"ledge": 2.5}}, set())
    assert (rows["ledge"].editors["holder.ledge"].text(), rows["ledge"]._unit.text()) == (
        "2.5",
        "mm",
    )
    metals = rows["metal"].chooser
    assert [metals.itemText(k) for k in range(metals.count())] == ["Aluminium", "Brass"]


class Ring(PointSource):
    """Light from a circle of points."""

    model_config = ConfigDict(title="Ring of points")

    kind: Literal["ring"]
    radius: Annotated[Positive, LENGTH, about("Radius", "Of the circle.")]


class Lit(Part):
    """A scene with another kind of source."""

    source: Annotated[PointSource | Ring, Kinds("kind"), about("Source", "Light.")]


@pytest.fixture
def lit_rows(qtbot, make_scene):
    scene = make_scene({"source": {"kind": "point", "position": [0, 0, -5]}})
    (field,) = Lit.fields()
    made = Rows(lambda: scene).of_kinds(field, field.mark(Kinds), "source", "Kind")
    panel = Panel("Source", made)
    qtbot.addWidget(panel)
    yield panel.rows


def test_a_new_kind_is_chosen_by_its_title_and_has_its_rows(lit_rows, make_scene):
    kind, *others = lit_rows
    assert isinstance(kind, KindRow)
    assert [kind.chooser.itemText(k) for k in (0, 1)] == ["Point source", "Ring of points"]
    assert "Ring of points: light from a circle of points." in kind.toolTip()
    point = make_scene({"source": {"kind": "point", "position": [0, 0, -5]}})
    ring = Ring(kind="ring", position=(0.0, 0.0, -5.0), radius=0.5)
    names = [row.path for row in others if row.present(point.model_copy(update={"source": ring}))]
    assert "source.radius" in names and "source.position" in names
    assert "source.radius" not in [row.path for row in others if row.present(point)]
    assert len(names) == len(set(names))


def test_a_kind_that_needs_what_a_person_gives_is_asked_for(lit_rows, make_scene, qtbot):
    kind = lit_rows[0]
    kind.show_scene(make_scene({"source": {"kind": "point", "position": [0, 0, -5]}}), set())
    edits = []
    kind.edited.connect(edits.append)
    with qtbot.waitSignal(kind.asked) as asked:  # a ring of no radius cannot begin
        kind.chooser.activated.emit(1)
    assert asked.args == [Ring] and edits == []


def test_the_form_has_a_row_for_every_field_of_a_scene(forms):
    shown = {row.path for panel in forms.panels for row in panel.rows}
    wanted = set()
    for field in Scene.fields():
        for kind in () if field.listed else field.parts:  # rows of listed ones come with them
            wanted |= {f"{field.name}.{own.name}" for own in kind.fields() if not own.parts}
    assert wanted - shown == set()
