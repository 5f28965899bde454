"""The scale of colours below a picture in three dimensions."""

from types import SimpleNamespace

import pytest
from matplotlib.ft2font import FT2Font

from workbench.pictures.actors import ColourScale


@pytest.fixture
def scale():
    """A scale that nothing draws."""
    return ColourScale(SimpleNamespace(add_actor=lambda *_, **__: None))


def test_numbers_far_below_one_have_a_common_power(scale):
    scale.show(("RdBu_r", -5e-5, 5e-5, "1 / mm"), "Mean curvature")
    assert scale._bar.GetTitle() == "Mean curvature (10⁻⁶ / mm)\n"
    assert scale._table.GetTableRange() == pytest.approx((-50, 50))
    scale.show(("viridis", 0.0, 2.5, "mm"), "")
    assert scale._bar.GetTitle() == "mm\n"
    assert scale._table.GetTableRange() == (0, 2.5)


def test_its_letters_have_the_figures_of_powers(scale):
    for text in scale._texts:
        letters = FT2Font(text.GetFontFile())
        assert all(letters.get_char_index(ord(sign)) for sign in "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
