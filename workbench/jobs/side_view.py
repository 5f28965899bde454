"""Side view of a scene to scale: rays, lens or mirror, image, widths and distances."""

from dataclasses import dataclass, replace

import numpy as np

from workbench.arrays import Array
from workbench.powers import written
from workbench.scene import Scene

_RAYS = 5
_BEFORE = 0.25  # length of collimated rays before the element, of the whole length


@dataclass(frozen=True, eq=False)
class Dimension:
    """A length between two places."""

    ends: Array  # (2, 2), along the axis and across it
    text: str
    distance: bool = False  # between parts; else the size of a part


@dataclass(frozen=True, eq=False)
class SideView:
    """Points (to the right, upwards) in the plane of the axis, scene units.

    To the right is along the axis, or across the image where it is tilted before a lens.
    """

    across: str  # the axis that is drawn upwards
    source: Array  # (n, 2), ends of a line, a point, or none for collimated light
    optic: Array  # (n, 2), outline of the element
    receiver: Array  # (n, 2), the image, seen edge on
    rays: tuple[Array, ...]  # (3, 2) each, from the source to the image
    dimensions: tuple[Dimension, ...]

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Least and greatest coordinate along the axis, and across it."""
        ends = [dimension.ends for dimension in self.dimensions]
        points = np.concatenate([self.source, self.optic, self.receiver, *self.rays, *ends])
        low, high = points.min(axis=0), points.max(axis=0)
        return float(low[0]), float(high[0]), float(low[1]), float(high[1])

    def upright(self) -> "SideView":
        """Return the view turned until the image is upright, as a wall is."""
        side = self.receiver[-1] - self.receiver[0]
        along, up = side / np.linalg.norm(side)
        turn = np.array([[up, along], [-along, up]])
        return replace(
            self,
            source=self.source @ turn,
            optic=self.optic @ turn,
            receiver=self.receiver @ turn,
            rays=tuple(ray @ turn for ray in self.rays),
            dimensions=tuple(replace(each, ends=each.ends @ turn) for each in self.dimensions),
        )


def side_view(scene: Scene) -> SideView:
    """Draw a scene from the side, or from above where it is askew along x."""
    optic, receiver = scene.optic, scene.receiver
    axis = 0 if not receiver.mirrored[0] else 1
    plane = [2, axis]
    half = optic.half_width[axis]
    front, back = optic.front_z, optic.leaving_z
    if front == back:
        back = front + optic.onwards * -1 * half / 10
    outline = np.array([[front, -half], [back, -half], [back, half], [front, half], [front, -half]])
    steps = np.linspace(-1, 1, 2 * receiver.facets + 1)
    image = _seen(scene, axis, steps)[:, plane]
    source = scene.source.seen((2, 2))[:, plane]
    ends = _seen(scene, axis, np.linspace(-1, 1, _RAYS))[:, plane]
    places = np.stack([np.full(_RAYS, optic.leaving_z), half * np.linspace(-1, 1, _RAYS)], axis=-1)
    begin = _beginnings(scene, places, image, axis)
    rays = tuple(np.stack(each) for each in zip(begin, places, ends, strict=True))
    view = SideView(
        "xy"[axis], source, outline, image, rays, _dimensions(scene, axis, image, source)
    )
    return view.upright() if scene.optic.onwards > 0 and receiver.at_distance else view


def _seen(scene: Scene, axis: int, steps: Array) -> Array:
    """Points (n, 3) along the drawn side of the receiver."""
    receiver = scene.receiver
    coordinates = [np.full_like(steps, middle) for middle in receiver.middle]
    coordinates[axis] = receiver.middle[axis] + receiver.half_extent[axis] * steps
    return receiver.drawn(scene.optic, *coordinates)


def _beginnings(scene: Scene, places: Array, image: Array, axis: int) -> Array:
    source = scene.source
    if source.place is not None:
        return np.broadcast_to(np.array(source.place)[[2, axis]], places.shape)
    way = source.heading[[2, axis]]
    length = _BEFORE * float(np.ptp(np.append(image[:, 0], scene.optic.front_z)))
    return np.asarray(places - length * way / way[0])


def _dimensions(scene: Scene, axis: int, image: Array, source: Array) -> tuple[Dimension, ...]:
    optic, receiver, unit = scene.optic, scene.receiver, scene.unit
    half, front = optic.half_width[axis], optic.front_z
    sign = receiver.measure.sign_in(unit)
    found = [
        Dimension(np.array([[front, -half], [front, half]]), written(2 * half, unit)),
        Dimension(image[[0, -1]], written(2 * receiver.half_extent[axis], sign)),
    ]
    here = np.array([front, 0.0])
    if receiver.at_distance:
        found.append(_distance(here, _straight_to(here, image), unit))
    if len(source):
        found.append(_distance(np.array([source[:, 0].mean(), 0.0]), here, unit))
    return tuple(found)


def _distance(first: Array, last: Array, unit: str) -> Dimension:
    away = float(np.linalg.norm(last - first))
    return Dimension(np.stack([first, last]), written(away, unit), distance=True)


def _straight_to(here: Array, image: Array) -> Array:
    along = image[-1] - image[0]
    return np.asarray(image[0] + along * ((here - image[0]) @ along) / (along @ along))
