"""Files of scenes are of the oldest version that knows all that is in them."""

from typing import Annotated, ClassVar

from workbench.scene import Scene
from workbench.scene.fields import SINCE_2, about
from workbench.scene.part import Part


class _Old(Part):
    width: float = 1.0
    turn: Annotated[float, SINCE_2, about("Turn", "How far it is turned.")] = 0.0


class _New(Part):
    since: ClassVar = 2


class _Whole(Part):
    first: _Old = _Old()
    others: tuple[_Old | _New, ...] = ()


def test_a_new_field_needs_its_version_where_it_is_not_its_default():
    assert _Old(turn=0.0).needed_version == 1
    assert _Old(turn=1.0).needed_version == 2


def test_a_kind_of_part_that_is_new_needs_its_version_wherever_it_stands():
    assert _Whole(others=(_Old(),)).needed_version == 1
    assert _Whole(others=(_Old(), _New())).needed_version == 2
    assert _Whole(first=_Old(turn=2.0)).needed_version == 2


def test_files_of_version_1_leave_new_fields_out():
    whole = _Whole(others=(_Old(width=2.0),))
    data = whole.model_dump(mode="json")
    assert whole.known_to(1, data) == {"first": {"width": 1.0}, "others": [{"width": 2.0}]}
    assert whole.known_to(2, data) == data


def test_a_scene_writes_the_version_that_it_needs(make_scene):
    assert make_scene().to_data()["version"] == make_scene().needed_version == 1
    assert '"version": 1' in make_scene().to_json()
    assert Scene.from_json(make_scene().to_json()) == make_scene()
