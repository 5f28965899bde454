"""Lenses that follow edits, from an engine that takes a step when a test lets it."""

import threading
import time
from dataclasses import replace
from functools import partial

import pytest

from ui.document.document import Document
from ui.run import follow as followed
from ui.run import worker
from ui.run.checks import Check
from ui.run.control import RunControl
from ui.run.follow import Follow
from ui.run.kept_runs import restored
from workbench.design.live import LiveDesign
from workbench.progress import check_given_up

_FREE = 10_000


class Engine:
    """Stands in for `workbench.design.run.run`; each snapshot but a first one needs leave."""

    def __init__(self, snapshots, iterations=5):
        self.leave = threading.Semaphore(_FREE)
        self.asked, self.open, self.iterations = [], 0, iterations
        self.gets_worse = False
        self._snapshots = snapshots

    def hold(self):
        self.leave = threading.Semaphore(0)

    def __call__(self, scene, target, start=None, locked=None):
        self.asked.append((scene.receiver.z, start is not None))
        self.open += 1
        try:
            for iteration in range(self.iterations + 1):
                if iteration:
                    self.leave.acquire()
                found = self._snapshots(iteration, self.iterations)
                worse = self.gets_worse and iteration > 1
                state = replace(found.state, loss=1.0 if worse else 1e-5 / (1 + iteration))
                merit = 2.0 if worse else found.merit
                yield replace(found, state=state, merit=merit, best=not worse)
            return "converged"
        finally:
            self.open -= 1


@pytest.fixture
def engine(snapshots):
    engine = Engine(snapshots)
    yield engine
    engine.leave.release(_FREE)


class Desk:
    """A document whose edits are followed, without a window."""

    def __init__(self, session, engine, qtbot):
        self.document, self.engine, self._qtbot = Document(session, "small"), engine, qtbot
        self.control = RunControl(self.document, self.document)
        self.control.runner._generate = engine
        live = LiveDesign(engine, refit=lambda *_: None)
        self.follow = Follow(self.document, self.control, self.document, live)
        self.frames, self.settled, self.failed = [], [], []
        self.control.runner.frame_ready.connect(self.frames.append)
        self.follow.settled.connect(lambda: self.settled.append(self.document.session))
        self.follow.failed.connect(self.failed.append)

    @property
    def steps(self):
        return self.document.undo_stack.count()

    def edit(self, z, key=""):
        scene = self.document.session.scene
        screen = scene.receiver.moved_to(z)
        self.document.edit(scene.with_receiver(screen), "change", key)

    def wait(self, settled=1):
        self._qtbot.waitUntil(lambda: len(self.settled) >= settled)

    def come_to_a_lens(self):
        """Let the design go on until the document has a lens from it."""
        while self.document.session.result is None:
            self.step()

    def step(self):
        """Let the design make a step, and see what comes of it."""
        self.engine.leave.release(1)
        self._qtbot.wait(80)

    def seen(self):
        """Places of the screen of which a lens was seen that is none from before."""
        zs = [f.session.scene.receiver.z for f in self.frames if f.snapshot.iteration]
        return list(dict.fromkeys(zs))

    def close(self):
        self.engine.leave.release(_FREE)
        self.follow.close()
        self.control.close()
        self.document.deleteLater()


@pytest.fixture
def make_desk(engine, qtbot, designed, monkeypatch):
    monkeypatch.setattr(worker, "_FRAME_S", 0.0)  # each lens is seen
    desks = []

    def make(session=designed, on=True, **options):
        desk = Desk(session, engine, qtbot, **options)
        desks.append(desk)
        if on:
            desk.follow.switch(True)
        return desk

    yield make
    for desk in desks:
        desk.close()


@pytest.fixture
def desk(make_desk):
    return make_desk()


def test_an_edit_is_followed_by_a_lens_that_the_document_gets(desk):
    desk.edit(7)
    desk.wait()
    session = desk.document.session
    assert session.scene.receiver.z == 7
    assert session.result is not None
    assert session.result.ended == "converged"
    assert session.result.iterations == 5
    assert desk.follow.text == ""


def test_an_edit_and_its_lens_are_one_step_that_is_undone_and_redone_without_a_design(
    desk, designed, qtbot
):
    desk.edit(7)
    desk.wait()
    lens, asked = desk.document.session.result, len(desk.engine.asked)
    assert desk.steps == 1
    desk.document.undo_stack.undo()
    assert desk.document.session is designed
    desk.document.undo_stack.redo()
    assert desk.document.session.result is lens
    qtbot.wait(300)  # a preview comes, and nothing else
    assert len(desk.engine.asked) == asked


def test_edits_wait_for_the_first_lens_and_the_latest_is_designed_next(desk):
    desk.engine.hold()
    desk.edit(6)
    desk.edit(7)
    desk.edit(8)
    desk.engine.leave.release(_FREE)
    desk.wait()
    assert desk.seen() == [6, 8]
    assert [z for z, _ in desk.engine.asked] == [6, 8]
    assert desk.document.session.scene.receiver.z == 8
    assert desk.document.session.result is not None


def test_each_edit_of_a_drag_continues_from_the_last_lens_that_followed(desk, designed):
    chains = []
    live = desk.follow._live
    snapshots = live.snapshots
    live.snapshots = lambda session, chain, before: (
        chains.append(chain) or snapshots(session, chain, before)
    )
    for settled, z in enumerate((6, 7, 8), 1):
        desk.edit(z, key="drag")
        desk.wait(settled)
    assert chains == chains[:1] * 3
    desk.document.undo_stack.setIndex(0)
    assert desk.document.session is designed
    desk.edit(9)
    desk.wait(4)
    assert chains[-1] is not chains[0]


def test_a_run_stops_the_following_design(desk, qtbot):
    desk.engine.iterations = 1000
    desk.engine.hold()
    desk.edit(7)
    desk.come_to_a_lens()
    desk.control.start()
    desk.engine.leave.release(5)
    qtbot.waitUntil(lambda: not desk.follow._background.running)
    assert desk.control.busy
    assert desk.follow.text == ""
    with qtbot.waitSignal(desk.control.ended):
        desk.control.runner.stop()
        desk.engine.leave.release(_FREE)
    assert desk.settled == []


@pytest.mark.parametrize("way", ["undo", "begin", "edit"])
def test_an_abandoned_design_ends_before_its_first_lens(desk, qtbot, designed, way):
    begun = []

    def endless(scene, *_):
        begun.append(scene.receiver.z)
        while True:
            check_given_up()
            time.sleep(0.002)
        yield

    desk.follow._live = LiveDesign(endless, refit=lambda *_: None)
    desk.edit(7)
    qtbot.waitUntil(lambda: begun == [7])
    if way == "undo":
        desk.document.undo_stack.undo()
        qtbot.waitUntil(lambda: desk.follow.text == "")
    elif way == "begin":
        desk.document.begin(designed, "new")
        qtbot.waitUntil(lambda: begun == [7, 5])
    else:
        desk.edit(8)  # the first design may still come soon
        qtbot.waitUntil(lambda: begun == [7, 8])
    desk.follow.rest()
    qtbot.waitUntil(lambda: not desk.follow._background.running)


def test_a_slow_machine_makes_edits_wait_for_a_pause_and_switches_nothing_off(
    desk, qtbot, monkeypatch
):
    monkeypatch.setattr(followed, "_SOON", 0.05)
    monkeypatch.setattr(followed, "_SHARE", 2.0)
    desk.follow._late.setInterval(50)
    desk.engine.hold()
    desk.edit(6)
    qtbot.waitUntil(lambda: "slow task" in desk.follow.text)
    desk.engine.leave.release(_FREE)
    desk.wait()
    for z in (7, 8, 9):  # within one pause
        desk.edit(z)
    assert [z for z, _ in desk.engine.asked] == [6]
    assert desk.follow.follows(desk.document.session) and desk.follow.text
    desk.wait(2)
    assert [z for z, _ in desk.engine.asked] == [6, 9]
    assert desk.document.session.result is not None


def test_every_finished_lens_is_a_step_and_a_run_that_can_be_restored(desk, designed):
    lenses = []
    for settled, z in enumerate((6, 7, 8), 1):
        desk.edit(z, key="images[0].receiver.position[2]")  # one field, edited again and again
        desk.wait(settled)
        lenses.append(desk.document.session.result)
    runs = desk.document.session.runs
    assert [run.name for run in runs] == [f"Followed {k}: auto, 12 × 10" for k in (1, 2, 3)]
    assert [run.result for run in runs] == lenses
    assert [run.scene.receiver.z for run in runs] == [6, 7, 8]
    desk.document.change(restored(desk.document.session, runs[0]), "return")
    assert desk.document.session.result is lenses[0]
    assert desk.document.session.scene.receiver.z == 6
    for lens in reversed(lenses):
        desk.document.undo_stack.undo()
        assert desk.document.session.result is lens
    desk.document.undo_stack.undo()
    assert desk.document.session is designed


def test_a_check_is_of_the_best_lens_that_followed(desk, qtbot):
    check = Check(desk.document)
    desk.control.runner.frame_ready.connect(check.show_frame)
    check.under_way_changed.connect(partial(desk.follow.hold, "check"))
    asked = []
    check.background.begin = lambda work, lens, title: asked.append(lens)
    desk.engine.iterations, desk.engine.gets_worse = 1000, True
    desk.engine.hold()
    desk.edit(7)
    desk.come_to_a_lens()
    lens = desk.document.session.result
    desk.step()
    assert desk.frames[-1].state.heights != lens.state.heights
    check.toggle()
    qtbot.wait(300)  # for a preview
    assert asked[0].heights == lens.state.heights
    assert desk.frames[-1].state.heights == lens.state.heights
    assert desk.document.session.heights == lens.state.heights
    assert check._asked is not None
    check.background.close()


def test_a_new_task_is_designed_once_nothing_pauses_any_more(desk, session, qtbot):
    desk.follow.hold("start page", True)
    desk.document.begin(session, "anew")
    desk.follow.hold("check", False)  # that nobody began
    qtbot.wait(100)
    assert not desk.engine.asked
    desk.follow.hold("start page", False)
    desk.wait()
    assert desk.document.session.result is not None


def test_a_task_that_is_begun_anew_is_designed(desk, session):
    desk.engine.hold()
    desk.document.begin(session, "anew")
    desk.document.begun.emit(session)
    desk.engine.leave.release(_FREE)
    desk.wait()
    assert desk.document.session.result is not None
