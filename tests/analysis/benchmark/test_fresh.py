"""Designs in processes of their own."""

import os

import pytest

from workbench.analysis.benchmark.fresh import fresh_design
from workbench.errors import RunFailed


def test_a_fresh_process_takes_time_and_memory(make_example):
    seconds, memory = fresh_design(make_example(), 2, 1)
    assert seconds > 0.1
    if os.path.exists("/proc/self/status"):
        assert 50e6 < memory < 4e9


def test_error_of_a_failed_process_is_reported(impossible):
    with pytest.raises(RunFailed, match="no light reaches the screen"):
        fresh_design(impossible, 2, 1)
