"""The axis of a train: straight from vertex to vertex, folded at mirrors.

It tells from which side light comes to elements and receivers.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from workbench.arrays import Array
from workbench.scene.diffuser import Diffuser
from workbench.scene.element import Element
from workbench.scene.mirror import Mirror
from workbench.scene.receiver import AnyReceiver
from workbench.scene.screen import Screen

if TYPE_CHECKING:
    from workbench.scene.source import Source


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
    if isinstance(receiver, Screen):
        return receiver.position - last.in_scene(np.array([0.0, 0.0, last.leaving_z]))
    return outgoing(last, incoming(source, elements)[-1])
