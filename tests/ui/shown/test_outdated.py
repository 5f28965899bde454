"""What is shown of another design than the open one is marked, and no longer computed."""

import pytest

from tests.ui.hands import move_screen
from ui.document.shown_lens import ShownLens
from ui.views.view import View


@pytest.fixture
def shown(document):
    return ShownLens(document, document)


@pytest.fixture
def view(shown, document, show):
    view = show(View(), 200, 100)
    view.follow(document, shown)
    return view


def test_a_view_is_marked_after_an_edit_until_a_frame_of_it_comes(
    shown, view, document, frames, qtbot
):
    shown.frame_changed.emit(frames(1, document.session))
    assert not view.outdated
    move_screen(document, 7)
    qtbot.waitUntil(lambda: view.outdated)
    shown.frame_changed.emit(frames(1, document.session))
    assert not view.outdated


def test_every_view_but_the_pinned_one_and_the_result_cards_are_marked(
    window, qtbot, display, kernels
):
    window.build()
    loaded = window.loaded
    around = loaded.views.around
    views = [loaded.views.scene, *(around[name] for name in around if name != "pinned")]
    qtbot.waitUntil(lambda: loaded.views.scene.frame is not None)
    loaded.control._preview.setInterval(10_000_000)  # nothing comes of the next design
    move_screen(window.document, 7)
    qtbot.waitUntil(lambda: all(view.outdated for view in views))
    assert not around["pinned"].outdated
    assert loaded.manufacture._veil.isVisibleTo(loaded.manufacture)
    assert not loaded.cards._veil.isHidden()
    loaded.control._preview.start(0)
    qtbot.waitUntil(lambda: not any(view.outdated for view in views))
    qtbot.waitUntil(loaded.cards._veil.isHidden)
