"""Compass in a corner of the 3D view: the axes, and a ball to click for each direction."""

import weakref
from typing import Any

import numpy as np
import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkBillboardTextActor3D, vtkRenderer

from workbench.pictures.meshes import polylines

_AXES = (("X", "#d8504c"), ("Y", "#3f9a45"), ("Z", "#3d82d8"))
_DIRECTIONS = np.concatenate([np.eye(3), -np.eye(3)])
_NAMES = ("+x", "+y", "+z", "-x", "-y", "-z")  # of `camera.VIEWS`
_PART, _PIXELS = 0.16, (76, 170)  # of the lesser side of the picture; least and most
_SEEN = 1.35  # half of the height that its camera sees; balls are at 1
_BALL, _FONT, _LINE = 0.2, 0.13, 0.025  # in parts of the compass
_BACK = 90  # opacity of the balls of negative directions, of 255


class Compass:
    """Draws the compass on a plotter of the caller, in front of everything."""

    def __init__(self, plotter: Any) -> None:
        self._window, self._scene = plotter.ren_win, plotter.renderer
        self._renderer = vtkRenderer()
        self._renderer.SetLayer(1)
        self._renderer.InteractiveOff()
        self._window.SetNumberOfLayers(2)
        self._window.AddRenderer(self._renderer)
        colours = np.array(
            [(*pv.Color(colour).int_rgb, 255) for _, colour in _AXES], dtype=np.uint8
        )
        colours = np.concatenate([colours, colours])
        balls = pv.PolyData(_DIRECTIONS)
        arms = pv.PolyData(
            np.insert(_DIRECTIONS[:3], [0, 1, 2], 0.0, axis=0),
            lines=polylines([np.array([k, k + 1]) for k in (0, 2, 4)]),
        )
        arms.point_data["colour"] = np.repeat(colours[:3], 2, axis=0)
        colours[3:, 3] = _BACK
        balls.point_data["colour"] = colours
        self._props = [self._add(mesh) for mesh in (arms, balls)]
        self._props[1].style, self._props[1].render_points_as_spheres = "points", True
        self._labels = [self._label(name) for name, _ in _AXES]
        compass = weakref.ref(self)

        def follow(*_: object) -> None:
            if (present := compass()) is not None:
                present._follow()

        self._observer = self._scene.AddObserver("StartEvent", follow)

    def close(self) -> None:
        """Take the compass away."""
        self._scene.RemoveObserver(self._observer)
        self._window.RemoveRenderer(self._renderer)

    def show(self, shown: bool) -> None:
        """Draw it from the next rendering on, or not."""
        self._renderer.SetDraw(shown)

    def pick(self, x: float, y: float) -> str:
        """Return the view of the ball at a pixel from the lower left; "" if there is none."""
        width, height = self._window.GetSize()
        middle = np.array([width, height]) - self.side / 2
        right, up, toward = self._frame
        seen = np.stack([_DIRECTIONS @ right, _DIRECTIONS @ up], axis=-1) * self.side / 2 / _SEEN
        away = np.linalg.norm(seen + middle - (x, y), axis=1)
        near = away <= _BALL * self.side / 2
        if not near.any():
            return ""
        return _NAMES[int(np.where(near, _DIRECTIONS @ toward, -np.inf).argmax())]

    @property
    def side(self) -> int:
        """Width and height in pixels."""
        return int(np.clip(_PART * min(self._window.GetSize()), *_PIXELS))

    @property
    def _frame(self) -> tuple[Any, Any, Any]:
        camera = self._scene.GetActiveCamera()
        toward = -np.array(camera.GetDirectionOfProjection())
        right = np.cross(camera.GetViewUp(), toward)
        right /= np.linalg.norm(right)
        return right, np.cross(toward, right), toward

    def _follow(self) -> None:
        width, height = self._window.GetSize()
        side, (_, up, toward) = self.side, self._frame
        self._renderer.SetViewport(max(1 - side / width, 0), max(1 - side / height, 0), 1, 1)
        camera = self._renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(_SEEN)
        camera.SetPosition(*4 * toward)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(*up)
        camera.SetClippingRange(1, 8)
        arms, balls = self._props
        arms.line_width, balls.point_size = max(_LINE * side, 1.0), _BALL * side
        for label, place in zip(self._labels, _DIRECTIONS, strict=False):
            label.SetPosition(*place + 0.5 * toward)
            label.GetTextProperty().SetFontSize(round(_FONT * side))

    def _add(self, mesh: pv.PolyData) -> pv.Property:
        mapper = pv.DataSetMapper(mesh)
        mapper.SetColorModeToDirectScalars()
        mapper.scalar_visibility = True
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("colour")
        actor = pv.Actor(mapper=mapper)
        actor.prop.lighting = False
        self._renderer.AddActor(actor)
        prop: pv.Property = actor.prop
        return prop

    def _label(self, name: str) -> vtkBillboardTextActor3D:
        label = vtkBillboardTextActor3D()
        label.SetInput(name)
        text = label.GetTextProperty()
        text.SetColor(1, 1, 1)
        text.BoldOn()
        text.SetJustificationToCentered()
        text.SetVerticalJustificationToCentered()
        self._renderer.AddActor(label)
        return label
