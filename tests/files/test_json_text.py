import pytest

from workbench.errors import Refused
from workbench.files.scene import check_fields_once


@pytest.mark.parametrize(
    ("text", "path"),
    [
        ('{"a": 1, "a": 1}', "a"),
        ('{"run": {"stages": [{}, {"filter": 1, "x": [], "filter": 1}]}}', "run.stages[1].filter"),
        ('{"a": {"b": 1, "b": 2}, "a": 3}', "a.b"),
        (r'{"a\n b": 1, "a\n b": 2}', r"'a\n b'"),
        (r'{"a": 1, "\u0061": 2}', "a"),
    ],
)
def test_a_field_that_is_given_twice_is_refused(text, path):
    with pytest.raises(Refused) as refused:
        check_fields_once(text, "file: ")
    assert str(refused.value) == f"file: {path}: is given twice; each field can be there once"
