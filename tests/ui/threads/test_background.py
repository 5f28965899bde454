"""Work in a thread: what is reported, what is cancelled, what ends."""

import threading

import pytest
from PySide6.QtCore import QThread

from ui.background import Background
from workbench.errors import Refused


@pytest.fixture
def asked():
    asked = Asked()
    yield asked
    asked.end()


class Asked:
    """Requests that are answered backwards, one each time the gate is released."""

    def __init__(self, **options):
        self.gate = threading.Semaphore(0)
        self.begun, self.received, self.progress, self.threads = [], [], [], []
        self.ended, self.worked_in = [], []
        self.background = Background("turning round", None, **options)
        self.background.progressed.connect(lambda *received: self.progress.append(received))
        self.background.done.connect(self._hear)
        self.background.failed.connect(lambda sentence: self._hear(None, sentence))

    def ask(self, request):
        def turn_round(task):
            self.begun.append((request, task))
            self.worked_in.append(QThread.currentThread().objectName())
            task.report(f"{request}?")
            assert self.gate.acquire(timeout=20)
            self.ended.append(request)
            if request == "bad":
                raise Refused("run.seed", "no")
            return request[::-1]

        self.background.begin(turn_round, request)

    def end(self):
        self.gate.release(5)  # of a test that failed
        self.background.close()

    def _hear(self, request, outcome):
        self.received.append((request, outcome))
        self.threads.append(QThread.currentThread())


def test_results_arrive_with_their_request_in_the_main_thread(asked, qtbot, qapp):
    asked.ask("abc")
    assert asked.background.busy and asked.background.running
    asked.gate.release()
    qtbot.waitUntil(lambda: bool(asked.received))
    assert asked.progress == [("abc", "abc?")]
    assert asked.received == [("abc", "cba")] and asked.threads == [qapp.thread()]
    assert asked.worked_in == ["turning round"]
    assert not asked.background.busy and not asked.background.running


def test_only_the_latest_request_is_answered_and_earlier_ones_never_begin(asked, qtbot):
    for request in "abcde":
        asked.ask(request * 2)
    qtbot.waitUntil(lambda: bool(asked.begun))
    assert asked.begun[0][1].stopped
    asked.gate.release(2)
    qtbot.waitUntil(lambda: bool(asked.received))
    assert [request for request, _ in asked.begun] == ["aa", "ee"]
    assert asked.received == [("ee", "ee")] and asked.progress == [("ee", "ee?")]
    assert not asked.begun[1][1].stopped


def test_a_failure_arrives_as_its_sentence_and_another_request_can_follow(asked, qtbot):
    asked.gate.release(2)
    asked.ask("bad")
    qtbot.waitUntil(lambda: bool(asked.received))
    assert asked.received == [(None, "run.seed: no")]
    asked.ask("good")
    qtbot.waitUntil(lambda: len(asked.received) == 2)
    assert asked.received[1] == ("good", "doog")


@pytest.mark.parametrize("request_", ["abc", "bad"])
def test_cancelled_work_reports_nothing(asked, qtbot, request_):
    asked.ask(request_)
    asked.background.cancel()
    assert not asked.background.busy and asked.background.running
    asked.gate.release()
    qtbot.waitUntil(lambda: not asked.background.running)
    assert asked.begun[0][1].stopped
    assert asked.received == [] and asked.progress == []
