"""The lens that a person sees: what is exported and reported, and saved while a run goes on."""

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.run.kept import called
from ui.words import later, tr
from workbench.design.origin import origin

if TYPE_CHECKING:
    from ui.run.control import RunControl
    from ui.shown.frame import Frame
    from workbench.design.snapshot import Result
    from workbench.files.session import Session

NO_LENS = later(
    "There is no result yet, or its light is still being traced; try again in a moment."
)


class LensOnShow(QObject):
    """Knows the lens of the document, also of another task or one that is being designed."""

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._control: RunControl | None = None
        self._preview: Frame | None = None

    def follow(self, control: "RunControl") -> None:
        """See the runs and previews of the document."""
        self._control = control
        control.runner.frame_ready.connect(self._take)

    @property
    def in_the_making(self) -> "Result | None":
        """The best lens so far of a run that goes on."""
        return None if self._control is None else self._control.runner.best

    @property
    def session(self) -> "Session | None":
        """The design with the lens on show as its result; None where there is no lens yet.

        A lens that was designed for another task has the light of this one, as it is shown.
        """
        session = self._document.session
        making = self.in_the_making
        if making is not None:
            return replace(session, result=making)
        if session.result is not None:
            return session
        heights, frame = session.heights, self._preview
        if heights is None or frame is None or frame.session is not session:
            return None
        return replace(session, result=frame.result.with_state(heights=heights))

    @property
    def text(self) -> str:
        """What it is, and the task that it was designed for; empty where there is no lens yet."""
        making, session = self.in_the_making, self._document.session
        optic = session.scene.optic.called
        if making is not None:
            return tr("the best {optic} so far, after {count} iterations", optic=optic).format(
                count=making.iterations
            )
        return (
            ""
            if session.heights is None
            else tr("the {optic} on show, {origin}", optic=optic).format(
                origin=tr(origin(session, called))
            )
        )

    def _take(self, frame: "Frame") -> None:
        self._preview = frame
