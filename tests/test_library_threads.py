"""How threads of numerical libraries behave."""

import os
import subprocess
import sys

from workbench.library_threads import calm_library_threads


def test_thread_settings_of_the_user_stay(monkeypatch):
    monkeypatch.setenv("OMP_WAIT_POLICY", "ACTIVE")
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "2")  # so that it is put back in any case
    monkeypatch.delenv("OPENBLAS_NUM_THREADS")
    calm_library_threads()
    assert os.environ["OMP_WAIT_POLICY"] == "ACTIVE"
    assert os.environ["OPENBLAS_NUM_THREADS"] == "1"


def test_no_library_is_loaded_before_a_command_says_it():
    script = "import sys, workbench.cli; sys.exit(bool({'numpy', 'torch'} & {*sys.modules}))"
    assert subprocess.run([sys.executable, "-c", script]).returncode == 0
