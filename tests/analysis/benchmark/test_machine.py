import json
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
    large = np.ones(40_000_000)  # 320 MB
    del large
    peak = PeakMemory()
    low = peak.bytes()
    more = np.ones(40_000_000)
    del more
    assert 250e6 < peak.bytes() - low < 400e6
