"""A defect of the program ends a command with one line; its traceback is in a file."""

from workbench.cli import arguments, main
from workbench.defects import file


def test_one_line_names_the_file_that_has_the_traceback(monkeypatch, capsys):
    def broken_parser(_):
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(arguments, "parse", broken_parser)
    assert main(["design"]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err == f"freeform: unexpected ZeroDivisionError: by zero (details are in {file()})\n"
    text = file().read_text()
    assert "Traceback" in text and "in broken_parser" in text
