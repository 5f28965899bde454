"""Texts of the program in encodings that lack some of its characters."""

import pytest

from workbench.cli.plain_text import in_encoding


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("560 · 10⁻⁶ mm", "5.6e-4 mm"),
        ("-60.24 · 10⁻⁶ / mm²", "-6.024e-5 / mm^2"),
        ("10⁻⁶", "1e-6"),
        ("2.5 · 10⁶ cd", "2.5e6 cd"),
        ("1 · 10¹² lx and 3 · 10⁻³", "1e12 lx and 3e-3"),
        ("64 × 64, 90°, ±3, 5 µm", "64 x 64, 90 deg, +-3, 5 um"),
        ("“Brightness” → ν", '"Brightness" -> nu'),
        ("Maß 你\udcff", r"Ma\xdf \u4f60\udcff"),
        ("plain", "plain"),
    ],
)
def test_ascii_is_readable(text, plain):
    assert in_encoding(text, "ascii") == plain
    assert plain.isascii()
