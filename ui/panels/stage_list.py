"""The stages of a run as a list, in their order."""

from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QListWidget, QToolButton, QVBoxLayout, QWidget

from ui.panels.editors import Wrapped
from ui.panels.edits import Edit
from ui.panels.fields import Row
from workbench.scene import Stage
from workbench.scene.kinds import title_of

_MOST_SEEN = 6  # stages; more are scrolled to


class StageListRow(Row):
    """The stages one below the other, and what can be done with them."""

    chosen = Signal()

    def __init__(self) -> None:
        super().__init__(
            "run.stages",
            "In turn",
            "A run goes through these stages before the scene itself, each going on from the lens "
            "of the one before: from a point source to an extended one, say, or from a coarse "
            "net to a fine one.",
        )
        self._stages: tuple[Stage, ...] = ()
        self._left = 0
        self._list = QListWidget()
        self._list.setAccessibleName("Stages of the run")
        self._list.setTextElideMode(Qt.TextElideMode.ElideRight)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._list.currentRowChanged.connect(lambda _: self.chosen.emit())
        self._rest = Wrapped()
        self._add_button = _button("Add", "Add a stage behind the others")
        self._remove_button = _button("Remove", "Remove the chosen stage")
        self._up_button = _button("Up", "Run the chosen stage sooner")
        self._down_button = _button("Down", "Run the chosen stage later")
        self._add_button.clicked.connect(self._append)
        self._remove_button.clicked.connect(self._drop)
        self._up_button.clicked.connect(lambda: self._move(-1))
        self._down_button.clicked.connect(lambda: self._move(1))
        buttons = QHBoxLayout()
        buttons.setSpacing(2)
        for button in (
            self._add_button,
            self._remove_button,
            self._up_button,
            self._down_button,
        ):
            buttons.addWidget(button)
        buttons.addStretch()
        content = QWidget()
        column = QVBoxLayout(content)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        column.addWidget(self._list)
        column.addWidget(self._rest)
        column.addLayout(buttons)
        self._add(content)
        self.setFocusProxy(self._list)

    @property
    def current(self) -> int:
        """Number of the chosen stage; −1 where there is none."""
        return self._list.currentRow()

    def concerns(self, path: str) -> bool:
        """Whether a refusal is about the stages as a whole; one stage has rows of its own."""
        return path == self.path

    def _is_there(self, scene: Any) -> bool:
        return True

    def show_stages(self, stages: tuple[Stage, ...], iterations: int) -> None:
        """Show the stages, and the iterations that they leave of all."""
        self._left = iterations - sum(stage.iterations for stage in stages)
        if stages != self._stages:
            self._stages = stages
            with QSignalBlocker(self._list):
                chosen = min(max(self.current, 0), len(stages) - 1)
                self._list.clear()
                for number, stage in enumerate(stages, start=1):
                    self._list.addItem(f"{number}.  {_summary(stage)}")
                    self._list.item(number - 1).setToolTip(_summary(stage))
                self._list.setCurrentRow(chosen)
        if stages:
            self._rest.say(f"Then the scene as it stands, {_iterations(self._left)}.")
            rows = min(len(stages), _MOST_SEEN)
            frame = 2 * self._list.frameWidth()
            self._list.setFixedHeight(rows * self._list.sizeHintForRow(0) + frame)
        else:
            self._rest.say("None: the scene is run as it stands.")
        self._list.setVisible(bool(stages))
        self._enable()

    def _enable(self) -> None:
        current, count = self.current, len(self._stages)
        self._remove_button.setEnabled(count > 0)
        self._up_button.setEnabled(current > 0)
        self._down_button.setEnabled(0 <= current < count - 1)

    def _append(self) -> None:
        """Half of what is left for the scene is a fair share; the scene refuses what is none."""
        new = Stage(iterations=max(1, self._left // 2))
        self._put([*self._stages, new], "new stage", len(self._stages))

    def _drop(self) -> None:
        current = self.current
        rest = [stage for number, stage in enumerate(self._stages) if number != current]
        self._put(rest, f"removal of stage {current + 1}", current)

    def _move(self, step: int) -> None:
        current, stages = self.current, list(self._stages)
        stages.insert(current + step, stages.pop(current))
        self._put(stages, f"move of stage {current + 1}", current + step)

    def _put(self, stages: list[Stage], text: str, chosen: int) -> None:
        data: list[dict[str, Any]] = [
            stage.model_dump(mode="json", exclude_none=True) for stage in stages
        ]
        self.edited.emit(Edit(self.path, text, {self.path: data}, alone=True))
        if self._stages == tuple(stages):  # not refused
            self._list.setCurrentRow(min(chosen, len(stages) - 1))


def _button(text: str, tip: str) -> QToolButton:
    button = QToolButton()
    button.setText(text)
    button.setToolTip(tip)
    button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # typed text is entered before it acts
    return button


def _iterations(count: int) -> str:
    return "1 iteration" if count == 1 else f"{count} iterations"


def _summary(stage: Stage) -> str:
    """What makes a stage different, in one line."""
    parts = [_iterations(stage.iterations)]
    if stage.method is not None:
        (method,) = (field for field in Stage.fields() if field.name == "method")
        parts.append(dict(method.choices)[stage.method].lower())
    if stage.control_points is not None:
        parts.append("net of {} × {}".format(*stage.control_points))
    if stage.source is not None:
        parts.append(title_of(type(stage.source)).lower())
    if stage.filter is not None:
        parts.append(f"{title_of(type(stage.filter)).lower()} filter")
    return ", ".join(parts)
