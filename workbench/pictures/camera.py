"""The camera of the 3D scene, and what it has to hold.

It projects in parallel by default: a screen fifty lens widths away is then as easy to
see as the lens.
"""

import math
from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.scene import Element, Scene

VIEWS = {
    "side": ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "top": ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0)),
    "axis": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
    "screen": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),  # which then stands before the lens
}
"""Directions towards the camera and up in the picture, by name of the view."""

_UP = (0.0, 1.0, 0.0)
_PLACES = ("position", "focal_point", "up")
_FARTHEST = 3.0  # times the larger of screen's distance and width: a source in view
_MARGIN = 1.12
_LEAST_SEEN = 0.5  # part of the height that is fitted into, whatever is hidden of it
_STEEPEST = 85.0  # degrees above or below, when the camera is turned
# Degrees from the axis, and above it, of a look at lens and screen, and of one at the lens alone.
_AZIMUTH, _LENS_AZIMUTH, _ELEVATION = 58.0, 40.0, 22.0
_CLEAR = 2.0  # degrees between the outlines of lens and screen
_FLATTEST = 80.0  # degrees from the axis; farther round, a lens near its screen shows no face


class FittedCamera:
    """Turns a plotter's camera so that a scene is seen whole.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Its camera is moved; nothing is rendered.
    scene : Scene
        What is seen.
    perspective : bool
        Whether what is farther away looks smaller.

    Attributes
    ----------
    view : str
        The view that was fitted last.
    hidden : int
        Pixels at the lower edge where something else is seen, which `fit` leaves free.
    top : float
        Greatest z of the exit face as it is drawn.
    """

    def __init__(self, plotter: Any, scene: Scene, *, perspective: bool = False) -> None:
        self._plotter = plotter
        self._scene = scene
        self._perspective = perspective
        self._left: tuple[object, ...] = ()
        self.view, self.hidden = "", 0
        self.top = first_top(scene.optic)

    def fit(self, view: str) -> None:
        """Turn the camera and fit everything, or a part of it, into what it sees.

        Parameters
        ----------
        view : str
            "side", "top" or "axis" for everything; "lens" or "screen" for that alone, from a side
            where the other does not hide it; "entrance" for the lens from where its light comes;
            else the three-quarter view.
        """
        self.view = view
        corners = self._corners(view)
        toward, up = map(np.array, VIEWS.get(view, (self._oblique(view), _UP)))
        right = np.cross(up, toward)
        right /= np.linalg.norm(right)
        frame = np.stack([right, np.cross(toward, right), toward])
        seen = corners @ frame.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        half = (high - low) / 2
        centre = (low + high) / 2 @ frame
        width, height = self._plotter.window_size
        self._plotter.renderer.camera.is_set = True  # else its first use draws the scene twice
        camera = self._plotter.camera
        part = max(1 - self.hidden / max(height, 1), _LEAST_SEEN)
        scale = _MARGIN * max(half[1] / part, half[0] * height / max(width, 1))
        camera.focal_point = centre - (1 - part) * scale * frame[1]
        camera.up = up
        camera.parallel_scale = scale
        # In perspective, what is nearest to the camera has to fit.
        self._stand(toward, nearer=float(half[2]))
        self._left = self._state()

    def project(self, perspective: bool) -> None:
        """Change the projection; what is as far as the focal point stays as large as it looks."""
        if perspective == self._perspective:
            return
        untouched, camera = self.untouched, self._plotter.camera
        self._perspective = perspective
        if not perspective:
            camera.parallel_scale = camera.distance * _half_height(camera)
        self._stand(-np.array(camera.direction))
        if untouched:
            self._left = self._state()

    def turn(self, right: float, up: float) -> None:
        """Go around the focal point, degrees to the right and up.

        What is up stays up: the camera never comes to look straight down on it.
        """
        camera = self._plotter.camera
        camera.Azimuth(right)
        above = math.degrees(math.asin(np.clip(-np.dot(camera.direction, camera.up), -1, 1)))
        camera.Elevation(min(max(above + up, -_STEEPEST), _STEEPEST) - above)
        self._plotter.renderer.ResetCameraClippingRange()

    def move(self, right: float, up: float) -> None:
        """Go beside what is seen, in parts of its height; the direction stays."""
        camera = self._plotter.camera
        direction = np.array(camera.direction)
        across = np.cross(direction, camera.up)
        across /= np.linalg.norm(across)
        height = 2 * camera.parallel_scale
        if self._perspective:
            height = 2 * camera.distance * _half_height(camera)
        by = height * (right * across + up * np.cross(across, direction))
        camera.focal_point = np.array(camera.focal_point) + by
        camera.position = np.array(camera.position) + by
        self._plotter.renderer.ResetCameraClippingRange()

    def zoom(self, factor: float, about: Array | None = None) -> None:
        """See everything so many times as large.

        Parameters
        ----------
        factor : float
            Larger than 1 to come nearer.
        about : ndarray, shape (3,), optional
            The point that stays where it is in the picture, and about which the camera turns more
            and more; by default the focal point.
        """
        camera = self._plotter.camera
        focal, position = np.array(camera.focal_point), np.array(camera.position)
        about, part = focal if about is None else about, 1 - 1 / factor
        by = part * (about - focal)
        camera.focal_point = focal + by
        if self._perspective:
            camera.position = position + part * (about - position)
        else:
            camera.position = position + by
            camera.parallel_scale /= factor
        self._plotter.renderer.ResetCameraClippingRange()

    def _corners(self, view: str) -> Array:
        """What a view has to hold, (n, 3)."""
        if view in ("lens", "entrance"):
            return _on_optic(self._scene.optic, self.top)
        if view == "screen":
            return _on_receiver(self._scene)
        optic = self._scene.optic
        return np.concatenate([space(self._scene), _on_optic(optic, self.top), axes_of(optic)])

    def _oblique(self, view: str) -> Array:
        """Unit vector towards a camera beside the axis and above it, where the light goes.

        That is beyond the exit face of a lens, and before a mirror, whose back shows nothing.
        The longer the way of the light, the closer to the axis: it then looks about two and a half
        times as long as the widest of source, lens and screen, however long it is.
        """
        onwards = self._scene.optic.onwards
        if view == "entrance":
            return _direction(math.radians(_LENS_AZIMUTH), math.radians(_ELEVATION), -1)
        clear = self._clear_azimuth()
        if view == "lens":
            azimuth = max(math.radians(_LENS_AZIMUTH), clear)
            return _direction(azimuth, math.radians(_ELEVATION), onwards)
        low, high = space(self._scene).min(axis=0), space(self._scene).max(axis=0)
        length, width = high[2] - low[2], max(high[:2] - low[:2])
        azimuth = math.asin(min(math.sin(math.radians(_AZIMUTH)), 2.4 * width / length))
        azimuth = max(azimuth, min(clear, math.radians(_FLATTEST)))
        drop = 0.45 * width / (length * math.cos(azimuth))
        elevation = math.asin(min(math.sin(math.radians(_ELEVATION)), drop))
        return _direction(azimuth, elevation, onwards)

    def _clear_azimuth(self) -> float:
        """Angle from the axis from which on the screen hides nothing of the lens, radians.

        In parallel projection; in perspective, lines of sight spread the two further apart.
        """
        places = _on_receiver(self._scene)
        wide = self._scene.optic.half_width[0] + float(np.abs(places[:, 0]).max())
        apart = self._scene.optic.onwards * (places[:, 2] - self.top)
        across = math.atan2(wide, float(apart.min()))
        return min(across + math.radians(_CLEAR), math.pi / 2)

    def _stand(self, toward: Array, nearer: float = 0.0) -> None:
        """Stand in a direction from the focal point, as far as the projection wants it."""
        camera, corners = self._plotter.camera, space(self._scene)
        distance = 1.5 * float(np.linalg.norm(np.ptp(corners, axis=0)))
        if self._perspective:
            distance = nearer + camera.parallel_scale / _half_height(camera)
        camera.parallel_projection = not self._perspective
        camera.position = np.array(camera.focal_point) + toward * distance
        self._plotter.renderer.ResetCameraClippingRange()

    def placement(self) -> dict[str, Any]:
        """Where the camera stands, as plain data for `place`."""
        if self.untouched:
            return {"fitted": self.view}
        camera = self._plotter.camera
        places = {key: [float(x) for x in getattr(camera, key)] for key in _PLACES}
        return {**places, "scale": float(camera.parallel_scale)}

    def place(self, placement: dict[str, Any]) -> None:
        """Stand at the place that `placement` gave.

        Raises
        ------
        ValueError
            If that is no place for a camera; see `check_placement`.
        """
        check_placement(placement)
        if "fitted" in placement:
            self.fit(placement["fitted"])
            return
        camera = self._plotter.camera
        for key in _PLACES:
            setattr(camera, key, tuple(placement[key]))
        camera.parallel_scale = placement["scale"]
        self._plotter.renderer.ResetCameraClippingRange()

    @property
    def untouched(self) -> bool:
        """Whether the camera is where `fit` left it."""
        return self._left == self._state()

    def _state(self) -> tuple[object, ...]:
        camera = self._plotter.camera
        return camera.position, camera.focal_point, camera.up, camera.parallel_scale


def check_placement(placement: dict[str, Any]) -> None:
    """Find out whether a camera can stand there.

    Raises
    ------
    ValueError
        If something is missing, is no finite number, or if there is no direction to look into.
    """
    if "fitted" in placement:
        if not isinstance(placement["fitted"], str):
            raise ValueError("the name of a view is text")
        return
    try:
        position, focal_point, up = (np.array(placement[key], dtype=float) for key in _PLACES)
        scale = float(placement["scale"])
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{error} is needed, in numbers") from error
    shapes_fit = all(place.shape == (3,) for place in (position, focal_point, up))
    if not (shapes_fit and np.isfinite([*position, *focal_point, *up, scale]).all()):
        raise ValueError("three finite numbers are needed for each place")
    if not (scale > 0 and np.cross(position - focal_point, up).any()):
        raise ValueError("there is no direction to look into")


def _half_height(camera: Any) -> float:
    """Half of what a perspective camera sees upright, at a distance of 1."""
    return math.tan(math.radians(camera.view_angle / 2))


def in_view(scene: Scene) -> bool:
    """Whether the source stands where a picture can show it together with the lens."""
    source, optic = scene.source, scene.optic
    places = _on_receiver(scene)
    width = 2 * max(*optic.half_width, float(np.abs(places[:, :2]).max()))
    farthest = _FARTHEST * max(float(places[:, 2].max()) - optic.front_z, width)
    return optic.front_z - source.nearest_z <= farthest


def start_z(scene: Scene) -> float:
    """Where rays begin to be drawn."""
    source, optic = scene.source, scene.optic
    if source.place is None:
        return optic.front_z - 0.5 * max(optic.half_width)
    if in_view(scene):
        return source.nearest_z
    return optic.front_z - 2.0 * max(optic.half_width)


def space(scene: Scene) -> Array:
    """What a picture has to hold: corners of the source, of the lens and of the screen, (n, 3)."""
    optic, source = scene.optic, scene.source
    before = optic.front_z - 0.5 * max(optic.half_width)
    corners = [_corners(optic.half_width, before), _on_optic(optic, first_top(optic))]
    corners.append(_on_receiver(scene))
    if in_view(scene):
        corners.append(source.seen((2, 2)))
    return np.concatenate(corners)


def first_top(optic: Element) -> float:
    """Greatest z of the exit face where it begins."""
    return optic.base.extent(optic.half_width)[1]


def _on_optic(optic: Element, top: float) -> Array:
    """Corners of a lens, or of a mirror with its plate, whose exit face comes up to ``top``."""
    return _corners(optic.half_width, optic.front_z, top, optic.flat_z(np.array(top)))


def _on_receiver(scene: Scene) -> Array:
    """Where all receivers are drawn, (n, 3)."""
    outlines = [receiver.outline(scene.optic) for receiver in scene.receivers]
    return np.concatenate([outline.reshape(-1, 3) for outline in outlines])


def _direction(azimuth: float, elevation: float, along: int) -> Array:
    """Unit vector at angles from the axis, to the left of it, and above it; radians.

    ``along`` is 1 where that is the axis +z, -1 where it is -z.
    """
    return np.array(
        [
            -math.sin(azimuth) * math.cos(elevation),
            math.sin(elevation),
            along * math.cos(azimuth) * math.cos(elevation),
        ]
    )


def axes_of(optic: Element) -> Array:
    """Where the axes that are drawn beside an optic meet, and the names of x, y and z, (4, 3)."""
    length, (r_x, r_y) = 0.5 * max(optic.half_width), optic.half_width
    origin = np.array([-1.1 * r_x, -1.1 * r_y, optic.lowest - length])
    return np.asarray(origin + np.concatenate([np.zeros((1, 3)), 1.25 * length * np.eye(3)]))


def _corners(half_width: tuple[float, float], *heights: float) -> Array:
    """Corners of rectangles about the axis, (n, 3)."""
    (r_x, r_y) = half_width
    return np.array([[i * r_x, j * r_y, z] for z in heights for i in (-1, 1) for j in (-1, 1)])
