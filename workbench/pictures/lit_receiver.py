"""A receiver in three dimensions, painted with the light on it."""

from typing import Any, Protocol

import numpy as np
import pyvista as pv

from workbench.arrays import Array
from workbench.pictures import shapes
from workbench.pictures.images import LIGHT, full_scale, to_colours
from workbench.scene import AnyReceiver, Element, WantedImage

_TEXTURE_PIXELS = 512  # per axis; more than a view shows


class Add(Protocol):
    """Draws a mesh on a plotter."""

    def __call__(self, mesh: pv.PolyData, *, body: bool = False, **look: Any) -> Any:
        """The actor of the mesh; a body is what a look along a line of sight finds."""


class LitReceiver:
    """The plane of a receiver, or its part of a sphere, with a frame around it.

    Parameters
    ----------
    add : callable
        Draws a mesh.
    receiver : AnyReceiver
        As it is drawn.
    optic : Element
        What lights it.
    wanted : WantedImage
        The image there; the brightness is relative to its target at the light that arrives.

    Attributes
    ----------
    frame : Actor
        The frame.
    """

    def __init__(
        self, add: Add, receiver: AnyReceiver, optic: Element, wanted: WantedImage
    ) -> None:
        self._wanted = wanted
        corners = receiver.outline(optic)
        count = len(corners)
        plane = pv.PolyData(corners.reshape(-1, 3), faces=shapes.quads(count, count))
        # Texture rows count upwards in VTK: the last row of an image lies at its origin.
        steps = np.linspace(0, 1, count)
        plane.active_texture_coordinates = np.stack(
            np.meshgrid(steps, steps, indexing="ij"), axis=-1
        ).reshape(-1, 2)
        self._texels = pv.ImageData()
        self._texture = pv.Texture()
        self._texture.SetInputDataObject(self._texels)
        n_x, n_y = receiver.pixels
        self.paint(np.zeros((n_y, n_x)))
        add(plane, body=True, texture=self._texture, lighting=False)
        # A touch larger than the plane, which would swallow parts of it.
        around = shapes.rim(receiver.outline(optic, 1.004))
        rim = pv.PolyData(around, lines=[len(around), *range(len(around))])
        self.frame = add(rim, line_width=1.5, lighting=False)

    def paint(self, irradiance: Array, colours: str = LIGHT) -> None:
        """Show light, shape (n_y, n_x), in one of `workbench.pictures.maps.UNSIGNED`."""
        n_y, n_x = irradiance.shape
        thin = (slice(None, None, -(-n // _TEXTURE_PIXELS)) for n in (n_y, n_x))
        shown = irradiance[tuple(thin)]
        scene = self._wanted.scene
        top = full_scale(scene, self._wanted.target, scene.receiver.total(irradiance))
        texels = to_colours(shown, top, colours)[::-1]
        self._texels.dimensions = (texels.shape[1], texels.shape[0], 1)
        self._texels.point_data["colour"] = texels.reshape(-1, 3)
        self._texels.point_data.active_scalars_name = "colour"
        self._texels.Modified()
