"""Labels of some lines keep a number and its unit on one of them."""

import pytest

from ui.widgets.wrapped_label import kept_together


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("50 mm wide", "50_mm wide"),
        ("2.5 · 10⁻⁶ / mm²", "2.5_·_10⁻⁶_/_mm²"),
        ("10⁻⁶ mm", "10⁻⁶_mm"),
        ("<b>1.5 %</b>", "<b>1.5_%</b>"),
        ("0.25 × 2 cm, 12300 lx", "0.25 × 2_cm, 12300_lx"),
        ("5 meshes, 3 seconds, 7 of 9", "5 meshes, 3 seconds, 7 of 9"),
        ("radius mm", "radius mm"),
    ],
)
def test_only_numbers_and_units_are_kept_together(text, kept):
    assert kept_together(text).replace("\N{NO-BREAK SPACE}", "_") == kept
