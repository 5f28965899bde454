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


def test_in_blocks(monkeypatch, rng):
    whole, blocks = io.BytesIO(), io.BytesIO()
    columns = [rng.normal(size=25), rng.normal(size=25)]
    expected = write_table(whole, columns, "# a b", " ", "\r\n")
    monkeypatch.setattr("workbench.files.export.tables._ROWS_AT_ONCE", 10)
    assert np.array_equal(write_table(blocks, columns, "# a b", " ", "\r\n"), expected)
    assert blocks.getvalue() == whole.getvalue()
    assert whole.getvalue().count(b"\r\n") == 26


def test_no_rows():
    file = io.BytesIO()
    written = write_table(file, [np.zeros(0), np.zeros(0)], "a,b", ",")
    assert file.getvalue() == b"a,b\n"
    assert written.shape == (0, 2)
    assert rounding(written, 0, np.zeros(0)) == 0
