"""Labels of some lines keep a number and its unit on one of them."""

import pytest
from PySide6.QtWidgets import QLabel

from ui.widgets.wrapped_label import WrappedLabel, kept_together


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


def test_a_label_tells_its_text_as_it_was_given(qtbot):
    label = WrappedLabel("50 mm")
    qtbot.addWidget(label)
    assert label.text() == "50 mm" and QLabel.text(label) == "50\N{NO-BREAK SPACE}mm"
    label.clear()
    assert label.text() == QLabel.text(label) == ""


def test_a_narrow_label_has_a_line_for_each_length(qtbot):
    label = WrappedLabel("50 mm 60 mm")
    qtbot.addWidget(label)
    width = label.fontMetrics().horizontalAdvance("50 mm 60 m")  # room for all but the last unit
    assert label.heightForWidth(width) == 2 * label.fontMetrics().lineSpacing()
    assert label.minimumSizeHint().width() >= label.fontMetrics().horizontalAdvance("50 mm")
