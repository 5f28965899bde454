import io

import numpy as np
import pytest

from workbench.files.export.tables import rounding, write_table


def test_text_and_what_is_read_again():
    file = io.BytesIO()
    third = np.array([1 / 3, -2e-300, 1e10])
    written = write_table(file, [np.arange(3.0), third], "n,third", ",")
    text = file.getvalue().decode()
    assert text == "n,third\n0,0.333333333333333\n1,-2e-300\n2,10000000000\n"
    assert written[:, 0].tolist() == [0, 1, 2]
    assert rounding(written, 1, third) == pytest.approx(1 / 3 - 0.333333333333333, rel=1e-3)
