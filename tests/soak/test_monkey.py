"""Random actions on the real program: no crash, no hang, nothing left, memory held.

``MONKEY_SECONDS=7200 MONKEY_SEED=3 python -m pytest -m slow tests/soak/test_monkey.py`` plays for
two hours. What it did lies in pytest's temporary folder.
"""

import json
import os
import subprocess
import sys

import pytest

from tests.soak.screen import needs_screen, virtual_screen

pytestmark = [pytest.mark.slow, needs_screen, pytest.mark.timeout(0)]

_SECONDS = float(os.environ.get("MONKEY_SECONDS", "120"))
_SEED = os.environ.get("MONKEY_SEED", "0")


def test_random_input_causes_no_problem(tmp_path, kernels, capsys):
    (tmp_path / "screen").mkdir()
    with virtual_screen(tmp_path / "screen") as screen:
        play = [sys.executable, "-X", "faulthandler", "-m", "tests.soak.monkey", tmp_path]
        played = subprocess.run(
            [*play, "--seed", _SEED, "--seconds", str(_SECONDS)],
            env=screen.environment,
            capture_output=True,
            text=True,
            timeout=2 * _SECONDS + 300,
        )
    assert played.stdout, f"it ended with status {played.returncode}: {played.stderr}"
    report = json.loads(played.stdout)
    with capsys.disabled():
        print(f"\n{report}", end="")
    assert report["problems"] == [], f"see {tmp_path / 'monkey.log'}"
    assert played.returncode == 0, played.stderr
    assert report["steps"] > _SECONDS
