"""The machine that benchmarks run on, and the memory of a fresh process."""

import json
import mmap
import os

import numpy as np
import pytest
import torch

from workbench.analysis.benchmark.machine import Machine, PeakMemory


def test_the_machine_is_described_in_json_and_text():
    machine = Machine.here()
    data = machine.to_data()
    assert json.loads(json.dumps(data)) == data
    assert machine.cpu and machine.system
    assert 1 <= machine.cores <= os.cpu_count()
    assert machine.threads == torch.get_num_threads()
    assert machine.versions["torch"] == torch.__version__
    text = machine.to_markdown()
    assert machine.cpu in text and f"torch {torch.__version__}" in text
    assert "host" not in data  # nobody's concern


@pytest.mark.skipif(not os.path.exists("/proc/self/clear_refs"), reason="needs Linux")
def test_peak_memory_counts_from_its_last_reset():
    def fill() -> None:
        with mmap.mmap(-1, 320_000_000) as pages:  # an array may lie where another one was freed
            np.frombuffer(pages, np.uint8)[:] = 1  # type: ignore[call-overload]

    fill()
    peak = PeakMemory()
    low = peak.bytes()
    fill()
    assert 250e6 < peak.bytes() - low < 400e6
