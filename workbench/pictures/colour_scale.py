"""The scale of colours below a picture in three dimensions, with numbers and their unit."""

from typing import Any

from matplotlib import colormaps
from matplotlib.font_manager import findfont
from pyvista import Color
from vtkmodules.vtkCommonCore import VTK_FONT_FILE, vtkLookupTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

from workbench.powers import power_of, with_power

_COLOURS, _LABELS = 256, 5
# Place and size, in parts of the picture.
_PLACE, _WIDTH, _HEIGHT = (0.3, 0.02), 0.4, 0.1
_FONT = 12
_LETTERS = findfont("DejaVu Sans")  # those that VTK has of itself lack high figures: 10⁻⁶ is 10


class ColourScale:
    """A bar of colours at the bottom of a picture; hidden until it is shown.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Gets the bar.
    """

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
        self._texts = self._bar.GetTitleTextProperty(), self._bar.GetLabelTextProperty()
        for text in self._texts:
            text.SetFontFamily(VTK_FONT_FILE)
            text.SetFontFile(_LETTERS)
            text.SetFontSize(_FONT)
            text.ItalicOff()
            text.BoldOff()
            text.ShadowOff()
        self._bar.VisibilityOff()
        self._bar.PickableOff()
        plotter.add_actor(self._bar, reset_camera=False, render=False, pickable=False)

    def show(self, scale: tuple[str, float, float, str] | None, title: str) -> None:
        """Show colours by their name, the lowest and highest value, and their unit; or none."""
        self._bar.SetVisibility(scale is not None)
        if scale is None:
            return
        name, low, high, unit = scale
        power = power_of(low, high)
        self._table.SetTableRange(low / 10.0**power, high / 10.0**power)
        if name != self._shown:
            self._table.SetNumberOfTableValues(_COLOURS)
            for number in range(_COLOURS):
                self._table.SetTableValue(number, *colormaps[name](number))
            self._shown = name
        named = f"{title} ({unit})" if title else unit
        self._bar.SetTitle(f"{with_power(named, power)}\n")

    def recolour(self, ink: str) -> None:
        """Write in another colour."""
        for text in self._texts:
            text.SetColor(Color(ink).float_rgb)
