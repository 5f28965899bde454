"""Unexpected errors are kept in a file that says all and does not grow for ever."""

import pytest

from workbench import defects


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    return tmp_path / "freeform-workbench"


def raised(text="odd"):
    try:
        raise KeyError(text) from ValueError("at first")
    except KeyError as error:
        return error


def test_the_sentence_names_the_file_and_the_file_has_the_traceback(folder):
    stated = defects.unexpected(raised())
    assert stated == f"unexpected KeyError: 'odd' (details are in {folder / 'errors.log'})"
    text = (folder / "errors.log").read_text()
    assert text.startswith("20")  # the date
    assert "Freeform Lens Workbench" in text and "Python 3" in text
    assert "Traceback" in text and "test_defects.py" in text
    assert "ValueError: at first" in text and text.rstrip().endswith("KeyError: 'odd'")
