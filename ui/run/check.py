"""Independent check of the shown lens."""

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.background import Background, Task
from ui.shown.frame import same_lens, shows
from ui.words import later, tr
from workbench.arrays import Array
from workbench.design.session import verified_error as verified_error
from workbench.powers import written

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.analysis.validation_figures import Validation
    from workbench.files.session import Session
    from workbench.geometry.faces import ControlHeights

RAYS = 4_000_000
"""Rays of a thorough check."""

ACCURACY = 1e-3
"""Relative error of the image by cells in a thorough check."""


@dataclass(frozen=True, eq=False)
class CheckedLens:
    """A lens to check."""

    session: "Session"
    heights: "ControlHeights"
    iterations: int = 0
    seconds: float = 0.0
    irradiance: Array | None = None
    further: tuple[Array, ...] = ()


def check(
    lens: CheckedLens, rays: int, threads: int | None, accuracy: float, task: Task
) -> "tuple[Validation, float | None] | None":
    """Check a lens in a thread; reports the finished fraction."""
    # Late: what it stands on is slow to import.
    from workbench.analysis.metrics import relative_l2
    from workbench.analysis.validation import validating

    scene, target = lens.session.scene, lens.session.target
    steps = validating(scene, target, lens.heights, rays, threads=threads, accuracy=accuracy)
    found = task.follow(steps, task.report)
    if found is None:
        return None
    own = lens.irradiance
    return found, None if own is None else relative_l2(found.irradiance, own)


class Check(QObject):
    """A check of the shown lens, dropped when another one is shown."""

    figures_changed = Signal(str)
    under_way_changed = Signal(bool)
    checked = Signal(object, object, object)  # CheckedLens, Validation, float
    summary_ready = Signal(str)
    failed = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._shown: Frame | None = None
        self._asked: Frame | None = None  # whose check goes on, or whose figures are shown
        self._rays = self._asked_rays = RAYS
        self._background = Background(later("check"), self)
        self._background.progressed.connect(self._tell_progress)
        self._background.done.connect(self._take)
        self._background.failed.connect(self._give_up)

    def show_frame(self, frame: "Frame") -> None:
        self._shown = frame
        if self._asked is not None and not same_lens(self._asked, frame):
            self._forget()

    def show_design(self, session: "Session") -> None:
        """Drop a lens of another design, and its check."""
        if self._shown is not None and not shows(self._shown, session):
            self._shown = None
        if self._asked is not None and not shows(self._asked, session):
            self._forget()

    def show_nothing(self, session: "Session") -> None:
        self._shown = None
        self._forget()

    def use_rays(self, rays: int) -> None:
        self._rays = rays

    def toggle(self) -> None:
        if self._background.busy:
            self._forget()
        elif self._shown is None:
            self.failed.emit(tr("The image is still being computed. Try again in a moment."))
        elif self._asked is None or self._asked_rays != self._rays:
            self.under_way_changed.emit(True)  # first: what follows shows its best lens, and rests
            self._asked, self._asked_rays = self._shown, self._rays
            self.figures_changed.emit(tr("checking…"))
            session, shot = self._shown.session, self._shown.snapshot
            lens = CheckedLens(
                session,
                shot.state.heights,
                irradiance=shot.state.irradiance,
                further=tuple(light.irradiance for light in shot.state.further),
            )
            self._background.begin(partial(check, lens, self._rays, None, ACCURACY), lens)

    def cancel(self) -> None:
        if self._background.busy:
            self._forget()

    def close(self) -> None:
        self._background.close()

    def _tell_progress(self, lens: CheckedLens, part: float) -> None:
        self.figures_changed.emit(tr("checking… {part:.0f} %").format(part=100 * part))

    def _take(self, lens: CheckedLens, outcome: "tuple[Validation, float]") -> None:
        found, difference = outcome
        failed = found.contradiction
        self.figures_changed.emit(
            tr("Check failed")
            if failed
            else tr("Verified error {verified}").format(verified=verified_error(found.verified))
        )
        self.under_way_changed.emit(False)
        self.checked.emit(lens, found, difference)
        if failed:
            self.failed.emit(tr(failed))
            return
        low, high = found.verified.relative_l2_corrected_interval
        self.summary_ready.emit(
            tr(
                "Check with {rays:,} rays: relative L2 error {verified} ({low:.2f} to {high:.2f} "
                "%); with ray noise {relative_l2:.2f} ± {noise:.2f} %, loss {loss}; "
                "{efficiency:.1f} % {place}"
            ).format(
                rays=found.rays,
                verified=verified_error(found.verified),
                low=100 * low,
                high=100 * high,
                relative_l2=100 * found.relative_l2,
                noise=100 * found.noise,
                loss=written(found.loss),
                efficiency=100 * found.efficiency,
                place=tr(lens.session.scene.receiver.place),
            )
        )

    def _give_up(self, sentence: str) -> None:
        self._forget()
        self.failed.emit(sentence)

    def _forget(self) -> None:
        self._asked = None
        self._background.cancel()
        self.figures_changed.emit("")
        self.under_way_changed.emit(False)
