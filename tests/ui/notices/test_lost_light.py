"""What the window says when little light reaches the screen after a run."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.run.control import RunControl
from ui.widgets.messages import MessageBar
from ui.window.run_notices import LostLightNotice
from workbench.optics.account import Account

LOST = Account(
    0.08,
    {
        "off_screen": 0.07,
        "missed_lens": 0.03,
        "left_side": 0.57,
        "total_reflection": 0.11,
        "fresnel_entrance": 0.12,
        "fresnel_exit": 0.02,
    },
)
STATED = (
    "Only 8.0 % of the light lands on the screen; 57 % leaves by the side: a thinner lens, or a "
    "source farther away or nearer to the axis, keeps it."
)


@pytest.fixture
def desk(qtbot, session, as_run):
    """A document whose runs lose light as a test says."""
    owner = QObject()
    owner.document = Document(session, "small")
    owner.document.setParent(owner)
    owner.control, owner.messages = RunControl(owner.document, owner), MessageBar()

    def lose(account):
        def run(scene, target, start=None, locked=None):
            for shot in as_run(2)(scene, target):
                yield replace(shot, state=replace(shot.state, account=account))
            return "all iterations are done"

        owner.control.runner._generate = run
        with qtbot.waitSignal(owner.control.ended):
            owner.control.start()

    owner.lose = lose
    LostLightNotice(owner.document, owner.control, owner.messages)
    qtbot.addWidget(owner.messages)
    yield owner
    owner.control.close()
    owner.deleteLater()


def test_notice_names_the_cure_and_goes_with_the_lens(desk):
    desk.lose(LOST)
    assert desk.messages.text == STATED
    desk.document.undo_stack.undo()
    assert desk.messages.text == ""
