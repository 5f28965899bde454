import io
from datetime import datetime

import numpy as np
from matplotlib.figure import Figure

from workbench.pictures.report import Pages


def test_places_on_a_page_are_rounded_beyond_the_last_digits_of_the_solver(monkeypatch):
    """These depend on addresses in memory, and made each PDF another file."""
    drawn = []
    savefig = Figure.savefig

    def noting(page, *arguments, **named):
        drawn.append(page)
        savefig(page, *arguments, **named)

    monkeypatch.setattr(Figure, "savefig", noting)

    def draw(part):
        axes = part.subplots(1, 2)
        part.colorbar(axes[0].imshow(np.eye(3)), label="irradiance")

    pages = Pages("foot")
    pages.title("Title", "below")
    pages.picture(draw, 4.0)
    pages.write(io.BytesIO(), "Title", datetime(2001, 2, 3))
    (page,) = drawn
    assert len(page.axes) == 3
    parts = [*page.subfigs, *(inner for part in page.subfigs for inner in part.subfigs)]
    places = [axes.get_position(original=True) for axes in page.axes]
    places += [part.bbox_relative for part in parts]
    assert len(places) > 6
    for place in places:
        np.testing.assert_array_equal(place.get_points(), place.get_points().round(6))
