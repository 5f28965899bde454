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
    said = defects.unexpected(raised())
    assert said == f"unexpected KeyError: 'odd' (details are in {folder / 'errors.log'})"
    text = (folder / "errors.log").read_text()
    assert text.startswith("20")  # the date
    assert "Freeform Lens Workbench" in text and "Python 3" in text
    assert "Traceback" in text and "test_defects.py" in text
    assert "ValueError: at first" in text and text.rstrip().endswith("KeyError: 'odd'")


def test_errors_are_appended_to_the_file(folder):
    for text in ("one", "two"):
        defects.unexpected(raised(text))
    assert (folder / "errors.log").read_text().count("Traceback (most recent call last)") == 2


def test_old_errors_are_dropped(folder):
    for number in range(12):
        defects.unexpected(raised(f"{number}" + 60_000 * "x"))
    files = sorted(folder.iterdir())
    assert [file.name for file in files] == ["errors.log", "errors.old.log"]
    assert all(file.stat().st_size < 400_000 for file in files)
    assert "KeyError: '11xx" in files[0].read_text()


def test_one_error_is_cut_to_its_end(folder):
    defects.unexpected(raised(1_000_000 * "x" + "end"))
    assert (folder / "errors.log").stat().st_size < 100_000
    assert (folder / "errors.log").read_text().rstrip().endswith("xend'")


def test_the_sentence_says_if_nothing_can_be_written(folder):
    folder.write_text("a file where a folder should be")
    said = defects.unexpected(raised())
    assert said.startswith("unexpected KeyError: 'odd' (details could not be written to ")
    assert said.endswith("File exists)")
