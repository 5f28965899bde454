"""Camera of the 3D view.

The default projection is parallel: a screen fifty lens widths away is as easy to see as the lens.
"""

import math
from itertools import product
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from workbench.arrays import Array
from workbench.geometry.face_grids import element_sides
from workbench.scene import Element, Scene

VIEWS = {
    "side": ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "top": ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0)),
    "axis": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
    "screen": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),  # the screen is drawn in front of the lens
    "+x": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "+y": ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0)),
    "+z": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
    "-x": ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "-y": ((0.0, -1.0, 0.0), (-1.0, 0.0, 0.0)),
    "-z": ((0.0, 0.0, -1.0), (0.0, 1.0, 0.0)),
}
"""Directions towards the camera and up, by name of the view."""

CameraState = tuple[Any, Any, Any, float]
"""Position, focal point, direction up (3,), and parallel scale."""

_UP = (0.0, 1.0, 0.0)
_POSITIONS = ("position", "focal_point", "up")
_FARTHEST = 3.0  # source distance shown, over the larger of screen distance and width
_MARGIN = 1.12
_LEAST_SEEN = 0.5  # least part of the height used for fitting, however much is hidden
_STEEPEST = 85.0  # degrees above or below, when the camera is turned
# Degrees from the axis and above it, for views of lens and screen and of the lens alone.
_AZIMUTH, _LENS_AZIMUTH, _ELEVATION = 58.0, 40.0, 22.0
_TURNS, _GAIN = 6, 0.2  # directions that are tried for a narrow window; what the last must gain
_CLEAR = 2.0  # degrees between the outlines of lens and screen
_SIDE = np.linspace(-1, 1, 9)  # places across a face, for its extent
# Degrees from the axis. Beyond, little is seen of a screen behind the lens: the view is from the
# source. Where none is clear, as beside a screen, it is from the side.
_FLAT, _SIDEWAYS = 65.0, 80.0


class FittedCamera:
    """Camera of a plotter, fitted to a scene; it renders nothing.

    `view`: the last fitted view; `hidden`: height in pixels of the lower part of the window that
    `fit` leaves free; `tops`: greatest z of the last face of each designed element as drawn, by
    name; `optic`: the designed element that the views "lens" and "entrance" show.
    """

    def __init__(self, plotter: Any, scene: Scene, *, perspective: bool = False) -> None:
        self._plotter = plotter
        self._scene = scene
        self._perspective = perspective
        self._fitted_state: tuple[object, ...] = ()
        self.view, self.hidden = "", 0
        self.tops = {optic.name: base_top(optic) for optic in scene.optics}
        self.optic = scene.optic

    def choose(self, name: str) -> None:
        """Let views show another element, by its name or by the id of one of its faces."""
        self.optic = self._scene.focused_on(name).optic

    def fit(self, view: str) -> None:
        """Turn the camera to a view and fit its corners into the window.

        "side", "top", "axis" and the signed axes show everything. "lens" and "screen" show one of
        the two from a side where the other does not hide it, "entrance" shows the lens from the
        source. Other names give the three-quarter view.
        """
        self.view = view
        corners = self._corners(view)
        toward, up = map(np.array, VIEWS.get(view, (self._oblique(view), _UP)))
        frame = _frame((toward, np.zeros(3), up, 1.0)).T
        seen = corners @ frame.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        half = (high - low) / 2
        centre = (low + high) / 2 @ frame
        height = self._plotter.window_size[1]
        self._plotter.renderer.camera.is_set = True  # else its first use draws the scene twice
        camera = self._plotter.camera
        part = max(1 - self.hidden / max(height, 1), _LEAST_SEEN)
        scale = self._scale(half, part)
        camera.focal_point = centre - (1 - part) * scale * frame[1]
        camera.up = up
        camera.parallel_scale = scale
        # In perspective the nearest object has to fit.
        self._set_position(toward, nearer=float(half[2]))
        self._fitted_state = self.state()

    def hold(self) -> None:
        """Count as placed by a person until the next `fit`."""
        self._fitted_state = ()

    def project(self, perspective: bool) -> None:
        """Change the projection; objects at the focal point keep their size."""
        if perspective == self._perspective:
            return
        untouched, camera = self.untouched, self._plotter.camera
        self._perspective = perspective
        if not perspective:
            camera.parallel_scale = camera.distance * _half_height(camera)
        self._set_position(-np.array(camera.direction))
        if untouched:
            self._fitted_state = self.state()

    def turn(self, right: float, up: float) -> None:
        """Turn about the focal point by degrees to the right and up."""
        camera = self._plotter.camera
        camera.Azimuth(right)
        above = math.degrees(math.asin(np.clip(-np.dot(camera.direction, camera.up), -1, 1)))
        camera.Elevation(min(max(above + up, -_STEEPEST), _STEEPEST) - above)
        self._plotter.renderer.ResetCameraClippingRange()

    def move(self, right: float, up: float) -> None:
        """Shift the camera sideways by parts of the picture's height."""
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
        """Magnify by a factor about a point (3,), by default the focal point."""
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
        if view in ("lens", "entrance"):
            return _on_optic(self.optic, self.tops[self.optic.name])
        if view == "screen":
            return _on_receiver(self._scene)
        optics = self._scene.optics
        drawn = [_on_optic(optic, self.tops[optic.name]) for optic in optics]
        return np.concatenate([scene_corners(self._scene), *drawn])

    def _oblique(self, view: str) -> Array:
        onwards = self.optic.onwards
        from_source = _direction(math.radians(_LENS_AZIMUTH), math.radians(_ELEVATION), -1)
        if view == "entrance":
            return from_source
        clear = self._clear_azimuth()
        if view == "lens":
            azimuth = max(math.radians(_LENS_AZIMUTH), clear)
            return _direction(azimuth, math.radians(_ELEVATION), onwards)
        low, high = scene_corners(self._scene).min(axis=0), scene_corners(self._scene).max(axis=0)
        length, width = high[2] - low[2], max(high[:2] - low[:2])
        azimuth = math.asin(min(math.sin(math.radians(_AZIMUTH)), 2.4 * width / length))
        if math.radians(_FLAT) < clear < math.pi / 2:
            return from_source
        clear = min(clear, math.radians(_SIDEWAYS))
        corners, best, least = self._corners(view), np.zeros(3), math.inf
        for turned in np.linspace(0, 1, _TURNS):
            along = max(azimuth, clear) * (1 - turned) + clear * turned
            drop = 0.45 * width / (length * math.cos(along))
            elevation = math.asin(min(math.sin(math.radians(_ELEVATION)), drop))
            toward = _direction(along, elevation, onwards)
            half = np.ptp(corners @ _frame((toward, np.zeros(3), _UP, 1.0)), axis=0) / 2
            scale = self._scale(half) * (1 + _GAIN * turned)
            if scale < least:
                best, least = toward, scale
        return best

    def _scale(self, half: Array, part: float = 1.0) -> float:
        """Half the height that is seen where half-widths and half-heights (2,) fit in."""
        width, height = self._plotter.window_size
        return float(_MARGIN * max(half[1] / part, half[0] * height / max(width, 1)))

    def _clear_azimuth(self) -> float:
        places = _on_receiver(self._scene)
        optic = self.optic
        wide = optic.half_width[0] + float(np.abs(places[:, 0]).max())
        apart = optic.onwards * (places[:, 2] - self.tops[optic.name])
        across = math.atan2(wide, float(apart.min()))
        return min(across + math.radians(_CLEAR), math.pi / 2)

    def _set_position(self, toward: Array, nearer: float = 0.0) -> None:
        camera, corners = self._plotter.camera, scene_corners(self._scene)
        distance = 1.5 * float(np.linalg.norm(np.ptp(corners, axis=0)))
        if self._perspective:
            distance = nearer + camera.parallel_scale / _half_height(camera)
        camera.parallel_projection = not self._perspective
        camera.position = np.array(camera.focal_point) + toward * distance
        self._plotter.renderer.ResetCameraClippingRange()

    def placement(self) -> dict[str, Any]:
        """Return the camera's position as plain data for `place`."""
        if self.untouched:
            return {"fitted": self.view}
        camera = self._plotter.camera
        places = {key: [float(x) for x in getattr(camera, key)] for key in _POSITIONS}
        return {**places, "scale": float(camera.parallel_scale)}

    def place(self, placement: dict[str, Any]) -> None:
        """Move the camera to a position from `placement`; raise ValueError if it is invalid."""
        check_placement(placement)
        if "fitted" in placement:
            self.fit(placement["fitted"])
            return
        camera = self._plotter.camera
        for key in _POSITIONS:
            setattr(camera, key, tuple(placement[key]))
        camera.parallel_scale = placement["scale"]
        self._plotter.renderer.ResetCameraClippingRange()

    def state(self) -> CameraState:
        """Return where the camera is."""
        camera = self._plotter.camera
        return camera.position, camera.focal_point, camera.up, camera.parallel_scale

    def fly(self, start: CameraState, end: CameraState, part: float) -> None:
        """Move the camera to a part, from 0 to 1, of the way between two states."""
        if part < 1:
            (turned,) = Slerp([0, 1], Rotation.from_matrix([_frame(start), _frame(end)]))([part])
            right_up_toward = turned.as_matrix()
            lengths = [math.dist(position, focal) for position, focal, *_ in (start, end)]
            focal = (1 - part) * np.array(start[1]) + part * np.array(end[1])
            distance = (1 - part) * lengths[0] + part * lengths[1]
            position = focal + distance * right_up_toward[:, 2]
            end = position, focal, right_up_toward[:, 1], start[3] ** (1 - part) * end[3] ** part
        camera = self._plotter.camera
        camera.position, camera.focal_point, camera.up, camera.parallel_scale = end
        self._plotter.renderer.ResetCameraClippingRange()

    @property
    def untouched(self) -> bool:
        """Whether the camera is where the last `fit` put it."""
        return self._fitted_state == self.state()


def check_placement(placement: dict[str, Any]) -> None:
    """Raise ValueError if the data of `FittedCamera.placement` is invalid."""
    if "fitted" in placement:
        if not isinstance(placement["fitted"], str):
            raise ValueError("the name of a view is text")
        return
    try:
        position, focal_point, up = (np.array(placement[key], dtype=float) for key in _POSITIONS)
        scale = float(placement["scale"])
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{error} is needed, in numbers") from error
    shapes_fit = all(place.shape == (3,) for place in (position, focal_point, up))
    if not (shapes_fit and np.isfinite([*position, *focal_point, *up, scale]).all()):
        raise ValueError("three finite numbers are needed for each place")
    if not (scale > 0 and np.cross(position - focal_point, up).any()):
        raise ValueError("there is no direction to look into")


def _frame(state: CameraState) -> Array:
    """Matrix (3, 3) whose columns are the directions right, up and towards the camera."""
    toward = np.subtract(state[0], state[1])
    toward /= np.linalg.norm(toward)
    right = np.cross(state[2], toward)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(toward, right), toward], axis=1)


def _half_height(camera: Any) -> float:
    return math.tan(math.radians(camera.view_angle / 2))


def source_in_view(scene: Scene) -> bool:
    """Whether a picture can show the source together with the element."""
    source, first = scene.source, scene.first
    places = _on_receiver(scene)
    width = 2 * max(*first.half_width, float(np.abs(places[:, :2]).max()))
    farthest = _FARTHEST * max(float(places[:, 2].max()) - first.front_z, width)
    return first.front_z - source.nearest_z <= farthest


def drawn_start_z(scene: Scene) -> float:
    """Return z where drawn rays start."""
    source, first = scene.source, scene.first
    if source.place is None:
        return first.front_z - 0.5 * max(first.half_width)
    if source_in_view(scene):
        return source.nearest_z
    return first.front_z - 2.0 * max(first.half_width)


def scene_corners(scene: Scene) -> Array:
    """Return the corners (n, 3) of source, elements and receivers."""
    source, first = scene.source, scene.first
    before = first.front_z - 0.5 * max(first.half_width)
    corners = [_corners(first.half_width, before), *map(box_around, scene.elements)]
    corners.append(_on_receiver(scene))
    if source_in_view(scene):
        corners.append(source.seen((2, 2)))
    return np.concatenate(corners)


def base_top(optic: Element) -> float:
    """Greatest z of the exit face's base."""
    return optic.base.extent(optic.half_width)[1]


def _on_optic(optic: Element, top: float) -> Array:
    heights = optic.front_z, top, optic.flat_z(np.array(top))
    return optic.in_scene(_corners(optic.half_width, *heights))


def box_around(element: Element) -> Array:
    """Corners (8, 3) of a box around an element."""
    points = np.concatenate(element_sides(element, _SIDE, _SIDE, {})).reshape(-1, 3)
    return np.array(list(product(*zip(points.min(axis=0), points.max(axis=0), strict=True))))


def _on_receiver(scene: Scene) -> Array:
    outlines = [receiver.outline(scene.elements[-1]) for receiver in scene.receivers]
    return np.concatenate([outline.reshape(-1, 3) for outline in outlines])


def _direction(azimuth: float, elevation: float, along: int) -> Array:
    return np.array(
        [
            -math.sin(azimuth) * math.cos(elevation),
            math.sin(elevation),
            along * math.cos(azimuth) * math.cos(elevation),
        ]
    )


def _corners(half_width: tuple[float, float], *heights: float) -> Array:
    (r_x, r_y) = half_width
    return np.array([[i * r_x, j * r_y, z] for z in heights for i in (-1, 1) for j in (-1, 1)])
