"""What a person works on: a design task, the lens found for it, and what belongs to both."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, Protocol, Self

import numpy as np

from workbench import units
from workbench.arrays import Array
from workbench.design.lens_state import scaled
from workbench.design.limits import CLOSEST, HeightLimits, bounded
from workbench.design.net import definite
from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.geometry.approximation import project
from workbench.geometry.faces import NO_LOCKS, ControlHeights, FaceArrays, Locks
from workbench.geometry.surface import ControlNet, nets_of
from workbench.messages import Message
from workbench.scene import Scene, Unit
from workbench.scene.spline_face import heights_file

LONGEST_NAME = 100
"""Most characters in the name of a kept run."""


class VerifiedError(NamedTuple):
    """Error of a lens by an independent check; see `workbench.analysis.validation_figures`.

    Attributes
    ----------
    relative_l2_corrected : float
        Without the scatter of the check's own rays.
    relative_l2_corrected_interval : tuple[float, float]
        Where it lies with 95 % confidence.
    """

    relative_l2_corrected: float
    relative_l2_corrected_interval: tuple[float, float]


class Checked(Protocol):
    """What has the error that an independent check found."""

    @property
    def relative_l2_corrected(self) -> float:
        """Without the scatter of the check's own rays."""

    @property
    def relative_l2_corrected_interval(self) -> tuple[float, float]:
        """Where it lies with 95 % confidence."""


def _percent(fraction: float) -> str:
    return f"{100 * fraction:.2f} %" if fraction >= 1e-4 else f"{100 * fraction:.1g} %"


def verified_error(found: Checked, written: Callable[[float], str] = _percent) -> str:
    """What a check says of the lens itself: the scatter of its own rays is no error of a lens.

    Parameters
    ----------
    found : Checked
        Of the check.
    written : callable
        Writes a part of one.
    """
    low, high = found.relative_l2_corrected_interval
    if low == 0:  # with so few rays it may be none
        return f"< {written(high)}"
    return written(found.relative_l2_corrected)


@dataclass(frozen=True, eq=False)
class KeptRun:
    """A finished run, kept to be compared with others.

    Attributes
    ----------
    name : str
        What a person calls it; 1 to `LONGEST_NAME` characters.
    scene : Scene
        The task that it was given, with an absolute ``target.image``.
    target : ndarray, shape (n_y, n_x)
        The target image of that task.
    result : Result
        The lens that it found.
    verified : VerifiedError, optional
        The figures of a check of that lens.

    Raises
    ------
    Refused
        If the name is empty or too long.
    """

    name: str
    scene: Scene
    target: Array
    result: Result
    verified: VerifiedError | None = None

    def of_image(self, number: int) -> Self:
        """The run as if one of its images were the only one; 0 is the first.

        Where it has fewer, it is the last one. The figures of a check are those of the first.
        """
        number = min(number, len(self.scene.images) - 1)
        alone = Session(self.scene, self.target, self.result).of_image(number)
        return replace(
            self,
            scene=alone.scene,
            target=alone.target,
            result=result_of(alone),
            verified=None if number else self.verified,
        )

    def __post_init__(self) -> None:
        if not 1 <= len(self.name) <= LONGEST_NAME:
            raise Refused(
                "name",
                Message(
                    "it has {count} characters; 1 to {most} are needed",
                    count=len(self.name),
                    most=LONGEST_NAME,
                ),
            )


@dataclass(eq=False)
class Session:
    """A design task, and the lens found for it; `dataclasses.replace` makes a changed one.

    Attributes
    ----------
    scene : Scene
        The design task, with an absolute ``target.image``. Where it leaves the number of control
        points to the program, it is that of the lens that is there, or is chosen.
    target : ndarray, shape (n_y, n_x)
        The target image before normalisation and filtering, row 0 at +y.
    result : Result, optional
        The best lens so far; None before the first run.
    locked : Locks
        Control points of the finished lens whose heights a run leaves as they are.
    runs : tuple of KeptRun
        Runs kept to be compared, the oldest first.
    view : mapping, optional
        What the window looked like, as a JSON object; it means nothing to the engine.
    start : ControlHeights, optional
        Control heights of a lens that was designed for another task and is a start for this one;
        without meaning where there is a result.
    picture : bytes, optional
        Content of the target's image file as it was drawn, at most
        `workbench.design.task.LARGEST_PICTURE` bytes; none for a built-in shape.
    remarks : tuple of str
        What a person should know of the image file when the target was drawn; no file keeps it.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> session = open_design(path("examples", "tophat.json"))
    >>> in_inches = session.in_unit("inch")
    >>> round(in_inches.scene.receiver.z * 2.54, 6) == session.scene.receiver.z
    True
    """

    scene: Scene
    target: Array
    result: Result | None = None
    locked: Locks = NO_LOCKS
    runs: tuple[KeptRun, ...] = ()
    view: Mapping[str, Any] | None = None
    start: ControlHeights | None = None
    picture: bytes | None = None
    remarks: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.scene.optic.known_shape is None:
            there = (
                None if self.heights is None else self.heights[self.scene.optic.designed_face].shape
            )
            self.scene = _on_net(self.scene, self.target, there)

    @property
    def heights(self) -> ControlHeights | None:
        """Control heights of the lens as it stands: the result's, or those to start from."""
        return self.start if self.result is None else self.result.state.heights

    @property
    def pictures(self) -> tuple[bytes | None, ...]:
        """Content of the image file of each target that keeps it, the first one first."""
        return (self.picture, *(image.drawn.picture for image in self.scene.images[1:]))

    @property
    def picture_remarks(self) -> tuple[str, ...]:
        """What a person should know of the image file of each target, the first one first."""
        further = (image.drawn.remarks for image in self.scene.images[1:])
        return (*self.remarks, *(remark for remarks in further for remark in remarks))

    def of_image(self, number: int) -> "Session":
        """The session as if one of its images were the only one; 0 is the first.

        Its lens is still the one that was found for all of them.
        """
        if len(self.scene.images) == 1:
            return self
        scene, target, _ = self.scene.wanted(self.target)[number]
        result = self.result
        if result is not None:
            result = replace(result, state=result.state.of_image(number, target))
        return replace(self, scene=scene, target=target, result=result)

    def with_scene(self, scene: Scene, target: Array) -> "Session":
        """The session after an edit; what belongs to this task as well stays.

        Run settings say how to search, not what for, so changing them leaves the result, and so
        does a control net that holds the same surface, and limits that the lens is within. For any
        other task the lens is a start, if it has the same outline; on a net that cannot hold its
        surface it is the nearest one, and so it is within limits that it exceeds. Locks stay as
        long as the control points that they are about. A scene that is converted to another unit
        takes the lens along.
        """
        if self.heights is not None:
            scene = _with_fixed_heights(scene, self.scene, self.heights)
        # Locks are about the control points that are there.
        scene = _on_net(scene, target, self.scene.optic.net_shape if self.locked else None)
        unit = scene.unit
        if unit != self.scene.unit and target is self.target and scene == self.scene.in_unit(unit):
            return self.in_unit(unit)
        nets, others = nets_of(self.scene), nets_of(scene)
        kept = nets.keys() & others.keys()
        exact = all(others[face].contains(nets[face]) for face in kept)
        same_task = task_of(scene) == task_of(self.scene) and np.array_equal(target, self.target)
        result, start = self.result if exact and same_task else None, self.heights
        rises = {
            face: scene.element_of(face).position[2] - self.scene.element_of(face).position[2]
            for face in kept
        }
        if start is not None and any(rises.values()):  # heights go along with their element
            start = FaceArrays({face: z + rises.get(face, 0.0) for face, z in start.items()})
        if start is not None and others != nets:
            carry = ControlNet.refine if exact else project
            carried = {face: carry(nets[face], start[face], others[face]) for face in kept}
            limits = HeightLimits.of_scene(scene)
            new = {face: each.undesigned for face, each in limits.items() if face not in kept}
            start = FaceArrays(new | carried)
            result = result and result.with_state(heights=start)
        if any(others[face].half_width != nets[face].half_width for face in kept):
            result = start = None
        if start is not None and _limits(scene) != _limits(self.scene):
            within = _within(scene, start)
            result = _unhindered(result) if result is not None and within is start else None
            start = within
        if result is not None:
            start = None
        same_points = nets.keys() == others.keys() and all(
            (others[face].shape, others[face].degree) == (net.shape, net.degree)
            for face, net in nets.items()
        )
        return replace(
            self,
            scene=scene,
            target=target,
            result=result,
            start=start,
            locked=self.locked if same_points else NO_LOCKS,
            picture=self.picture if scene.image == self.scene.image else None,
        )

    def in_unit(self, unit: Unit) -> "Session":
        """The same session with all lengths in another unit: the lens stays the lens that it is.

        Kept runs stay in the unit of their own scenes.

        Raises
        ------
        Refused
            If a length of the scene would be beyond float64, or so small that it is 0.
        """
        factor = float(units.ratio(self.scene.unit, unit))
        densities = [receiver.density_in_unit(factor) for receiver in self.scene.receivers]
        result = self.result and replace(
            self.result, state=self.result.state.scaled(factor, densities)
        )
        start = None if self.start is None else scaled(self.start, factor)
        return replace(self, scene=self.scene.in_unit(unit), result=result, start=start)


def result_of(session: Session, name: str = "session") -> Result:
    """The lens of a session that was designed for its task.

    Parameters
    ----------
    session : Session
        The session.
    name : str
        What a refusal calls it.

    Raises
    ------
    Refused
        If there is none.
    """
    if session.result is not None:
        return session.result
    if session.start is None:
        raise Refused(name, Message("holds no lens yet; freeform design finds one"))
    raise Refused(
        name,
        Message(
            "its lens was designed for another task, which was edited "
            "afterwards; freeform design goes on from it"
        ),
    )


def _on_net(scene: Scene, target: Array, there: tuple[int, ...] | None) -> Scene:
    """A scene with a definite net: the one that is there, if that is good for it."""
    if scene.optic.known_shape is None and there is not None:
        n_u, n_v = there
        return scene.with_net((n_u, n_v))
    return definite(scene, target)


def _with_fixed_heights(scene: Scene, before: Scene, heights: ControlHeights) -> Scene:
    """A scene whose fixed faces without a file keep the control heights that are there."""
    given = {
        placed.name: element.position[2]
        for element in scene.elements
        for placed, face in element.fixed_faces
        if face.content is None and placed.name in heights
    }
    if given:  # else the nets may have yet to be chosen
        nets, others = nets_of(before), nets_of(scene)
        for name, z in given.items():
            if others[name] == nets[name]:
                scene = scene.with_fixed_heights(name, heights_file(heights[name] - z))
    return scene


_BESIDE_THE_LENS: dict[str, object] = {"run": None, "regions": ()}


def asked_of_the_lens(scene: Scene) -> Scene:
    """A scene without what says nothing of what a lens shall do: no scene to be designed."""
    return scene.model_copy(update=_BESIDE_THE_LENS | {"source": scene.source.of_any_flux})


def task_of(scene: Scene) -> tuple[Scene, float]:
    """What a result is one for: all but how it was searched for, where, and on which control net.

    A task of another size is the same one as long as its numbers are: no length has one of its own.
    """
    front_z = scene.optic.front_z
    for number in scene.designed_numbers:
        element = scene.elements[number]
        for placed in element.placed_faces:
            if placed.face.designed:
                free = {"control_points": None, "degree": None, "height_range": None}
                element = element.shaped(placed.name, **free)
        bounds = {name for name in ("max_thickness", "min_thickness") if hasattr(element, name)}
        element = element.model_copy(update=dict.fromkeys(bounds))
        scene = scene.with_element(number, element)
    task = asked_of_the_lens(scene).model_copy(update={"unit": None})
    return task, front_z


def _within(scene: Scene, heights: ControlHeights) -> ControlHeights:
    """Control heights within the limits of a scene; the same object where they are already."""
    limits = HeightLimits.of_scene(scene, CLOSEST)
    nearest = {face: limits[face].nearest(each) for face, each in heights.items()}
    same = all(nearest[face] is each for face, each in heights.items())
    return heights if same else FaceArrays(nearest)


def _unhindered(result: Result) -> Result:
    return result if result.state.shortfall is None else result.with_state(shortfall=None)


def _limits(scene: Scene) -> tuple[object, ...]:
    return tuple(
        (
            lens.height_range and (lens.height_range, lens.base),
            lens.entrance_range,
            lens.z_min,
            lens.z_max,
        )
        for lens in map(bounded, scene.focused)
    )
