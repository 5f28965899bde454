"""The program itself: help, both ways in, and errors that nobody expected."""

import json
import logging
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from workbench.cli import arguments, main
from workbench.cli.arguments import VERBS
from workbench.defects import file
from workbench.files.session import read_session


@pytest.fixture
def help_of(capsys, monkeypatch):
    from workbench.cli import main

    monkeypatch.setenv("COLUMNS", "80")

    def run(*verb):
        with pytest.raises(SystemExit) as ended:
            main([*verb] if verb[-1:] == ("--options",) else [*verb, "--help"])
        assert ended.value.code == 0
        return capsys.readouterr().out

    return run


@pytest.mark.parametrize("verb", [(), *((name,) for name in VERBS)])
def test_help_fits_on_one_screen_and_shows_what_to_type(help_of, verb):
    lines = help_of(*verb).splitlines()
    assert len(lines) <= 40
    assert max(map(len, lines)) <= 80
    examples = lines[lines.index("examples:") + 1 :]
    assert examples[0].startswith(f"  freeform {' '.join(verb)}")


def test_options_of_formats_are_listed_by_themselves(help_of):
    lines = help_of("export", "--options").splitlines()
    groups = [line for line in lines if line and not line.startswith(" ")]
    assert groups == ["G-code:", "slow tool servo:", "drawing:", "test tile:"]
    flags = {line.split()[0] for line in lines if line.startswith("  --")}
    assert {"--dialect", "--coolant", "--nose-radius", "--form-tolerance"} <= flags
    assert max(map(len, lines)) <= 80


def test_the_first_help_names_every_verb(help_of):
    stderr = help_of()
    for name in VERBS:
        assert f"\n  {name} " in stderr


FREEFORM = Path(sys.executable).with_name("freeform")


@pytest.mark.parametrize("start", [[FREEFORM], [sys.executable, "-m", "workbench"]])
def test_both_ways_in_do_the_same(start):
    done = subprocess.run([*start, "--help"], capture_output=True, text=True)
    assert done.returncode == 0
    assert done.stdout.startswith("usage: freeform ")
    wrong = subprocess.run([*start, "design"], capture_output=True, text=True)
    assert (wrong.returncode, wrong.stdout) == (2, "")
    assert wrong.stderr.count("\n") == 1


def test_ctrl_c_keeps_the_best_lens_and_ends_with_130(scene_file, out):
    process = subprocess.Popen(
        [FREEFORM, "design", scene_file, "-o", out, "--json", "--iterations", "1000000"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        # Where the tests run in the background, Ctrl-C is ignored and that is handed on.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    with process:
        first = next(line for line in process.stderr if "compiling" not in line)
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        stdout, stderr = process.communicate(timeout=60)
    assert first.startswith("0/1000000  loss ")
    assert process.returncode == 130
    assert stderr.splitlines()[-1] == f"freeform: interrupted; the best lens so far is in {out}"
    result = read_session(out).result
    assert json.loads(stdout)["iterations"] == result.iterations > 0
    assert result.state.loss <= result.losses.min()


def test_the_log_goes_to_standard_error_while_the_command_runs(capsys, monkeypatch):
    log = logging.getLogger("workbench.some_part")

    def work(_):
        log.info("compiling; this takes a while")

    monkeypatch.setattr(arguments, "parse", lambda _: SimpleNamespace(command=work))
    assert main([]) == 0
    assert capsys.readouterr() == ("", "freeform: compiling; this takes a while\n")
    log.info("of another program, which did not ask for it")
    assert capsys.readouterr() == ("", "")


def test_help_and_refusals_do_not_wait_for_torch(scene_file):
    scene_file.write_text("{}")
    program = (
        "import sys; from workbench.cli import main; "
        f"status = main(['design', {str(scene_file)!r}, '-o', 'x']); "
        "slow = {'torch', 'scipy', 'numba', 'pyvista', 'matplotlib'} & set(sys.modules); "
        "sys.exit(10 * len(slow) + status)"
    )
    assert subprocess.run([sys.executable, "-c", program], capture_output=True).returncode == 2


def test_one_line_names_the_file_that_has_the_traceback(monkeypatch, capsys):
    def broken_parser(_):
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(arguments, "parse", broken_parser)
    assert main(["design"]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err == f"freeform: unexpected ZeroDivisionError: by zero (details are in {file()})\n"
    text = file().read_text()
    assert "Traceback" in text and "in broken_parser" in text
