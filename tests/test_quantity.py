"""What people type for a number."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.quantity import read_number


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("5", 5),
        (" -2.5e-3 ", -0.0025),
        ("2,5", 2.5),
        ("0,125", 0.125),
        ("1234,567", 1234.567),
        (".5 + ,25", 0.75),
        ("50/2", 25),
        ("1 + 2*3 − 4 ÷ 8 × 2", 6),
        ("-(2 - 5) * (1 + 1)", 6),
        ("0.1 + 0.2", 0.3),
        ("9223372036854775807", 9223372036854775807),
        ("1 000", 1000),
        ("12 345,5", 12345.5),
        ("1\u202f234\u202f567,25", 1234567.25),
        ("1\u00a0000", 1000),
        ("1'000.5", 1000.5),
        ("1,000.5", 1000.5),
        ("1.000,5", 1000.5),
        ("1.234.567", 1234567),
        ("1,234,567", 1234567),
        ("1,234.5e1", 12345),
        ("2 000 / 4", 500),
    ],
)
def test_arithmetic(text, number):
    found = read_number(text)
    assert (int(found) if isinstance(number, int) else float(found)) == number


@pytest.mark.parametrize(
    ("text", "unit", "number"),
    [
        ("5 cm", "mm", 50),
        ("5cm", "inch", 5 / 2.54),
        ("2,5 in", "mm", 63.5),
        ('1"', "mm", 25.4),
        ("50/2 mm", "cm", 2.5),
        ("1 m − 2*(3 cm + 4 mm)", "mm", 932),
        ("200 µm", "mm", 0.2),
        ("200 μm", "mm", 0.2),
        ("587.6 nm", "µm", 0.5876),
        ("3", "m", 3),
        ("10 mm / (2 mm)", "m", 5),
        ("45°", "°", 45),
        ("3 px", "px", 3),
    ],
)
def test_units(text, unit, number):
    assert float(read_number(text, unit)) == number


@pytest.mark.parametrize(
    ("text", "unit", "stated"),
    [
        ("", "", "'' is not a number"),
        ("far", "mm", "'far' is not a number"),
        ("mm", "mm", "'mm' is not a number"),
        ("nan", "", "is not a number"),
        ("2 3", "", "is not a number"),
        ("2(3)", "", "is not a number"),
        ("2**3", "", "is not a number"),
        ("2//3", "", "is not a number"),
        ("(2", "", "is not a number"),
        ("2 + ", "", "is not a number"),
        ("__import__('os')", "", "is not a number"),
        ("1;2", "", "is not a number"),
        ("1,000", "", "1,000 may be 1.000 or 1000; write which of them"),
        ("1.23,4", "", "1.23,4 has more than one decimal point"),
        ("1.234,567,8", "", "has more than one decimal point"),
        ("1 00", "", "is not a number"),
        ("1 0000", "", "is not a number"),
        ("1 000 00", "", "is not a number"),
        ("1,2,3", "", "1,2,3 has more than one decimal point"),
        ("1/0", "", "divides by zero"),
        ("1e999", "", "1e999 is too large"),
        ("5 kg", "mm", "'5 kg': 'kg' is not known here; mm, cm, m, inch, µm, nm"),
        ("5 mm", "of width", "'5 mm': 'mm' is not known here; %"),
        ("5 mm", "", "'5 mm': 'mm' is not known here; no unit"),
        ("5 mm", "°", "'mm' is not known here; °"),
        ("2 cm * 3 cm", "mm", "is no length, but one to the power of 2"),
        ("2 / 3 cm / 1 cm", "mm", "is no length, but one to the power of 2"),
        ("2 + 3 mm", "cm", "give both a unit"),
        ("1" * 101, "", "has 101 characters; at most 100 are read"),
        ("-" * 99 + "x", "", "is not a number"),
    ],
)
def test_wrong_numbers_are_refused(text, unit, stated):
    with pytest.raises(ValueError) as caught:
        read_number(text, unit)
    assert stated in str(caught.value) and "\n" not in str(caught.value)


@given(st.text(alphabet='0123456789.,eE+-*/() mcinµ°"_', max_size=40))
def test_any_text_is_read_or_refused(text):
    try:
        read_number(text, "mm")
    except ValueError as error:
        assert str(error)
