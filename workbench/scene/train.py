"""The train of a scene: its elements, its axis, and refusals of elements that make no train.

The axis is straight from vertex to vertex, and folded at mirrors. It states from which side light
comes to elements and receivers.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Self

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.element import DEFAULT_WAVELENGTH, Element
from workbench.scene.lens import Lens
from workbench.scene.mirror_diffuser import Diffuser, Mirror
from workbench.scene.part import Part
from workbench.scene.receiver import AnyReceiver
from workbench.scene.receivers import Screen
from workbench.scene.spline_face import PlacedFace

if TYPE_CHECKING:
    from workbench.scene.sources import Source
    from workbench.scene.task import Scene


def incoming(source: "Source", elements: Sequence[Element]) -> tuple[Array, ...]:
    """Return unit vectors (3,) along which light of a source comes to the elements of a train."""
    way, last = source.heading, source.place
    if last is None or elements[0].upright:  # which each source stands before
        last = elements[0].position
    found = []
    for element in elements:
        step = np.subtract(element.position, last)
        length = np.linalg.norm(step)
        way = step / length if length > 0 else way
        found.append(way)
        last = element.position
    return tuple(found)


def outgoing(element: Element, way: Array) -> Array:
    """Return the unit vector (3,) along which light leaves an element that it comes to."""
    if isinstance(element, Diffuser):
        return way
    normal = element.turn[:, 2]
    return way - 2 * (way @ normal) * normal if isinstance(element, Mirror) else normal


def leaving(source: "Source", elements: Sequence[Element], receiver: AnyReceiver) -> Array:
    """Return a vector (3,) along which light of a train comes to the middle of a receiver."""
    last = elements[-1]
    if receiver.stands_at is not None:
        return receiver.stands_at - last.in_scene(np.array([0.0, 0.0, last.leaving_z]))
    return outgoing(last, incoming(source, elements)[-1])


_MOST_ELEMENTS = 16
_ROUNDING = 1e-9

# Cosine below which light goes along a face.
_GRAZING = 1e-3

# Degrees from the z axis of the scene, from which a far field counts, to light of a train.
_SIDEWAYS = 60.0


def check_elements(scene: "Scene") -> None:
    """Refuse elements that cannot be computed with, or have no place in a train yet.

    Raises
    ------
    Refused
        With the path of the field in the scene, the value and what is allowed.
    """
    if len(scene.elements) > _MOST_ELEMENTS:
        raise too_many("elements", len(scene.elements), _MOST_ELEMENTS)
    names = [element.name for element in scene.elements]
    for number, name in enumerate(names):
        if name in names[:number]:
            twice = Message("'{name}' is the name of another element; another name", name=name)
            raise Refused(f"elements[{number}].name", twice)
    if not any(element.free for element in scene.elements):
        raise Refused("elements", Message("no face is designed; one face of shape 'bspline'"))
    for number in range(len(scene.elements)):
        _check_element(scene, number)
    _check_diffuser(scene)


def check_bends(scene: "Scene") -> None:
    """Refuse a run that asks for bends of faces that have none between their edges."""
    for name, value in scene.run.bends.items():
        for focused in scene.focused:
            if focused.optic.free and min(focused.optic.degree) < 2:
                raise Refused(
                    f"run.{name}",
                    Message(
                        "{value:g} is about curvature, and faces of degree 1 are flat between "
                        "edges; {field} of at least 2",
                        value=value,
                        field=f"{focused.face_path()}.degree",
                    ),
                )


def check_receivers(scene: "Scene", receivers: Sequence[AnyReceiver]) -> None:
    """Refuse receivers that may touch the last element of a train, or get no light of it.

    Raises
    ------
    Refused
        With the place of the receiver, and what is possible.
    """
    last = scene.elements[-1].lit(scene.source.wavelength)
    for receiver in receivers:
        place = receiver.stands_at
        if place is None:
            way = leaving(scene.source, scene.elements, receiver)
            angle = math.degrees(math.acos(min(abs(float(way[2])), 1.0)))
            if angle > _SIDEWAYS:
                raise Refused(
                    "images",
                    Message(
                        "light leaves {name} at {angle:.0f} degrees from the z axis, too far for a "
                        "far field; at most {most:g}, or a plane",
                        name=last.name,
                        angle=angle,
                        most=_SIDEWAYS,
                    ),
                )
        elif not last.designed:
            _check_beyond(last, outgoing(last, scene.ways[-1]), receiver, place)


def _check_beyond(last: Element, onwards: Array, receiver: AnyReceiver, place: Array) -> None:
    """Refuse a receiver, with its middle at a place, that has not all of an element before it."""
    ahead = (place - last.corners) @ receiver.across
    reach = (place - last.in_scene(np.array([0.0, 0.0, last.leaving_z]))) @ onwards
    if reach > 0 and (ahead.min() > 0 or ahead.max() < 0):
        return
    if receiver.upright and last.upright and onwards[2] > 0:
        raise Refused(
            "images",
            Message(
                "a receiver at z = {z:g} may touch the element {name}; more than {least:g}",
                z=float(place[2]),
                name=last.name,
                least=float(place[2] - ahead.min()),
            ),
        )
    raise Refused(
        "images",
        Message(
            "a receiver at {place} may touch the element {name}, or gets none of its light; "
            "farther along the light, and across it",
            place="[{}]".format(", ".join(f"{each:g}" for each in place)),
            name=last.name,
        ),
    )


def too_many(path: str, count: int, most: int) -> Refused:
    """Return the refusal of more parts than there may be."""
    return Refused(path, Message("{count} are given; at most {most}", count=count, most=most))


def _check_element(scene: "Scene", number: int) -> None:
    path = f"elements[{number}]"
    element = scene.elements[number].lit(scene.source.wavelength)
    try:
        element.check_element()
    except Refused as refused:
        if refused.path.startswith("source."):  # a wavelength beyond the data of a material
            raise
        raise Refused(f"{path}.{refused.path}", refused.reason) from None
    if number or not element.upright:  # the source sees to the rest
        _check_side(path, element, scene.ways[number])
    if number:
        _check_order(scene, number, element)


def _check_side(path: str, element: Element, way: Array) -> None:
    """Refuse light that comes to the back of a lens, or of a mirror that the design shapes."""
    cosine = float(way @ element.turn[:, 2])
    if cosine > _GRAZING or not (isinstance(element, Lens) or element.designed):
        return
    back = Message(
        "light comes to the back of {name}, at {angle:.0f} degrees from its z; less than 90, as "
        "where it is turned by 180 degrees about its x",
        name=element.name,
        angle=math.degrees(math.acos(max(cosine, -1.0))),
    )
    raise Refused(f"{path}.tilt", back)


def _check_diffuser(scene: "Scene") -> None:
    """Refuse elements behind a diffuser, and receivers that a Lambertian one cannot light.

    Directions behind a diffuser are many, and an image of them is a convolution on the receiver
    alone. Behind a Lambertian diffuser, that holds for planes parallel to it; in the far field its
    light is the same for all lenses.
    """
    for number, element in enumerate(scene.elements[:-1]):
        if isinstance(element, Diffuser):
            raise Refused(
                f"elements[{number + 1}]",
                Message(
                    "'{name}' is behind the diffuser {diffuser}; move the diffuser to the end",
                    name=scene.elements[number + 1].name,
                    diffuser=element.name,
                ),
            )
    last = scene.elements[-1]
    if not isinstance(last, Diffuser) or last.scatter.about_ray:
        return
    across = last.turn[:, 2]
    for number, receiver in enumerate(scene.receivers):
        if not isinstance(receiver, Screen):
            raise Refused(
                f"images[{number}].receiver.kind",
                Message(
                    "behind a Lambertian diffuser all lenses make the same far field; 'plane', or "
                    "{field}: 'gaussian'",
                    field=f"elements[{len(scene.elements) - 1}].scatter.kind",
                ),
            )
        if abs(receiver.across @ across) < 1 - _ROUNDING:
            raise Refused(
                f"images[{number}].receiver.tilt",
                Message("not parallel to the Lambertian diffuser {name}; its tilt", name=last.name),
            )


def _check_order(scene: "Scene", number: int, element: Element) -> None:
    """Refuse an element that reaches into the one before it, or stands behind a mirror."""
    last = scene.elements[number - 1].lit(scene.source.wavelength)
    path, (_, _, z) = f"elements[{number}].position", last.seen(np.array(element.position))
    onwards = 1
    if isinstance(last, Mirror):
        onwards = -1 if scene.ways[number - 1] @ last.turn[:, 2] > 0 else 1
    least, front = last.position[2], 0.0
    if isinstance(last, Lens):
        least += last.thickness
    if np.array_equal(last.turn, element.turn):  # side by side along one axis
        front = element.front_z - element.position[2]
        least = last.highest if last.designed else last.leaving_z
    if onwards * (z + front - least) >= -_ROUNDING * max(element.half_width):
        return
    if last.upright and onwards > 0:
        raise Refused(
            f"{path}[2]",
            Message(
                "{z:g} reaches into {name}; at least {least:g}",
                z=element.position[2],
                name=last.name,
                least=least - front,
            ),
        )
    raise Refused(
        path,
        Message(
            "{place} is not where light of {name} goes; {by:g} farther along its axis",
            place="[{}]".format(", ".join(f"{each:g}" for each in element.position)),
            name=last.name,
            by=-onwards * (z + front - least),
        ),
    )


class Train(Part):
    """The elements of a scene, as its light meets them."""

    if TYPE_CHECKING:  # the scene has these fields, at their places in the file
        source: "Source"
        elements: tuple[Element, ...]

    @property
    def designed_numbers(self) -> tuple[int, ...]:
        """Indices of the elements that the design shapes, in the order of the light."""
        return tuple(number for number, each in enumerate(self.elements) if each.designed)

    @property
    def designed_number(self) -> int:
        """Index of the last element of which the design shapes a face."""
        numbers = self.designed_numbers
        return ([number for number in numbers if self.elements[number].free] or numbers)[-1]

    @property
    def fixed_faces(self) -> frozenset[str]:
        """Ids of the B-spline faces that the design leaves as they are."""
        return frozenset(
            placed.name for element in self.elements for placed, _ in element.fixed_faces
        )

    @property
    def focused(self) -> tuple[Self, ...]:
        """The scene for each element that the design shapes, the other elements left undesigned."""
        numbers = self.designed_numbers
        if len(numbers) == 1:
            return (self,)
        fixed = [each.undesigned if each.designed else each for each in self.elements]
        return tuple(
            self.model_copy(update={"elements": (*fixed[:k], self.elements[k], *fixed[k + 1 :])})
            for k in numbers
        )

    @property
    def optic(self) -> Element:
        """The last element that the design shapes, as the source's light meets it."""
        return self.elements[self.designed_number].lit(self.source.wavelength)

    @property
    def optics(self) -> tuple[Element, ...]:
        """All elements that the design shapes, as the source's light meets them."""
        return tuple(self.elements[k].lit(self.source.wavelength) for k in self.designed_numbers)

    def focused_on(self, name: str) -> Self:
        """The one of `focused` for an element, by its name or by the id of one of its faces.

        The scene itself if the design shapes no element of that name.
        """
        name = name.partition(".")[0]
        return next((each for each in self.focused if each.optic.name == name), self)

    def face_in_words(self, face: str) -> Message:
        """What a designed face is called within a sentence, by its id."""
        optic = self.focused_on(face).optic
        words = Message(optic.face_in_words(face))
        if len(self.designed_numbers) == 1:
            return words
        return Message("{face} of {element}", face=words, element=optic.name)

    @property
    def first(self) -> Element:
        """The element that light meets first: its outline is the aperture of all light."""
        return self.elements[0].lit(self.source.wavelength)

    @property
    def behind(self) -> tuple[Element, ...]:
        """The elements behind the designed one, as the source's light meets them."""
        elements = self.elements[self.designed_number + 1 :]
        return tuple(each.lit(self.source.wavelength) for each in elements)

    @property
    def ways(self) -> tuple[Array, ...]:
        """Unit vectors (3,) along which light comes to the elements; see `train.incoming`."""
        return incoming(self.source, self.elements)

    def onwards(self, receiver: AnyReceiver) -> int:
        """1 if light comes to a receiver along its own +z, -1 if it comes against it."""
        if receiver.turn is not None:
            return 1
        way = leaving(self.source, self.elements, receiver)
        return 1 if way @ receiver.across > 0 else -1

    def with_optic(self, optic: Element) -> Self:
        """Return the scene with another element in place of `optic`, which goes with all else."""
        return self.with_element(self.designed_number, optic)

    def with_element(self, number: int, element: Element) -> Self:
        """Return the scene with another element in place of the one with an index."""
        elements: list[Element] = list(self.elements)
        elements[number] = element.lit(DEFAULT_WAVELENGTH)
        return self.model_copy(update={"elements": tuple(elements)})

    @property
    def optic_path(self) -> str:
        """Path of `optic` in the scene."""
        return f"elements[{self.designed_number}]"

    def face_path(self, name: str | None = None) -> str:
        """Path of a face in the scene, by its id; by default that of the last face of `optic`."""
        number, placed = self._placed(name or self.optic.designed_face)
        return f"elements[{number}].{placed.path}"

    def _placed(self, face: str) -> tuple[int, PlacedFace]:
        """Index of the element of a face, and where the face stands, by its id."""
        return next(
            (number, placed)
            for number, element in enumerate(self.elements)
            for placed in element.placed_faces
            if placed.name == face
        )

    def element_of(self, face: str) -> Element:
        """Return the element of a face, by the id of the face."""
        return self.elements[self._placed(face)[0]]
