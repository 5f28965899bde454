"""Rows follow from what fields say: a new field or kind is in the form without another file."""

from typing import Annotated, Literal

from ui.panels.fields import CheckRow, ChoiceRow, NumberRow
from ui.panels.panel import Panel
from ui.panels.rows import value_row
from ui.panels.text_rows import TextRow
from workbench.levels import EXPERT, Level, full_size
from workbench.scene import LENGTH, Scene
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
    maker: Annotated[str, EXPERT, about("Maker", "Who has it.")]
    half: Annotated[Positive, LENGTH, full_size("From rim to rim."), about("Half", "Its radius.")]


def test_each_field_has_the_row_of_its_type(qtbot):
    rows = {field.name: value_row(field, f"holder.{field.name}") for field in Holder.fields()}
    panel = Panel("Holder", list(rows.values()))
    qtbot.addWidget(panel)
    assert {name: type(row) for name, row in rows.items()} == {
        "ledge": NumberRow,
        "screws": NumberRow,
        "torque": NumberRow,
        "glued": CheckRow,
        "metal": ChoiceRow,
        "maker": TextRow,
        "half": NumberRow,
    }
    assert [rows[name].level for name in ("metal", "maker")] == [Level.JOB, Level.EXPERT]
    assert rows["half"].label.text() == "Size" and "From rim to rim." in rows["half"].toolTip()
    rows["half"].show_scene({"unit": "mm", "holder": {"half": 1.5}}, set())
    assert rows["half"].editors["holder.half"].text() == "3"
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


def test_the_form_has_a_row_for_every_field_of_a_scene(forms):
    shown = {row.path for panel in forms.panels for row in panel.rows}
    wanted = set()
    for field in Scene.fields():
        for kind in () if field.listed else field.parts:  # rows of listed ones come with them
            wanted |= {f"{field.name}.{own.name}" for own in kind.fields() if not own.parts}
    assert wanted - shown == set()
