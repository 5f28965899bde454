"""The run panel: what is optimised, what that costs, and a learning rate that may be left out."""

import pytest

from tests.ui.hands import choose, editor, row

PAPER_ONLY = ["run.parametrisation", "run.parameters", "run.start", "run.learning_rate"]


@pytest.fixture
def session(make_session):
    return make_session({"lens.control_points": [64, 64], "run": {"method": "paper"}})


def rate(forms):
    return editor(forms, "run.learning_rate")


def test_the_papers_settings_are_there_with_its_method_alone(forms, document):
    assert all(row(forms, path).isVisible() for path in PAPER_ONLY)
    choose(forms, "run.method", "auto")
    assert not any(row(forms, path, visible=False).isVisible() for path in PAPER_ONLY)
    choose(forms, "run.method", "paper")
    assert all(row(forms, path).isVisible() for path in PAPER_ONLY)


@pytest.mark.parametrize(
    ("kind", "size"),
    [
        ("none", "4,096 (131 kB)"),
        ("sparse", "396,576 (6.35 MB)"),
        ("dense", "33,570,816 (537 MB)"),
    ],
)
def test_a_choice_shows_its_parameters_and_their_memory(forms, document, kind, size):
    choose(forms, "run.parametrisation", kind)
    assert document.session.scene.run.parametrisation == kind
    assert row(forms, "run.parameters").text.text() == size
