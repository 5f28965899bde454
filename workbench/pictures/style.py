"""Colours of a matplotlib figure's frame: ink and paper."""

from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import Colormap, LinearSegmentedColormap, to_rgb
from matplotlib.figure import Figure

from workbench.pictures.maps import SIGNED

_ON_DARK = "signed on "  # name of colours about zero, before the colour of the ground
_BELOW, _ABOVE = "#6fb7ff", "#ff8f73"  # their ends: as bright as each other


def paint(figure: Figure, ink: str, paper: str) -> None:
    """Recolour everything but the data; on a dark ground, values about zero are dark at zero.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Its axes are recoloured, those inset in others too.
    ink, paper : str
        Any matplotlib colours for text and lines, and for the ground.
    """
    figure.set_facecolor(paper)
    for axes in figure.findobj(Axes):
        _paint_axes(axes, ink, paper)


def _paint_axes(axes: Axes, ink: str, paper: str) -> None:
    axes.set_facecolor(paper)
    for axis in (axes.xaxis, axes.yaxis):
        axis.label.set_color(ink)
        axis.offsetText.set_color(ink)
        axis.set_tick_params(which="both", color=ink, labelcolor=ink)
    for text in (axes.title, *axes.texts):
        text.set_color(ink)
        box = text.get_bbox_patch()
        if box is not None:
            box.set_facecolor(paper)
    for image in axes.images:
        before = image.get_cmap()
        if before.name == SIGNED or before.name.startswith(_ON_DARK):
            colours = _signed_on(paper)
            if colours.name != before.name:
                red, green, blue, alpha = before.get_bad().tolist()
                image.set_cmap(colours.with_extremes(bad=(red, green, blue, alpha)))
    for spine in axes.spines.values():
        spine.set_edgecolor(ink)
    legend = axes.get_legend()
    if legend is not None and legend.get_frame_on():  # one without a frame has curves' colours
        legend.get_frame().set(facecolor=paper, edgecolor=paper)
        for text in legend.get_texts():
            text.set_color(ink)


def _signed_on(paper: str) -> Colormap:
    """Colours about zero: white at zero on light paper, else the paper's own colour."""
    if sum(to_rgb(paper)) > 1.5:
        return colormaps[SIGNED]
    return LinearSegmentedColormap.from_list(_ON_DARK + paper, [_BELOW, paper, _ABOVE])
