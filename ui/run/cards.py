"""Result cards: what came out, each with a goal and a button that mends it."""

import re
from collections.abc import Callable
from functools import partial
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ui.background import Background, Task
from ui.commands.actions import Commands
from ui.document.frame import Frame
from ui.run.control import RunControl
from ui.widgets.controls import STRETCH, filled, scrolled
from ui.widgets.labels import Veil, WrappedLabel
from ui.widgets.marks import Mark
from ui.words import in_sentence, later, tr
from workbench.design.session import Session, VerifiedError
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.report.findings import Attainable, Cure, Finding, Goal, Level


class Findings(QObject):
    """Finds in a thread what came out of the shown lens, and makes cures and goals edits."""

    found = Signal(object, object, bool)  # tuple of Finding, Scene, whether of the shown lens
    located = Signal(object, object)  # ControlHeights, points (n, 3)
    failed = Signal(str)
    edit_asked = Signal(str, object)  # text, mapping of paths to values
    command_asked = Signal(str)

    def __init__(
        self, control: RunControl, verified: Callable[[Frame], VerifiedError | None]
    ) -> None:
        super().__init__(control)
        self._control, self._verified = control, verified
        self._frame: Frame | None = None
        self._attainable: Attainable | None = None
        self._waiting: Cure | None = None  # for the end of a run
        self._background = Background(later("findings"), self, finish_first=True)
        self._background.done.connect(self._emit)
        self._background.failed.connect(self.failed)
        control.ended.connect(lambda: QTimer.singleShot(0, self, self._mend_waiting))

    def show_frame(self, frame: Frame) -> None:
        self._frame = frame
        self.refresh()

    def show_nothing(self, session: Session) -> None:
        self._frame = None
        self._background.cancel()
        self.found.emit((), session.scene, True)

    def use_bounds(self, attainable: "Attainable | None", sentence: str = "") -> None:
        self._attainable = attainable
        self.refresh()

    def refresh(self) -> None:
        frame = self._frame
        if frame is not None:
            rests = not (self._control.busy or self._control.followed)
            known = self._verified(frame), self._attainable, rests
            self._background.begin(partial(_found, frame, *known), frame)

    def mend(self, cure: "Cure") -> None:
        """Make the edits of a cure, after the end of a run, then trigger its command."""
        if cure.changes and self._control.busy:
            self._waiting = cure
            self._control.runner.stop()
            return
        if cure.changes:
            self.edit_asked.emit(in_sentence(tr(cure.text)), dict(cure.changes))
        if cure.command:
            self.command_asked.emit(cure.command)

    def set_goal(self, goal: "Goal", limit: float | None) -> None:
        self.edit_asked.emit(tr("goal"), {goal.path: limit})

    def _mend_waiting(self) -> None:
        cure, self._waiting = self._waiting, None
        if cure is not None:
            self.mend(cure)

    def _emit(self, frame: Frame, findings: "tuple[Finding, ...]") -> None:
        self.found.emit(findings, frame.session.scene, frame is self._frame)
        for finding in findings:
            if finding.places is not None:
                self.located.emit(frame.state.heights, finding.places)


def _found(
    frame: Frame,
    verified: VerifiedError | None,
    attainable: "Attainable | None",
    rests: bool,
    task: Task,
) -> "tuple[Finding, ...]":
    # Late: torch comes with it, and the window shows before that.
    from workbench.report.findings import UNKNOWN, findings

    known = attainable or UNKNOWN
    return findings(frame.session, frame.result, verified, known, search=rests)


_LEVELS: "dict[Level, str]" = later(
    {"good": "Good", "attention": "Needs attention", "bad": "Goal missed"}
)
_FIGURE = re.compile(r"^[\d.]++( %)?(?! ×)")  # at the beginning of a sentence


class _Card(QFrame):
    """One finding; the goal is a field that holds a limit, or nothing."""

    mended = Signal(object)  # Cure
    goal_set = Signal(object, object)  # Goal, float or None

    def __init__(self, goal: "Goal | None") -> None:
        super().__init__()
        self.setObjectName("card")
        self._goal = goal
        self._limit: float | None = None
        self._cure: Cure | None = None
        self.text = ""
        self.mark, self._sentence = (
            Mark("attention"),
            WrappedLabel(textFormat=Qt.TextFormat.RichText),
        )
        self._sentence.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.button = QPushButton()
        self.button.clicked.connect(lambda: self.mended.emit(self._cure))
        self.limit = QLineEdit(placeholderText=tr("none"))
        self.limit.setFixedWidth(self.limit.fontMetrics().horizontalAdvance("0") * 9)
        self.limit.editingFinished.connect(self._read)
        named = QLabel(tr("Goal") + (" ≤" if goal is not None and goal.at_most else " ≥"))
        named.setBuddy(self.limit)
        self.limit.setAccessibleName(tr("Goal"))
        most = "100 %" if goal is not None and goal.percent else "1"
        tip = tr("Type a limit, at most {most}; empty the field to remove the goal")
        self.limit.setToolTip(tip.format(most=most))
        for part in (named, self.limit):
            part.setVisible(goal is not None)
        below = filled(QHBoxLayout(), named, self.limit, STRETCH, self.button, spacing=6)
        beside = filled(QVBoxLayout(), self._sentence, below, spacing=6)
        row = filled(QHBoxLayout(self), self.mark, (beside, 1), margins=(8, 8, 8, 8), spacing=8)
        row.setAlignment(self.mark, Qt.AlignmentFlag.AlignTop)

    def show_finding(self, finding: "Finding", scene: Scene) -> None:
        text = tr(finding.sentence)
        if (text, finding.level) != (self.text, self.mark.sign):
            self.text = text
            self.mark.show_sign(finding.level)
            self.mark.setToolTip(tr(_LEVELS[finding.level]))
            self._sentence.setText(_FIGURE.sub(r"<b>\g<0></b>", escape(text), count=1))
            self.setAccessibleName(f"{tr(_LEVELS[finding.level])}: {text}")
        self._cure = finding.cure
        self.button.setText("" if finding.cure is None else tr(finding.cure.text))
        if self._goal is not None and not self.limit.isModified():
            self._limit = self._goal.of(scene)
            self.limit.setText(self._written(self._limit))

    def allow(self, commands: Commands) -> None:
        """Show the button if its command is available, or its edit can end a run."""
        cure = self._cure
        self.button.setVisible(
            cure is not None and (bool(cure.changes) or commands[cure.command].isEnabled())
        )

    def _read(self) -> None:
        assert self._goal is not None  # or there would be no field
        text = self.limit.text().replace("%", "").replace(",", ".").strip()
        try:
            limit = float(text) / (100 if self._goal.percent else 1) if text else None
        except ValueError:
            limit = self._limit
        if limit is not None and not 0 < limit <= 1:
            limit = self._limit
        self.limit.setText(self._written(limit))  # which is no modification
        if limit != self._limit:
            self._limit = limit
            self.goal_set.emit(self._goal, limit)

    def _written(self, limit: float | None) -> str:
        if limit is None or self._goal is None:
            return ""
        return f"{100 * limit:g} %" if self._goal.percent else f"{limit:g}"


class ResultCards(QWidget):
    """The findings as cards, greyed while they are of another design."""

    def __init__(self, findings: Findings, commands: Commands) -> None:
        super().__init__()
        self._findings, self._commands = findings, commands
        self.cards: dict[str, _Card] = {}
        self._inner = QWidget()
        self._column = filled(QVBoxLayout(self._inner), STRETCH, margins=6, spacing=6)
        filled(QVBoxLayout(self), scrolled(self._inner), margins=0)
        self._veil, self._outdated = Veil(self), False
        findings.found.connect(self._show)
        for name in ("start", "continue", "check"):
            commands[name].changed.connect(self._allow)

    def show_outdated(self, outdated: bool) -> None:
        """Grey the cards at once; new findings end that."""
        self._outdated = outdated
        if outdated:
            self._cover(True)
        else:
            self._findings.refresh()

    def _cover(self, covered: bool) -> None:
        self._inner.setEnabled(not covered)
        self._veil.cover(covered)

    def _show(self, findings: "tuple[Finding, ...]", scene: Scene, latest: bool) -> None:
        # Late: torch comes with it; it is there after a finding.
        from workbench.report.findings import GOALS

        for finding in findings:
            if finding.key not in self.cards:
                card = self.cards[finding.key] = _Card(GOALS.get(finding.key))
                card.mended.connect(self._findings.mend)
                card.goal_set.connect(self._findings.set_goal)
            self.cards[finding.key].show_finding(finding, scene)
        shown = [finding.key for finding in findings]
        for key, card in self.cards.items():
            card.setVisible(key in shown)
        for place, key in enumerate(shown):
            self._column.insertWidget(place, self.cards[key])
        self._allow()
        if latest and not self._outdated:
            self._cover(False)

    def _allow(self) -> None:
        for card in self.cards.values():
            card.allow(self._commands)
