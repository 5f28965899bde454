"""The scale of colours below a picture in three dimensions."""

from types import SimpleNamespace

import pytest

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
