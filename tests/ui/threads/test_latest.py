"""Work for the latest question alone: what is told, what is left, what ends."""

import threading

import pytest

from ui.threads.latest import Latest
from workbench.errors import Refused


@pytest.fixture
def asked():
    asked = Asked()
    yield asked
    asked.gate.release(5)  # of a test that failed
    asked.latest.close()


class Asked:
    """Questions that are answered backwards, one each time the gate is released."""

    def __init__(self):
        self.gate = threading.Semaphore(0)
        self.begun, self.told = [], []
        self.latest = Latest("turning round", None)
        self.latest.answered.connect(lambda question, answer: self.told.append((question, answer)))
        self.latest.failed.connect(
            lambda question, sentence: self.told.append((question, sentence))
        )

    def ask(self, question):
        def turn_round(left):
            self.begun.append((question, left))
            assert self.gate.acquire(timeout=20)
            if question == "bad":
                raise Refused("run.seed", "no")
            return question[::-1]

        self.latest.ask(question, turn_round)


def test_an_answer_comes_with_its_question(asked, qtbot):
    asked.ask("abc")
    assert asked.latest.busy and asked.latest.wants("abc")
    asked.gate.release()
    qtbot.waitUntil(lambda: bool(asked.told))
    assert asked.told == [("abc", "cba")]
    assert not asked.latest.busy and not asked.latest.wants("abc")


def test_only_the_latest_is_told_and_those_between_never_begin(asked, qtbot):
    for question in "abcde":
        asked.ask(question * 2)
    qtbot.waitUntil(lambda: bool(asked.begun))
    assert asked.begun[0][1].is_set()
    asked.gate.release(2)
    qtbot.waitUntil(lambda: bool(asked.told))
    assert [question for question, _ in asked.begun] == ["aa", "ee"]
    assert asked.told == [("ee", "ee")]
    assert not asked.begun[1][1].is_set()


def test_a_failure_is_told_and_another_question_can_follow(asked, qtbot):
    asked.gate.release(2)
    asked.ask("bad")
    qtbot.waitUntil(lambda: bool(asked.told))
    assert asked.told == [("bad", "run.seed: no")]
    asked.ask("good")
    qtbot.waitUntil(lambda: len(asked.told) == 2)
    assert asked.told[1] == ("good", "doog")


@pytest.mark.parametrize("question", ["abc", "bad"])
def test_what_is_forgotten_is_never_told(asked, qtbot, question):
    asked.ask(question)
    asked.latest.forget()
    assert not asked.latest.busy
    asked.gate.release()
    qtbot.waitUntil(lambda: not asked.latest._background.busy)
    assert asked.told == []


def test_closing_waits_and_tells_nothing(asked, qtbot):
    asked.ask("abc")
    asked.gate.release()
    asked.latest.close()
    asked.latest.close()
    assert "turning round" not in {thread.name for thread in threading.enumerate()}
    qtbot.wait(50)
    assert asked.told == []
