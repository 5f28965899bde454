import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.loss import LossPicture, Verified


@pytest.fixture
def axes():
    return Figure().subplots()


def test_against_seconds(axes):
    picture = LossPicture(axes, "seconds")
    times = np.array([0.25, 0.5, 3.0])
    picture.update(np.array([3.0, 2.0, 1.5]), 100, stage_starts=(2,), times=times)
    np.testing.assert_array_equal(picture.artists[0].get_xdata(), times)
    assert axes.get_xlim() == (0, 5)
    assert axes.get_xlabel() == "time (s)"
    assert [line.get_xdata()[0] for line in picture._stage_lines] == [0.5]


def test_checks_stand_where_the_run_was(axes):
    picture = LossPicture(axes, "seconds")
    picture.update(np.array([3.0]), 1, times=np.ones(1), verified=[Verified(7, 0.5, 4.0)])
    np.testing.assert_array_equal(picture.artists[1].get_xydata(), [[0.5, 4.0]])
    assert axes.get_ylim() == (2, 5)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["this run", "verified"]
    assert picture.update(np.array([3.0]), 1, times=np.ones(1)) is True
    assert axes.get_legend() is None
