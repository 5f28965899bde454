"""What the window says of total reflection in a finished lens."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.run.control import RunControl
from ui.window.run_notices import TotalReflectionNotice
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account


@pytest.fixture
def desk(qtbot, session, as_run):
    owner = QObject()
    owner.document = Document(session, "small")
    owner.document.setParent(owner)
    owner.control, owner.spots, owner.stated = RunControl(owner.document, owner), [], []
    x, _ = ControlNet.of(session.scene.optic).positions
    rise = 1.2 * np.clip(x - 0.3, 0, None)[:, None] * np.ones((12, 10))

    def end(share):
        def run(scene, target, start=None, locked=None):
            for shot in as_run(2)(scene, target):
                account = Account(1 - share, {"total_reflection": share})
                heights = FaceArrays({"lens.back": 0.5 + rise})
                yield replace(shot, state=replace(shot.state, account=account, heights=heights))
            return "all iterations are done"

        owner.control.runner._generate = run
        with qtbot.waitSignal(owner.control.ended):
            owner.control.start()

    owner.end = end
    owner.notice = TotalReflectionNotice(owner.document, owner.control)
    owner.notice.located.connect(lambda *spots: owner.spots.append(spots))
    owner.notice.reported.connect(owner.stated.append)
    yield owner
    owner.notice.close()
    owner.control.close()
    owner.deleteLater()


def test_total_reflection_is_reported_and_marked_where_it_is(desk, qtbot):
    desk.end(0.2)
    qtbot.waitUntil(lambda: bool(desk.stated), timeout=60_000)
    (sentence,) = desk.stated
    assert (
        "% of the light is totally reflected at the exit face, most of it around x = " in sentence
    )
    assert "as marked in the 3D scene: thicker stock" in sentence
    ((heights, places),) = desk.spots
    assert heights == desk.document.session.heights and places[:, 0].min() > 0.1
    with qtbot.waitSignal(desk.notice.withdrawn, check_params_cb=lambda text: text == sentence):
        desk.document.undo_stack.undo()
