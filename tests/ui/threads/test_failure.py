"""What a person, the log and the file get of work in a thread that failed."""

import pytest

from ui.startup.unexpected_errors import UnexpectedErrors
from ui.threads.background import Background
from ui.threads.failure import sentence_of
from workbench.defects import file
from workbench.errors import Refused, RunFailed


@pytest.fixture
def logged(qapp):
    unexpected, lines = UnexpectedErrors(), []
    unexpected.logged.connect(lines.append)
    yield lines
    unexpected.close()
    unexpected.deleteLater()


@pytest.mark.parametrize("error", [Refused("lens", "too thick"), RunFailed("no light")])
def test_a_refusal_is_a_sentence_and_no_defect(logged, error):
    assert sentence_of(error, "run") == str(error)
    assert not logged


def divided_by_nothing(task):
    return 1 / 0


def test_a_defect_in_a_thread_is_shown_logged_and_written(qtbot, qapp, logged, capsys):
    background, failures = Background("export", qapp), []
    background.failed.connect(lambda _, error: failures.append(error))
    background.begin(divided_by_nothing)
    qtbot.waitUntil(lambda: bool(failures))
    background.deleteLater()
    assert isinstance(failures[0], ZeroDivisionError)
    assert sentence_of(failures[0], "export") == (
        "The export ended with an unexpected ZeroDivisionError: division by zero "
        f"(details are in {file()})"
    )
    (details,) = logged
    for text in (details, file().read_text(), capsys.readouterr().err):
        assert "Traceback" in text and "in divided_by_nothing" in text
