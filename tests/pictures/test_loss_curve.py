import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.loss import LossCourse, LossPicture, Verified


@pytest.fixture
def axes():
    return Figure().subplots()


def test_first_loss_stands_at_iteration_1(axes):
    curve = LossPicture(axes)
    curve.update(np.array([3.0, 2.0]), 100)
    x, y = curve.artists[0].get_data()
    np.testing.assert_array_equal(x, [1, 2])
    np.testing.assert_array_equal(y, [3.0, 2.0])
    assert axes.get_xlim() == (0, 100)


def test_limits_change_only_when_the_curve_leaves_them(axes):
    curve = LossPicture(axes)
    assert curve.update(np.array([3.0]), 10) is True
    assert axes.get_ylim() == (2, 5)
    assert curve.update(np.array([3.0, 2.5, 4.9]), 10) is False
    assert curve.update(np.array([3.0, 2.5, 4.9, 0.3]), 10) is True
    assert axes.get_ylim() == pytest.approx((0.2, 5))


def test_values_without_a_logarithm_do_not_set_the_limits(axes):
    curve = LossPicture(axes)
    curve.update(np.array([3.0, 0.0, np.nan]), 10)
    assert axes.get_ylim() == (2, 5)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("losses", [[5e-324], [1e-3, 5e-324], [1e-3, 1.7e308], [5e-324, 1.7e308]])
def test_losses_at_the_ends_of_all_numbers_are_drawn(axes, losses):
    curve = LossPicture(axes)
    curve.update(np.array(losses), 10)
    low, high = axes.get_ylim()
    assert 0 < low < high < np.inf
    axes.figure.canvas.draw()


def test_no_losses_yet(axes):
    curve = LossPicture(axes)
    curve.update(np.zeros(0), 300)
    assert axes.get_xlim() == (0, 300)
    assert curve.artists[2].get_text() == ""


def test_against_seconds(axes):
    picture = LossPicture(axes, "seconds")
    times = np.array([0.25, 0.5, 3.0])
    picture.update(np.array([3.0, 2.0, 1.5]), 100, stage_starts=(2,), times=times)
    np.testing.assert_array_equal(picture.artists[0].get_xdata(), times)
    assert axes.get_xlim() == (0, 5)
    assert axes.get_xlabel() == "time (s)"
    assert [line.get_xdata()[0] for line in picture._stage_lines] == [0.5]


@pytest.mark.parametrize("against", ["iterations", "seconds"])
def test_a_logarithmic_x_axis_holds_the_first_step(axes, against):
    picture = LossPicture(axes, against, (True, True))
    picture.update(np.array([3.0, 2.0]), 100, times=np.array([0.3, 4.0]))
    assert axes.get_xlim() == ((1, 100) if against == "iterations" else (0.2, 5))


def test_an_even_y_axis_begins_at_nothing(axes):
    LossPicture(axes, logarithmic=(False, False)).update(np.array([3.0, 2.0]), 10)
    assert axes.get_ylim() == (0, 5)


def test_other_runs_differ_by_dashes_and_fit_in_the_limits(axes):
    picture = LossPicture(axes)
    one = LossCourse("coarse net", np.array([9.0, 4.0, 0.3]), np.array([1.0, 2.0, 3.0]))
    picture.compare([one, one._replace(name="fine net")])
    picture.update(np.array([3.0, 2.0]), 2)
    assert axes.get_xlim() == (0, 3)
    assert axes.get_ylim() == pytest.approx((0.2, 10))
    named = {line.get_label(): line for line in axes.lines}
    assert {"this run", "coarse net", "fine net"} <= named.keys()
    looks = {named[name].get_linestyle() for name in ("this run", "coarse net", "fine net")}
    assert len(looks) == 3
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts == ["this run", "coarse net", "fine net"]
    picture.compare([])
    assert axes.get_legend() is None and len(axes.lines) == 2


def test_names_that_have_no_room_are_left_out():
    low = Figure(figsize=(2.2, 1.2)).subplots()
    picture = LossPicture(low)
    picture.compare([LossCourse(f"run {k}", np.ones(2), np.ones(2)) for k in range(6)])
    assert low.get_legend() is None
    low.get_figure().set_size_inches(8, 4)
    assert picture.update(np.ones(2), 2) is True
    assert len(low.get_legend().get_texts()) == 7


def test_checks_stand_where_the_run_was(axes):
    picture = LossPicture(axes, "seconds")
    picture.update(np.array([3.0]), 1, times=np.ones(1), verified=[Verified(7, 0.5, 4.0)])
    np.testing.assert_array_equal(picture.artists[1].get_xydata(), [[0.5, 4.0]])
    assert axes.get_ylim() == (2, 5)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["this run", "verified"]
    assert picture.update(np.array([3.0]), 1, times=np.ones(1)) is True
    assert axes.get_legend() is None
