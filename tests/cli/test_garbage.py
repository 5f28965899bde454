"""Cyclic garbage of a command."""

import gc

import pytest

from workbench.cli import main
from workbench.cli.garbage import seldom_collected


def test_thresholds_are_higher_during_a_command_alone():
    before = gc.get_threshold()
    with pytest.raises(KeyError), seldom_collected():
        assert all(now > usual for now, usual in zip(gc.get_threshold(), before, strict=True))
        raise KeyError
    assert gc.get_threshold() == before


def test_a_command_that_is_refused_leaves_the_thresholds_as_they_were(capsys):
    before = gc.get_threshold()
    assert main(["no-such-verb"]) == 2
    assert gc.get_threshold() == before
