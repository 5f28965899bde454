"""Cyclic garbage of a command."""

import gc
import subprocess
import sys

from workbench.cli import main

_PROGRAM = """
import atexit, gc, sys
usual = gc.get_threshold()
atexit.register(lambda: print(all(a > b for a, b in zip(gc.get_threshold(), usual))))
sys.argv[1:] = ["no-such-verb"]
from workbench.cli import command
command()
"""


def test_a_commands_process_searches_seldom_until_its_end():
    done = subprocess.run([sys.executable, "-c", _PROGRAM], capture_output=True, text=True)
    assert done.stdout == "True\n"


def test_a_command_within_another_program_leaves_the_thresholds_as_they_are():
    before = gc.get_threshold()
    assert main(["no-such-verb"]) == 2
    assert gc.get_threshold() == before


_AT_EXIT = """
import atexit, gc
atexit.register(lambda: print("kept" if gc.get_freeze_count() > 1000 else "searched"))
print("x" * 100_000)
from workbench.cli import command
command()
"""


def test_a_commands_process_ends_without_searching_what_is_there():
    program = "import sys; sys.argv[1:] = ['no-such-verb']" + _AT_EXIT
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 2
    assert "no-such-verb" in done.stderr
    assert done.stdout == "x" * 100_000 + "\nkept\n"
