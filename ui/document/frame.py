"""What the window is shown of a run: one snapshot, ready to draw."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ui.words import tr
from workbench.arrays import Array
from workbench.design.lens_state import LensState
from workbench.design.snapshot import History, Result, Snapshot
from workbench.files.session import KeptRun, Session
from workbench.powers import written
from workbench.scene import AnyReceiver, Scene, Source

if TYPE_CHECKING:
    from workbench.optics.paths import RayPaths

_SURFACE_SAMPLES = (65, 65)

RAYS = 45
"""Rays of a frame along each axis; odd, so that the middle one is among them."""


@dataclass(frozen=True, eq=False)
class Frame:
    """A snapshot of a run and what has to be computed to draw it."""

    session: Session
    snapshot: Snapshot
    surfaces: dict[str, Array]
    source: Source
    paths: "RayPaths"
    result: Result

    @property
    def state(self) -> LensState:
        return self.snapshot.state

    def of_image(self, number: int) -> "Frame":
        if len(self.session.scene.images) == 1:
            return self
        session = self.session.of_image(number)
        state = self.state.of_image(number, session.target)
        return replace(self, session=session, snapshot=replace(self.snapshot, state=state))


def make_frame(session: Session, snapshot: Snapshot, history: History) -> Frame:
    """Sample the faces and trace the rays of a snapshot; for the worker's thread."""
    # Late: torch comes with it, and the window shows before that.
    from workbench.geometry.surface import sample_faces
    from workbench.optics.paths import ray_paths

    scene, heights = session.scene, snapshot.state.heights
    source = scene.source_of(snapshot.stage)
    lit = scene.model_copy(update={"source": source})
    return Frame(
        session=session,
        snapshot=snapshot,
        surfaces=sample_faces(scene.optics, heights, _SURFACE_SAMPLES),
        source=source,
        paths=ray_paths(lit, heights, (RAYS, RAYS)),
        result=history.ended_with(snapshot),
    )


def some_rays(paths: "RayPaths", count: int) -> "RayPaths":
    """Return an even selection of `RAYS` × `RAYS` rays, with the middle one; or none."""
    chosen = np.zeros((RAYS, RAYS), dtype=bool)
    if count:
        step = RAYS // count
        chosen[step // 2 :: step, step // 2 :: step] = True
    kept = chosen.ravel()
    return type(paths)(paths.points[kept], paths.weight[kept], paths.on_screen[kept])


def same_task(one: Session, other: Session) -> bool:
    """Whether both sessions have the same task, apart from the run."""
    if one is other:
        return True
    same = one.scene.model_copy(update={"run": other.scene.run}) == other.scene
    return same and one.target is other.target


def same_lens(one: Frame, other: Frame) -> bool:
    """Whether two frames show the same lens for the same task."""
    alike = same_task(one.session, other.session)
    return alike and one.state.heights == other.state.heights


def same_light(one: Frame, other: Frame) -> bool:
    """Whether two frames show the same lens in the same light."""
    return one.state.heights == other.state.heights and lit_alike(one.session, other.session)


def lit_alike(one: Session | KeptRun, other: Session | KeptRun) -> bool:
    """Whether both tasks give a lens the same image and target; run and regions are ignored."""
    beside = {"run": other.scene.run, "regions": other.scene.regions}
    return one.scene.model_copy(update=beside) == other.scene and (
        one.target is other.target or np.array_equal(one.target, other.target)
    )


def shows(frame: Frame, session: Session) -> bool:
    """Whether a frame shows the task of a session and its lens; without one, no lens of a run."""
    lens = session.result
    if lens is None:
        return not iterations_before(frame) and lit_alike(frame.session, session)
    return lens.state.heights == frame.state.heights and lit_alike(frame.session, session)


def iterations_before(frame: Frame) -> int:
    """Iterations before a frame, those of a continued run included."""
    return frame.result.iterations


def image_titles(*scenes: Scene) -> list[str]:
    """Return number and position of each image of the scenes.

    A scene with fewer images repeats its last one; differing positions are joined by an arrow.
    """
    most = max(len(scene.receivers) for scene in scenes)
    titles = []
    for number in range(most):
        places = [_place(scene.receivers[: number + 1][-1], scene.unit) for scene in scenes]
        place = " → ".join(dict.fromkeys(places))
        titles.append(tr("Image {number}, {place}").format(number=number + 1, place=place))
    return titles


def _place(receiver: AnyReceiver, unit: str) -> str:
    if receiver.at_distance:
        return f"z = {written(receiver.plane_z, unit)}"
    return tr(receiver.called)
