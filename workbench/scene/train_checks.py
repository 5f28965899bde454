"""Which elements make a train: refusals of those that cannot be computed with together."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from workbench.errors import Refused
from workbench.said import Said
from workbench.scene.element import Element
from workbench.scene.faces import ConicFace, SplineFace
from workbench.scene.lens import Lens
from workbench.scene.receiver import AnyReceiver
from workbench.scene.turning import tilted

if TYPE_CHECKING:
    from workbench.scene.task import Scene

_MOST_ELEMENTS = 16
_ROUNDING = 1e-9


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
            twice = Said("'{name}' is the name of another element; another name", name=name)
            raise Refused(f"elements[{number}].name", twice)
    if not any(element.designed for element in scene.elements):
        raise Refused("elements", Said("no face is designed; one face of shape 'bspline'"))
    for number in range(len(scene.elements)):
        _check_element(scene, number)


def check_behind(last: Element, receivers: Sequence[AnyReceiver]) -> None:
    """Refuse a receiver that may be within the last, fixed element of a train, or before it.

    Raises
    ------
    Refused
        With the z of the receiver, and the least.
    """
    turn = tilted(last.tilt)
    ends = [
        placed.z - last.position[2] + sag
        for placed in last.placed_faces
        for sag in (
            placed.face.extent(last.half_width) if isinstance(placed.face, ConicFace) else (0.0,)
        )
    ]
    reach = float(abs(turn[2, :2]) @ last.half_width)
    highest = last.position[2] + reach + max(float(turn[2, 2]) * end for end in ends)
    nearest = min(receiver.nearest_to(last) for receiver in receivers)
    if nearest <= highest:
        raise Refused(
            "images",
            Said(
                "a receiver at z = {z:g} may touch the element {name}; more than {least:g}",
                z=nearest,
                name=last.name,
                least=highest,
            ),
        )


def too_many(path: str, count: int, most: int) -> Refused:
    """Return the refusal of more parts than there may be."""
    return Refused(path, Said("{count} are given; at most {most}", count=count, most=most))


def _check_element(scene: "Scene", number: int) -> None:
    path, designed = f"elements[{number}]", scene.designed_number
    element = scene.elements[number].lit(scene.source.wavelength)
    try:
        element.check_element()
    except Refused as refused:
        if refused.path.startswith("source."):  # a wavelength beyond the data of a material
            raise
        raise Refused(f"{path}.{refused.path}", refused.reason) from None
    if number != designed and element.designed:
        raise Refused(path, Said("a second designed element; one element is designed"))
    if any(isinstance(each.face, SplineFace) and each.face.fixed for each in element.placed_faces):
        raise Refused(path, Said("fixed B-spline faces are not traced yet; a conic face"))
    if number != designed and not isinstance(element, Lens):
        raise Refused(path, Said("a mirror that is not designed is not traced yet"))
    if number > designed and scene.optic.onwards < 0:
        raise Refused(path, Said("elements behind a mirror are not traced yet; none"))
    upright = not any(element.tilt) and not any(element.position[:2])
    if number in (0, designed) and not upright:
        raise Refused(
            f"{path}.tilt" if any(element.tilt) else f"{path}.position",
            Said("the first and the designed element stand upright on the axis; 0"),
        )
    if number:
        _check_order(scene, number, element)


def _check_order(scene: "Scene", number: int, element: Element) -> None:
    """Refuse an element that reaches into the one before it."""
    last = scene.elements[number - 1].lit(scene.source.wavelength)
    least = last.highest if number - 1 == scene.designed_number else last.leaving_z
    if element.front_z < least - _ROUNDING * max(element.half_width):
        raise Refused(
            f"elements[{number}].position[2]",
            Said(
                "{z:g} reaches into {name}; at least {least:g}",
                z=element.position[2],
                name=last.name,
                least=least + element.position[2] - element.front_z,
            ),
        )
