"""Designs in processes of their own."""

import os

from workbench.analysis.benchmark.fresh import fresh_design


def test_a_fresh_process_takes_time_and_memory(make_example):
    seconds, memory = fresh_design(make_example(), 2, 1)
    assert seconds > 0.1
    if os.path.exists("/proc/self/status"):
        assert 50e6 < memory < 4e9
