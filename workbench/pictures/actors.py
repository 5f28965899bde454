"""Actors of the 3D view: point markers, colour bar, receiver."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pyvista as pv
from matplotlib import colormaps
from matplotlib.font_manager import findfont
from pyvista import Color
from vtkmodules.vtkCommonCore import VTK_FONT_FILE, vtkLookupTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

from workbench.arrays import Array
from workbench.pictures import meshes
from workbench.pictures.images import colours_for, full_scale, to_colours
from workbench.powers import power_of, with_power
from workbench.scene import AnyReceiver, Element, WantedImage
from workbench.targets.raster import averaged

_COLOURS, _LABELS = 256, 3
# Position and size, in parts of the picture.
_PLACE, _WIDTH, _HEIGHT = (0.35, 0.02), 0.3, 0.09
_BAR, _APART = 0.2, 4  # thickness, in parts of the height; pixels between title and labels
_FONT = 12
_RULE_END = 9.0  # pixels
_FRONT = -66000  # units of depth, which take a line before everything
_FONT_FILE = findfont("DejaVu Sans")  # VTK's own fonts lack superscripts: 10⁻⁶ reads 10
_TEXTURE_PIXELS = 512  # per axis; more than a view shows
_GLOW_PARTS = 13  # of each edge of a receiver
_GLOW = {1.0: 0.45, 1.06: 0.2, 1.15: 0.06, 1.3: 0.0}  # opacity by parts of a receiver's extents


def add_to(plotter: Any, mesh: pv.DataSet, **style: Any) -> Any:
    """Add a mesh that is changed in place to a plotter, which stays as it is; return its actor."""
    return plotter.add_mesh(
        mesh, copy_mesh=False, show_scalar_bar=False, reset_camera=False, render=False, **style
    )


class PointMarkers:
    """Point markers of one size in pixels, on a plotter of the caller; none at first."""

    def __init__(self, plotter: Any, size: float, *, round: bool = True) -> None:
        self._mesh = pv.PolyData(np.zeros((1, 3)))
        self._actor = add_to(
            plotter,
            self._mesh,
            style="points",
            point_size=size,
            render_points_as_spheres=round,
            lighting=False,
        )
        self.place(np.zeros((0, 3)))

    def place(self, points: Array) -> None:
        """Move the markers to points (n, 3), scene units."""
        self._actor.SetVisibility(len(points) > 0)
        if not len(points):  # VTK takes no empty arrays
            return
        self._mesh.points = points
        if self._mesh.n_verts != len(points):
            self._mesh.verts = np.insert(np.arange(len(points)), np.arange(len(points)), 1)

    def resize(self, size: float) -> None:
        """Change the size, in pixels."""
        self._actor.prop.point_size = size

    def colour(self, colour: str) -> None:
        """Change the colour."""
        self._actor.prop.color = colour


class Rule:
    """A line between two points, on a plotter of the caller and in front of everything."""

    def __init__(self, plotter: Any, colour: str) -> None:
        self._ends = PointMarkers(plotter, _RULE_END)
        self._mesh = pv.PolyData(np.zeros((2, 3)), lines=[2, 0, 1])
        self._actor = add_to(plotter, self._mesh, line_width=2.0, lighting=False, pickable=False)
        mapper = self._actor.mapper
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, _FRONT)
        self.colour(colour)
        self.place(())

    def place(self, points: Sequence[Array]) -> None:
        """Mark points (3,), and join two of them."""
        self._ends.place(np.reshape(points, (-1, 3)))
        self._actor.SetVisibility(len(points) == 2)
        if len(points) == 2:
            self._mesh.points = np.array(points)

    def colour(self, colour: str) -> None:
        """Change the colour."""
        self._actor.prop.color = colour
        self._ends.colour(colour)


class ColourScale:
    """Colour bar at the bottom of a 3D picture; hidden at first."""

    def __init__(self, plotter: Any) -> None:
        self._table, self._shown = vtkLookupTable(), ""
        self._bar = vtkScalarBarActor()
        self._bar.SetLookupTable(self._table)
        self._bar.SetNumberOfLabels(_LABELS)
        self._bar.SetLabelFormat("%.3g")
        self._bar.UnconstrainedFontSizeOn()
        self._bar.SetOrientationToHorizontal()
        self._bar.SetPosition(*_PLACE)
        self._bar.SetWidth(_WIDTH)
        self._bar.SetHeight(_HEIGHT)
        self._bar.SetBarRatio(_BAR)
        self._bar.SetVerticalTitleSeparation(_APART)
        self._texts = self._bar.GetTitleTextProperty(), self._bar.GetLabelTextProperty()
        for text in self._texts:
            text.SetFontFamily(VTK_FONT_FILE)
            text.SetFontFile(_FONT_FILE)
            text.SetFontSize(_FONT)
            text.ItalicOff()
            text.BoldOff()
            text.ShadowOff()
        self._bar.VisibilityOff()
        self._bar.PickableOff()
        plotter.add_actor(self._bar, reset_camera=False, render=False, pickable=False)

    def show(self, scale: tuple[str, float, float, str] | None, title: str) -> None:
        """Show a scale (colour map, lowest and highest value, unit), or hide the bar."""
        self._bar.SetVisibility(scale is not None)
        if scale is None:
            return
        name, low, high, unit = scale
        power = power_of(low, high)
        self._table.SetTableRange(low / 10.0**power, high / 10.0**power)
        if name != self._shown:
            self._table.SetNumberOfTableValues(_COLOURS)
            for number in range(_COLOURS):
                self._table.SetTableValue(number, *colormaps[name](number / (_COLOURS - 1)))
            self._shown = name
        self._bar.SetNumberOfLabels(_LABELS if unit else 0)
        named = f"{title} ({unit})" if title and unit else title or unit
        self._bar.SetTitle(f"{with_power(named, power)}\n")

    def recolour(self, ink: str) -> None:
        """Change the colour of the text."""
        for text in self._texts:
            text.SetColor(Color(ink).float_rgb)


class LitReceiver:
    """A receiver in the 3D view, textured with its irradiance, with a ``frame`` around it.

    Light at its edges glows beyond them.

    ``add`` is `LensPicture._add`.
    """

    def __init__(
        self, add: Callable[..., Any], receiver: AnyReceiver, optic: Element, wanted: WantedImage
    ) -> None:
        self._wanted = wanted
        corners = receiver.outline(optic)
        count = len(corners)
        plane = pv.PolyData(corners.reshape(-1, 3), faces=meshes.quads(count, count))
        # Texture rows count upwards in VTK: the last row of an image lies at its origin.
        steps = np.linspace(0, 1, count)
        plane.active_texture_coordinates = np.stack(
            np.meshgrid(steps, steps, indexing="ij"), axis=-1
        ).reshape(-1, 2)
        self._texels = pv.ImageData()
        self._texture = pv.Texture()
        self._texture.SetInputDataObject(self._texels)
        n_x, n_y = receiver.pixels
        rings = [meshes.rim(_outline(receiver, optic, fraction)) for fraction in _GLOW]
        faces = meshes.quads(len(rings), len(rings[0]))
        self._glow = pv.PolyData(np.concatenate(rings), faces=faces)
        self.paint(np.zeros((n_y, n_x)))
        add(self._glow, scalars="colour", rgba=True, lighting=False)
        add(plane, body=True, texture=self._texture, lighting=False)
        # Slightly larger than the plane, which would hide parts of the frame.
        around = meshes.rim(receiver.outline(optic, 1.004))
        rim = pv.PolyData(around, lines=[len(around), *range(len(around))])
        self.frame = add(rim, line_width=1.5, lighting=False)

    def paint(self, irradiance: Array, colours: str = "") -> None:
        """Show an irradiance (n_y, n_x); for `colours` see `IrradianceImage.set_colours`."""
        n_y, n_x = irradiance.shape
        thin = (slice(None, None, -(-n // _TEXTURE_PIXELS)) for n in (n_y, n_x))
        shown = irradiance[tuple(thin)]
        scene = self._wanted.scene
        top = full_scale(scene, self._wanted.target, scene.receiver.total(irradiance))
        colours = colours or colours_for(scene)
        texels = to_colours(shown, top, colours)[::-1]
        coarse = averaged(shown[::-1].T, (_GLOW_PARTS, _GLOW_PARTS))
        edge = meshes.rim(coarse[..., None])[None, :, 0]
        glow = np.empty((len(_GLOW), edge.size, 4), dtype=np.uint8)
        glow[..., :3] = to_colours(edge, top, colours)
        opacity = np.array(list(_GLOW.values()))[:, None]
        glow[..., 3] = 255 * opacity * np.clip(edge / top, 0, 1)
        self._glow.point_data["colour"] = glow.reshape(-1, 4)
        self._texels.dimensions = (texels.shape[1], texels.shape[0], 1)
        self._texels.point_data["colour"] = texels.reshape(-1, 3)
        self._texels.point_data.active_scalars_name = "colour"
        self._texels.Modified()


def _outline(receiver: AnyReceiver, optic: Element, fraction: float) -> Array:
    steps = fraction * np.linspace(-1, 1, _GLOW_PARTS)
    (u, v), (r_u, r_v) = receiver.middle, receiver.half_extent
    return receiver.drawn(optic, u + r_u * steps[:, None], v + r_v * steps)
