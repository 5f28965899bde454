"""How a design is looked at: docks, camera, colours; it travels in the session and is no edit."""

from collections.abc import Callable, Mapping
from typing import Any, Protocol

from ui.commands.actions import Commands
from ui.commands.menus import LOOK
from ui.window.layout import Layout
from ui.words import tr

_LAYOUT, _ON, _CAMERA = "layout", "on", "camera"


class CameraView(Protocol):
    """What has a camera."""

    def camera(self) -> dict[str, Any] | None:
        """Where it stands, as plain data; None before anything was seen."""

    def set_camera(self, camera: dict[str, Any]) -> None:
        """Look from there at the design of now; raises ValueError for what is no camera."""


class ViewState:
    """Written as a JSON object, and restored from one.

    Parameters
    ----------
    commands : Commands
        Those of `LOOK` that are on are part of it.
    layout : Layout
        The docks.
    tell : Callable
        Gets a sentence about what could not be restored.
    """

    def __init__(self, commands: Commands, layout: Layout, tell: Callable[[str], None]) -> None:
        self._commands, self._layout, self._tell = commands, layout, tell
        self._eye: CameraView | None = None
        self._waiting: Mapping[str, Any] | None = None  # for the views

    def to_data(self) -> dict[str, Any]:
        """The view of now."""
        if self._waiting is not None:  # nobody has seen another
            return dict(self._waiting)
        on = [name for name in LOOK if self._commands[name].isChecked()]
        data: dict[str, Any] = {_LAYOUT: self._layout.to_text(), _ON: on}
        camera = None if self._eye is None else self._eye.camera()
        return data if camera is None else {**data, _CAMERA: camera}

    def restore(self, data: Mapping[str, Any] | None) -> None:
        """Look at a design as ``data`` tells, as far as it can be understood."""
        self._waiting = None
        if data is None:
            return
        self._try("docks", lambda: self._layout.restore(_of_kind(data, _LAYOUT, str)))
        if self._eye is None:
            self._waiting = data
        else:
            self._restore_look(data, self._eye)

    def attach(self, eye: CameraView) -> None:
        """The views are there."""
        self._eye = eye
        if self._waiting is not None:
            self._restore_look(self._waiting, eye)
            self._waiting = None

    def _restore_look(self, data: Mapping[str, Any], eye: CameraView) -> None:
        self._try("choices", lambda: self._switch(_of_kind(data, _ON, list)))
        if _CAMERA in data:
            self._try("camera", lambda: eye.set_camera(_of_kind(data, _CAMERA, dict)))

    def _switch(self, on: list[Any]) -> None:
        for name in LOOK:
            action = self._commands[name]
            only_one = action.actionGroup() is not None  # is switched off by another
            if not (only_one and action.isChecked()):
                action.setChecked(name in on)

    def _try(self, what: str, restore: Callable[[], None]) -> None:
        try:
            restore()
        except ValueError as error:
            self._tell(
                tr("The {what} kept with this design cannot be shown again: {error}").format(
                    what=what, error=error
                )
            )


def _of_kind(data: Mapping[str, Any], key: str, kind: type[Any]) -> Any:
    value = data.get(key)
    if not isinstance(value, kind):
        raise ValueError(f"{key} is no {kind.__name__}")
    return value
