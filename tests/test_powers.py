"""Numbers for people, and the power of ten that they are multiples of."""

import numpy as np
import pytest

from workbench.powers import power_of, with_power, without_power, written


@pytest.mark.parametrize("exponent", range(-12, 12))
def test_a_power_is_a_multiple_of_three_that_leaves_one_to_three_digits(exponent):
    for digits in (1.0, 5.7, 9.99):
        top = digits * 10.0**exponent
        power = power_of(-top / 2, top)
        assert power % 3 == 0
        if power:
            assert 1 <= top / 10.0**power < 1000 * (1 + 1e-12)
        else:
            assert 1e-2 <= top < 1e5


@pytest.mark.parametrize(
    ("name", "power", "named"),
    [
        ("flux / mm²", -6, "10⁻⁶ flux / mm²"),
        ("x (cm)", -3, "x (10⁻³ cm)"),
        ("Gaussian curvature (1 / mm²)", -9, "Gaussian curvature (10⁻⁹ / mm²)"),
        ("x (m) at y = 0 m", -3, "x (10⁻³ m) at y = 0 m"),
        ("1 / mm", -12, "10⁻¹² / mm"),
        ("cd", 6, "10⁶ cd"),
        ("lx", 0, "lx"),
    ],
)
def test_a_power_stands_in_front_of_the_unit(name, power, named):
    assert with_power(name, power) == named
    assert with_power(named, power) == named
    assert without_power(named) == name


@pytest.mark.parametrize(
    ("value", "unit", "digits", "text"),
    [
        (-6.024e-5, "/ mm²", 4, "-60.24 · 10⁻⁶ / mm²"),
        (0.0045, "mm", 2, "0.0045 mm"),
        (5.2e-7, "mm", 2, "520 · 10⁻⁹ mm"),
        (0.000999996, "mm", 4, "0.001 mm"),  # not 1000 · 10⁻⁶
        (99_999.0, "lx", 4, "100 · 10³ lx"),
        (12_345.0, "lx", 3, "12300 lx"),  # not 1.23e+04
        (1_234.0, "mm", 3, "1230 mm"),
        (100.0, "", 2, "100"),
        (22.0, "°", 4, "22°"),
        (6.0204e-7, "", 4, "6.02 · 10⁻⁷"),
        (1e-6, "", 4, "10⁻⁶"),
        (1e-6, "mm", 4, "1 · 10⁻⁶ mm"),
        (-0.0, "mm", 4, "0 mm"),
        (5e-324, "", 2, "4.9 · 10⁻³²⁴"),
        (5e-324, "mm", 2, "4.9 · 10⁻³²⁴ mm"),
        (float("inf"), "mm", 4, "inf mm"),
        (np.float32(0.25), "/ cm²", 4, "0.25 / cm²"),
    ],
)
def test_one_number_is_written_for_people(value, unit, digits, text):
    assert written(value, unit, digits) == text
