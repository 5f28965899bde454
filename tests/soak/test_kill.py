"""A program that is killed at any moment: its next start has the work, hardly older than that.

``KILLS=100 python -m pytest -m slow tests/soak/test_kill.py`` kills a hundred times. Each life
begins with what the last one left; a monkey recovers it and plays on until it is killed as well.
"""

import os
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from random import Random

import pytest

from tests.soak.kept import Line, fingerprint, read_account
from tests.soak.screen import needs_screen, virtual_screen
from workbench.files.session import read_session

pytestmark = [pytest.mark.slow, needs_screen, pytest.mark.timeout(0)]

_KILLS = int(os.environ.get("KILLS", "3"))
_SEED = int(os.environ.get("MONKEY_SEED", "0"))
_EVERY = 2.0  # seconds, where a person has a minute
_SLACK = 10.0  # while all cores are busy
_LIFE = (1.0, 40.0)  # seconds from start to kill


def test_work_is_recovered_at_each_start_after_a_kill(tmp_path, kernels, capsys):
    rng = Random(_SEED)
    account, ages, works = tmp_path / "kept.log", [], 0
    account.touch()
    with virtual_screen(_folder(tmp_path / "screen")) as screen:
        for life in range(_KILLS + 1):
            left = dict(_left(tmp_path)) if life else {}
            before = len(account.read_text())
            killed_at = _live_and_die(tmp_path, life, rng.uniform(*_LIFE), screen.environment)
            lines = [*_since(account, before)]
            now = dict(_left(tmp_path))
            _nothing_is_lost(left, now, lines)
            ages += _ages(lines, now, killed_at)
            works += len(now)
    oldest = max(ages, default=0.0)
    with capsys.disabled():
        print(f"\n{_KILLS + 1} kills left {works} works, at most {oldest:.1f} s old", end="")
    assert works
    assert oldest < _EVERY + _SLACK


def _folder(path: Path) -> Path:
    path.mkdir()
    return path


def _live_and_die(folder: Path, life: int, seconds: float, environment: dict[str, str]) -> float:
    """Start the program, play, and kill it; when that was."""
    play = [sys.executable, "-m", "tests.soak.monkey", folder]
    with (folder / "reported.txt").open("a") as reported:
        process = subprocess.Popen(
            [*play, "--seed", str(1000 * _SEED + life), "--keep-every-ms", str(int(1000 * _EVERY))],
            env=environment,
            stdout=reported,
            stderr=reported,
        )
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(seconds)
        process.kill()
        killed_at = time.time()
        process.wait()
    return killed_at


def _left(folder: Path) -> Iterator[tuple[str, str]]:
    """Each window's recovery file, by its name, and the fingerprint of the work in it."""
    for file in folder.glob("settings/**/recovery/*.freeform"):
        yield file.stem, fingerprint(read_session(file))


def _since(account: Path, start: int) -> Iterable[Line]:
    part = account.with_suffix(".part")
    part.write_text(account.read_text()[start:])
    return read_account(part)


def _nothing_is_lost(left: dict[str, str], now: dict[str, str], lines: list[Line]) -> None:
    """What one life left is there still, or was written again by the next one."""
    wrote = {line.work for line in lines if line.event == "wrote"}
    for name, work in left.items():
        assert now.get(name) == work or work in wrote, f"{name} is lost"


def _ages(lines: list[Line], now: dict[str, str], killed_at: float) -> Iterator[float]:
    """How old the work of each window is that a kill left, or would have been."""
    for name in {line.name for line in lines}:
        own = [line for line in lines if line.name == name]
        held = [line for line in own if line.event == "holds"]
        if not held or held[-1].work is None:  # saved, or not looked at yet
            continue
        if name in now:
            same = [line.time for line in own if line.work == now[name]]
            assert same, f"{name} is none of what the window held"
            yield killed_at - max(same)
        else:  # not written yet: then it has not been there for long
            clean = [line.time for line in held if line.work is None]
            yield killed_at - (clean[-1] if clean else held[0].time)
