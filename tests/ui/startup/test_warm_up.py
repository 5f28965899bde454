"""Slow libraries are imported in a thread, and the window is told in any case."""

import pytest

from ui.startup import warm_up
from workbench.analysis import kernels


@pytest.fixture
def warmed_up(qtbot, monkeypatch):
    """Imports modules, and gives what was compiled and what was told."""

    def do(modules):
        compiled, received = [], []
        monkeypatch.setattr(warm_up, "_SLOW", modules)
        monkeypatch.setattr(kernels, "compile_all", lambda goes_on: compiled.append(goes_on()))
        warming = warm_up.WarmUp()
        warming.imported.connect(lambda: received.append("imported"))
        warming.failed.connect(received.append)
        warming.start()
        qtbot.waitUntil(lambda: not warming._background.running)
        warming.wait()
        return compiled, received

    return do


def test_kernels_are_made_ready_after_the_libraries(warmed_up):
    assert warmed_up(("json",)) == ([True], ["imported"])


def test_a_library_that_cannot_be_imported_is_reported_and_the_window_is_built(warmed_up):
    compiled, (first, sentence) = warmed_up(("no_such_library",))
    assert compiled == [] and first == "imported"
    assert "unexpected ModuleNotFoundError: No module named 'no_such_library'" in sentence
