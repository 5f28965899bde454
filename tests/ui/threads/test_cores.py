"""Cores that threads beside the window take."""

import subprocess
import sys

from ui.threads.cores import other_cores

_COUNT = """
import threading
from ui.threads.cores import leave_core_for_window
leave_core_for_window()
import torch
found = [torch.get_num_threads()]
thread = threading.Thread(target=lambda: found.append(torch.get_num_threads()))
thread.start()
thread.join()
print(*found)
"""


def test_every_thread_leaves_a_core_to_the_window(monkeypatch):
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    found = subprocess.run([sys.executable, "-c", _COUNT], capture_output=True, check=True)
    assert found.stdout.split() == [str(other_cores()).encode()] * 2
