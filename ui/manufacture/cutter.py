"""Asks how a face is cut by a ball cutter, and tells what the cut would leave."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QVBoxLayout,
    QWidget,
)

from ui.threads.background import Background, Task
from ui.threads.failure import sentence_of
from ui.widgets.wrapped_label import WrappedLabel
from ui.words import later, tr
from workbench.errors import Refused
from workbench.files.export.cutting import PLAIN, Cutting
from workbench.powers import written
from workbench.quantity import read_number

if TYPE_CHECKING:
    from workbench.files.session import Session

RAYS = 1_000_000
"""Through the cut; some ten seconds."""
_FEED = "mm/min"
_LENGTHS = later(
    {
        "tool_radius": (
            "Tool radius",
            "a radius that fits",
            "Radius of the ball. Left empty: that of the design task, or one that fits everywhere.",
        ),
        "scallop": (
            "Ridges",
            later("fine"),
            (
                "How high ridges between neighbouring cuts may be. Left empty: 1e-4 of "
                "the larger half-width, or higher where that takes more moves than a "
                "program can have."
            ),
        ),
        "rim": ("Clamping rim", "0", "Width of stock around the lens, to hold it by."),
        "safe_height": (
            "Travel height",
            "the ball's diameter",
            "How far over its highest cut the cutter travels.",
        ),
    }
)
_NEGLIGIBLE = 0.01  # a cut into the face of this part of the ridges' height is rounding
_ABOUT = later(
    "A finishing pass of a ball cutter as G-code in millimetres (GRBL, "
    "LinuxCNC). The cut is simulated before it is written: a cutter that "
    "leaves too much material standing, or cuts too deep, is refused."
)


class AskCutting:
    """Asks how a lens is cut, and begins with the last answer."""

    def __init__(self, window: QWidget) -> None:
        self._window = window
        self._last: tuple[str, Cutting] | None = None  # unit and answer

    def __call__(self, session: "Session") -> Cutting | None:
        """The answer; None if the lens shall not be cut."""
        unit = session.scene.unit
        last = self._last[1] if self._last is not None and self._last[0] == unit else PLAIN
        dialog = CutterDialog(session, last, self._window)
        try:
            if not dialog.exec():
                return None
            self._last = unit, dialog.cutting()
            return self._last[1]
        finally:
            dialog.deleteLater()


class CutterDialog(QDialog):
    """Fields of a cut, and what it would leave of a lens.

    Parameters
    ----------
    session : Session
        Has the lens.
    begin_with : Cutting
        What the fields hold at first.
    window : QWidget
        The dialog stands over it.
    """

    def __init__(self, session: "Session", begin_with: Cutting, window: QWidget) -> None:
        super().__init__(window)
        self.setWindowTitle(tr("Ball cutter"))
        self._session, self._unit = session, session.scene.unit
        self.fields = {name: QLineEdit() for name in _LENGTHS}
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for name, (title, empty, tip) in _LENGTHS.items():
            value = getattr(begin_with, name)
            self.fields[name].setText(f"{value:g}" if value else "")
            self._add(form, name, tr(title), tr(empty), tr(tip), self._unit)
        self.fields["feed"] = QLineEdit(f"{begin_with.feed:g}")
        self._add(
            form, "feed", tr("Feed"), "600", tr("How fast the cutter moves while it cuts."), _FEED
        )
        self.mould = QCheckBox(tr("Cut a mould of the face"))
        self.mould.setToolTip(
            tr("The negative: hollows become humps, turned over about the y axis.")
        )
        self.mould.setChecked(begin_with.negative)
        form.addRow("", self.mould)
        self.found = WrappedLabel()
        self.found.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.found.setAccessibleName(tr("What the cut leaves"))
        self.found.setMinimumHeight(4 * self.fontMetrics().lineSpacing())
        self.found.setAlignment(Qt.AlignmentFlag.AlignTop)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.write = buttons.addButton(tr("&Write G-code…"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.look = buttons.addButton(
            tr("&Simulate and trace"), QDialogButtonBox.ButtonRole.ActionRole
        )
        self.look.setToolTip(
            tr(
                "Simulate the cut and trace light through what it leaves, beside the "
                "lens as designed"
            )
        )
        self.look.clicked.connect(self.simulate)
        self.look.setDefault(True)
        buttons.accepted.connect(self._accept)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.addWidget(WrappedLabel(tr(_ABOUT)))
        column.addLayout(form)
        column.addWidget(self.found)
        column.addWidget(buttons)
        self.setMinimumWidth(46 * self.fontMetrics().averageCharWidth() + 120)
        self._goes_on = False  # whether the keyboard was at the button
        self._background = Background("simulate the cut", self)
        self._background.progressed.connect(lambda _, said: self.found.setText(said))
        self._background.done.connect(self._tell)
        self._background.failed.connect(
            lambda _, error: self._tell(None, sentence_of(error, tr("simulation of the cut")))
        )
        self.finished.connect(self._background.close)

    def cutting(self) -> Cutting:
        """What the fields say.

        Raises
        ------
        ValueError, Refused
            If one of them is no length, or they do not go together.
        """
        read = {name: self._number(name) for name in self.fields}
        feed, rim = read.pop("feed") or PLAIN.feed, read.pop("rim") or PLAIN.rim
        return Cutting(**read, rim=rim, feed=feed, negative=self.mould.isChecked())

    def simulate(self) -> None:
        """Simulate the cut in a thread, and trace what it leaves."""
        cutting = self._asked()
        if cutting is not None:
            self._goes_on = self.look.hasFocus()
            self.look.setEnabled(False)
            self.found.setText(tr("Simulating the cut…"))
            self._background.begin(partial(_look, self._session, cutting))

    def _add(
        self, form: QFormLayout, name: str, title: str, empty: str, tip: str, unit: str
    ) -> None:
        field = self.fields[name]
        field.setPlaceholderText(empty)
        field.setToolTip(f"<p>{tip}</p>")
        field.setAccessibleName(title)
        line = QHBoxLayout()
        line.addWidget(field, 1)
        line.addWidget(QLabel(unit))
        form.addRow(title, line)

    def _number(self, name: str) -> float | None:
        text = self.fields[name].text().strip()
        if not text:
            return None
        value = float(read_number(text, _FEED if name == "feed" else self._unit))
        if value < 0 or (value == 0 and name != "rim"):
            title = self.fields[name].accessibleName()
            allowed = tr("{value:g}; a number above 0, or nothing").format(value=value)
            raise ValueError(f"{title}: {allowed}")
        return value

    def _asked(self) -> Cutting | None:
        """What the fields say; None where that is refused, and then why."""
        try:
            return self.cutting()
        except (ValueError, Refused) as error:
            self.found.setText(f"\N{WARNING SIGN} {error}")
            return None

    def _accept(self) -> None:
        if self._asked() is not None:
            self.accept()

    def _tell(self, _: object, said: str) -> None:
        self.look.setEnabled(True)
        if self._goes_on:  # disabled, it gave the keyboard to Cancel, which Return would press
            self.look.setFocus()
        self.found.setText(said)


def _look(session: "Session", cutting: Cutting, task: Task) -> str | None:
    """Meant for the thread: what a cut leaves, in words; None if the work was left."""
    from workbench.analysis.cut_lens import tracing_cut  # late: take long to import
    from workbench.design.session import result_of
    from workbench.files.export.design import Design
    from workbench.files.export.gcode import planning

    result, unit = result_of(session), session.scene.unit
    plan = task.follow(planning(Design(session.scene, result, cutting=cutting)))
    if plan is None:
        return None
    cut_off, left, _ = plan.remains
    deep = tr("Up to {cut_off} is cut too deep").format(cut_off=written(cut_off, unit, 2))
    whole = cut_off < _NEGLIGIBLE * left
    lines = [
        tr(
            "Radius {radius}, {size:,} moves. {deep}; up to {left} of material is left standing, "
            "as ridges or where the ball does not fit."
        ).format(
            radius=written(plan.raster.radius, unit),
            size=plan.raster.tip.size,
            left=written(left, unit, 2),
            deep=tr("Nothing is cut too deep") if whole else deep,
        )
    ]
    if cutting.negative:
        return lines[0]
    task.report(f"{lines[0]}\n{tr('Tracing…')}")
    found = task.follow(
        tracing_cut(session.scene, result.state.heights, session.target, plan.raster, RAYS)
    )
    if found is None:
        return None
    return "\n".join([*lines, f"{tr(found.sentence)} {tr('Polishing takes ridges away.')}"])
