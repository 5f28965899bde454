"""Numbers for people, and the power of ten that they are multiples of."""

import numpy as np
import pytest

from workbench.powers import written


@pytest.mark.parametrize(
    ("value", "unit", "digits", "text"),
    [
        (-6.024e-5, "/ mm²", 4, "-60.24 · 10⁻⁶ / mm²"),
        (0.0045, "mm", 2, "4.5 µm"),
        (5.2e-7, "mm", 2, "520 · 10⁻⁶ µm"),
        (0.0003, "inch", 2, "300 · 10⁻⁶ inch"),
        (0.00099, "cm", 2, "9.9 µm"),
        (0.000999996, "mm", 4, "1 µm"),
        (99_999.0, "lx", 4, "100 · 10³ lx"),
        (12_345.0, "lx", 3, "12300 lx"),  # not 1.23e+04
        (1_234.0, "mm", 3, "1230 mm"),
        (100.0, "", 2, "100"),
        (22.0, "°", 4, "22°"),
        (6.0204e-7, "", 4, "6.02 · 10⁻⁷"),
        (1e-6, "", 4, "10⁻⁶"),
        (1e-6, "mm", 4, "0.001 µm"),
        (-0.0, "mm", 4, "0 mm"),
        (5e-324, "", 2, "4.9 · 10⁻³²⁴"),
        (5e-324, "mm", 2, "4.9 · 10⁻³²⁴ mm"),
        (float("inf"), "mm", 4, "inf mm"),
        (np.float32(0.25), "/ cm²", 4, "0.25 / cm²"),
    ],
)
def test_one_number_is_written_for_people(value, unit, digits, text):
    assert written(value, unit, digits) == text
