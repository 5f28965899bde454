"""Reports from the window: written by a process beside it, reported, cancelled, refused."""

import subprocess
import sys

import pytest

from ui.files import exporter


@pytest.fixture
def window(open_window, designed):
    return open_window(designed, "flat lens")


def as_command(text):
    """A process that does this with the session's and the report's path."""
    return (sys.executable, "-c", f"import sys, time; lens, report = sys.argv[1:]; {text}")


@pytest.fixture
def written(window, qtbot):
    def report(path):
        window.reporter.report(path)
        qtbot.waitUntil(lambda: not window.reporter.background.busy, timeout=120_000)
        return window.messages.text

    return report


@pytest.mark.slow
@pytest.mark.parametrize(("name", "begin"), [("a.html", b"<!doctype html>"), ("a.pdf", b"%PDF-")])
def test_a_report_is_written(display, window, written, name, begin, tmp_path):
    path = tmp_path / name
    assert written(path).startswith(f"{path}: report; this lens")
    content = path.read_bytes()
    assert content.startswith(begin) and len(content) > 50_000
    if name == "a.html":
        assert b"<title>flat lens</title>" in content


def test_the_command_asks_and_takes_the_session_as_it_is(window, monkeypatch, tmp_path, qtbot):
    path = tmp_path / "there.html"
    copy = "import shutil; shutil.copy(lens, report); open(report, 'a').write(lens)"
    monkeypatch.setattr(exporter, "_COMMAND", as_command(copy))
    monkeypatch.setattr(window.dialogs, "to_save", lambda *_: path)
    window.commands["report"].trigger()
    assert window.early.shelf.running[0].title == "Report there.html"
    qtbot.waitUntil(lambda: window.messages.text.startswith(f"{path}: report; "), timeout=30_000)
    assert path.read_bytes().startswith(b"PK")  # the session itself
    assert path.read_bytes().endswith(b"flat lens.freeform")
    assert [each.name for each in tmp_path.iterdir() if each.suffix != ".ini"] == ["there.html"]


def test_a_report_that_fails_shows_the_reason(window, written, monkeypatch, tmp_path):
    fail = "print('chatter', file=sys.stderr); sys.exit('freeform: no light of this lens')"
    monkeypatch.setattr(exporter, "_COMMAND", as_command(fail))
    path = tmp_path / "a.html"
    path.write_text("before")
    assert written(path) == "No report: no light of this lens"
    assert path.read_text() == "before"
    monkeypatch.setattr(exporter, "_COMMAND", as_command("sys.exit(3)"))
    assert written(path) == "No report: it ended without a message"
    assert window.messages.notices[-1].kind == "warning"


@pytest.mark.parametrize("name", ["a.docx", "no/a.pdf"])
def test_unwritable_report_is_refused_at_once(window, written, name, monkeypatch, tmp_path):
    monkeypatch.setattr(exporter, "_COMMAND", ("no such program",))
    assert str(tmp_path / name) in written(tmp_path / name)
    assert window.messages.notices[-1].kind == "warning"


@pytest.fixture
def endless(monkeypatch):
    """A report that never ends; its processes."""
    begun = []

    class Noted(subprocess.Popen):
        def __init__(self, *arguments, **named):
            super().__init__(*arguments, **named)
            begun.append(self)

    monkeypatch.setattr(exporter, "Popen", Noted)
    monkeypatch.setattr(exporter, "_COMMAND", as_command("time.sleep(600)"))
    return begun


def test_a_report_is_cancelled_on_the_shelf(window, endless, tmp_path, qtbot):
    path = tmp_path / "a.pdf"
    window.reporter.report(path)
    qtbot.waitUntil(lambda: len(endless) == 1, timeout=30_000)
    window.reporter.report(path)
    assert "still being written" in window.messages.text
    (entry,) = window.early.shelf.entries
    entry.cancel.click()
    qtbot.waitUntil(lambda: entry.outcome.text() == "No file was written.", timeout=30_000)
    assert endless[0].returncode not in (None, 0)
    assert len(endless) == 1 and not path.exists()
