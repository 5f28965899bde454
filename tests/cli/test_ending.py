"""The end of a command's process."""

import subprocess
import sys

_AT_EXIT = "import atexit, sys; atexit.register(lambda: print('asked for'))\n"


def _run(program: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", _AT_EXIT + program]
    return subprocess.run(command, capture_output=True, text=True, timeout=60)


_TAKEN = "class Taken:\n    def __del__(self): print('taken apart')\nsys.taken = Taken()\n"


def test_exit_handlers_run_and_all_output_is_written():
    done = _run("from workbench.cli.ending import end\n" + _TAKEN + "print('x' * 100_000)\nend(3)")
    assert done.returncode == 3
    assert done.stdout == "x" * 100_000 + "\nasked for\n"


def test_threads_at_work_are_waited_for():
    done = _run(
        "import threading, time\n"
        "from workbench.cli.ending import end\n"
        "def work():\n"
        "    time.sleep(0.2)\n"
        "    print('worked')\n"
        "threading.Thread(target=work).start()\n"
        "end(4)"
    )
    assert done.returncode == 4
    assert done.stdout == "worked\nasked for\n"


def test_threads_of_a_pool_that_rest_do_not_keep_a_process():
    done = _run(
        "from concurrent.futures import ThreadPoolExecutor\n"
        "from workbench.cli.ending import end\n" + _TAKEN + "pool = ThreadPoolExecutor(1)\n"
        "print(pool.submit(len, 'work').result())\n"
        "end(4)"
    )
    assert done.returncode == 4
    assert done.stdout == "4\nasked for\n"


def test_a_command_ends_with_its_status():
    program = "sys.argv[1:] = ['no-such-verb']; from workbench.cli import command; command()"
    done = _run(program)
    assert done.returncode == 2
    assert "no-such-verb" in done.stderr
    assert done.stdout == "asked for\n"
