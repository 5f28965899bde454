"""What the window says, and offers, when a net is too coarse for its target."""

import pytest
from PySide6.QtCore import QObject, Qt

from ui.document.document import Document
from ui.run.control import RunControl
from ui.widgets.messages import MessageBar
from ui.window.run_notices import CoarseNetNotice
from workbench.design.snapshot import SLOW
from workbench.messages import Message
from workbench.scene import AutoNet

SLOW_RUN = Message(SLOW, gain=5, patience=5)


@pytest.fixture
def desk(qtbot, session, as_run):
    """A document whose runs converge with a high error."""
    owner = QObject()
    owner.document = Document(session, "small")
    owner.document.setParent(owner)
    owner.control, owner.messages = RunControl(owner.document, owner), MessageBar()
    owner.begun = []

    def design(why):
        def run(scene, target, start=None, locked=None):
            yield from as_run(2)(scene, target)
            return why

        owner.control.runner._generate = run
        with qtbot.waitSignal(owner.control.ended):
            owner.control.start()

    owner.design = design
    CoarseNetNotice(
        owner.document, owner.control, owner.messages, lambda: owner.begun.append("anew")
    )
    qtbot.addWidget(owner.messages)
    yield owner
    owner.control.close()
    owner.deleteLater()


def test_a_finer_net_is_offered_and_designed(desk, qtbot):
    desk.design(SLOW_RUN)
    assert "12 × 10 control points are too few for the detail of this target" in desk.messages.text
    (button,) = desk.messages.buttons
    assert button.text() == "Refine and start over"
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert isinstance(desk.document.session.scene.optic.control_points, AutoNet)
    assert desk.messages.text == "" and desk.begun == ["anew"]
