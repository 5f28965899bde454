"""Colours of a matplotlib figure's frame: ink and paper."""

from matplotlib.axes import Axes
from matplotlib.figure import Figure


def paint(figure: Figure, ink: str, paper: str) -> None:
    """Recolour everything but the data.

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
    for spine in axes.spines.values():
        spine.set_edgecolor(ink)
    legend = axes.get_legend()
    if legend is not None and legend.get_frame_on():  # one without a frame has curves' colours
        legend.get_frame().set(facecolor=paper, edgecolor=paper)
        for text in legend.get_texts():
            text.set_color(ink)
