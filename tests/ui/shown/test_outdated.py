"""What is shown of another design than the open one is marked, and no longer computed."""

import pytest

from tests.ui.hands import move_screen
from ui.shown import shown_lens
from ui.shown.shown_lens import ShownLens
from ui.views.photo_view import PhotoView
from ui.views.view import View
from ui.widgets.veil import Veil


@pytest.fixture
def shown(document):
    return ShownLens(document, document)


@pytest.fixture
def view(shown, show):
    view = show(View(), 200, 100)
    shown.add(view)
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


def test_undo_of_a_lens_alone_marks_what_is_shown(shown, view, document, frames, history, qtbot):
    document.set_result(history(2).result(), "run")
    shown.frame_changed.emit(frames(2, document.session))
    document.set_result(history(5).result(), "run")
    shown.frame_changed.emit(frames(5, document.session))
    document.undo_stack.undo()
    qtbot.waitUntil(lambda: view.outdated)
    document.undo_stack.redo()
    assert not view.outdated


def test_a_moment_of_the_run_that_is_looked_back_at_is_not_marked(
    shown, view, document, frames, history, qtbot
):
    document.set_result(history(5).result(), "run")
    shown.frame_changed.emit(frames(2, document.session))
    qtbot.wait(2 * shown_lens._AT_ONCE_MS)
    assert not view.outdated


def test_a_design_without_a_picture_is_not_marked(shown, view, document, frames, qtbot):
    shown.frame_changed.emit(frames(1, document.session))
    move_screen(document, 7)
    qtbot.waitUntil(lambda: view.outdated)
    shown.emptied.emit(document.session)
    assert not view.outdated


def test_frames_of_a_drag_are_not_marked_while_they_keep_coming(
    shown, view, document, frames, qtbot
):
    for z in range(6, 12):
        before = frames(1, document.session)
        move_screen(document, z)
        qtbot.wait(shown_lens._AT_ONCE_MS // 3)
        shown.frame_changed.emit(before)  # of the edit before
        assert not view.outdated
    qtbot.waitUntil(lambda: view.outdated)  # nothing more comes


def test_the_veil_greys_what_lies_below_and_leaves_it_the_mouse(show, qapp):
    below = show(View(), 300, 200)
    plain = below.grab().toImage()
    below.show_outdated(True)
    veil = below.findChild(Veil)
    assert veil.size() == below.size()
    assert below.grab().toImage() != plain
    below.resize(200, 150)
    qapp.processEvents()
    assert veil.size() == below.size()
    assert below.childAt(100, 100) is not veil


def test_a_photo_is_computed_no_more_once_its_design_is_left(
    shown, show, document, frames, monkeypatch, qtbot
):
    view = show(PhotoView(), 300, 300)
    shown.add(view)
    shown.frame_changed.emit(frames(1, document.session))
    qtbot.waitUntil(lambda: view._background.busy)
    move_screen(document, 7)
    assert not view._background.busy and not view._rest.isActive()
    view.close_thread()


def test_every_view_and_the_figures_in_the_status_are_marked(window, qtbot, display, kernels):
    window.build()
    loaded = window.loaded
    views = [loaded.views.scene, *loaded.views.docked.values()]
    qtbot.waitUntil(lambda: loaded.views.scene.frame is not None)
    loaded.control._preview.setInterval(10_000_000)  # nothing comes of the next design
    move_screen(window.document, 7)
    qtbot.waitUntil(lambda: all(view.outdated for view in views))
    assert loaded.production.manufacture._veil.isVisibleTo(loaded.production.manufacture)
    assert not window.status._outdated.isHidden()
    assert not window.status._light.isEnabled()
    loaded.control._preview.start(0)
    qtbot.waitUntil(lambda: not any(view.outdated for view in views))
    assert window.status._outdated.isHidden() and window.status._light.isEnabled()
