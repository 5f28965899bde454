import importlib.util
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from workbench import bootstrap, system_libraries

ROOT = Path(bootstrap.__file__).resolve().parent.parent
SCREEN = "-screen 0 1600x1000x24"


@pytest.fixture
def checkout(monkeypatch, tmp_path):
    """A checkout without anything installed, on a machine that lacks nothing."""
    monkeypatch.setattr(bootstrap, "ROOT", tmp_path)
    monkeypatch.setattr(bootstrap, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(bootstrap, "SCRIPTS", tmp_path / ".venv/bin")
    monkeypatch.setattr(bootstrap, "STAMP", tmp_path / ".venv/installed")
    monkeypatch.setattr(system_libraries, "missing", lambda libraries=(): [])
    monkeypatch.setattr(system_libraries, "missing_programs", lambda programs: [])
    monkeypatch.setattr(system_libraries, "has_display", lambda: True)
    (tmp_path / ".venv").mkdir()
    (tmp_path / "pyproject.toml").write_text('[project]\nname = "a"\n')
    return tmp_path


@pytest.fixture
def commands(monkeypatch, checkout):
    """Command lines that the bootstrap ran, relative to the checkout; each ends with status 0."""
    seen = []

    def run(command):
        seen.append(" ".join(str(part).replace(f"{checkout}/", "") for part in command))
        return 0

    monkeypatch.setattr(bootstrap, "_run", run)
    return seen


@pytest.fixture
def apt_get(monkeypatch, tmp_path):
    """An apt-get that writes its arguments to a file, and root who may call it."""
    log = tmp_path / "apt.log"
    program = tmp_path / "programs/apt-get"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\necho "$DEBIAN_FRONTEND $@" >> {log}\n')
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent}:{os.environ['PATH']}")
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    return program


def setting_up(extra=""):
    return [
        f"{sys.executable} -m venv .venv",
        f".venv/bin/python -m pip install --quiet --editable .{extra}",
        ".venv/bin/python -m workbench.analysis.kernels",
    ]


WINDOW = [".venv/bin/freeform-workbench resources/examples/tophat.json --start"]
TESTS = [".venv/bin/python -m pytest"]


def test_the_first_start_sets_up_and_the_second_only_opens(commands):
    assert bootstrap.main([]) == 0
    assert commands == setting_up() + WINDOW
    commands.clear()
    assert bootstrap.main([]) == 0
    assert commands == WINDOW


def test_libraries_of_the_tests_include_those_of_the_window_but_not_vice_versa(commands):
    bootstrap.main([])
    commands.clear()
    assert bootstrap.main(["test"]) == 0
    assert commands == setting_up("[test]") + TESTS
    commands.clear()
    bootstrap.main([])
    assert commands == WINDOW


def test_a_changed_project_file_asks_for_a_new_set_up(commands, checkout):
    bootstrap.main(["test"])
    (checkout / "pyproject.toml").write_text('[project]\nname = "b"\n')
    commands.clear()
    bootstrap.main([])
    assert commands == setting_up() + WINDOW
    commands.clear()
    bootstrap.main(["test"])
    assert commands == setting_up("[test]") + TESTS


def test_an_installation_that_failed_is_tried_again(monkeypatch, commands, capsys):
    run = bootstrap._run
    monkeypatch.setattr(bootstrap, "_run", lambda command: run(command) or int("pip" in command))
    assert bootstrap.main([]) == 1
    assert "Installing the Python packages failed" in capsys.readouterr().err
    monkeypatch.setattr(bootstrap, "_run", run)
    commands.clear()
    assert bootstrap.main([]) == 0
    assert commands == setting_up() + WINDOW


def test_arguments_after_test_go_to_pytest_and_its_status_comes_back(monkeypatch, commands):
    bootstrap.main(["test"])
    run = bootstrap._run
    monkeypatch.setattr(bootstrap, "_run", lambda command: run(command) or 5)
    commands.clear()
    assert bootstrap.main(["test", "-k", "flame"]) == 5
    assert commands == [".venv/bin/python -m pytest -k flame"]


def test_without_a_display_the_tests_get_a_virtual_screen(monkeypatch, commands):
    monkeypatch.setattr(system_libraries, "has_display", lambda: False)
    assert bootstrap.main(["test"]) == 0
    assert commands[-1] == f"xvfb-run -a -s {SCREEN} .venv/bin/python -m pytest"


def test_without_a_display_the_example_runs_from_the_command_line(monkeypatch, commands, capsys):
    monkeypatch.setattr(system_libraries, "has_display", lambda: False)
    assert bootstrap.main([]) == 0
    assert commands[3:] == [
        ".venv/bin/freeform design resources/examples/tophat.json -o out/tophat.freeform",
        ".venv/bin/freeform pictures out/tophat.freeform out",
    ]
    first, *_, last = capsys.readouterr().out.splitlines()
    assert first.startswith("There is no display: ")
    for name in ("tophat.freeform", "irradiance.png", "lens.png", "loss.png"):
        assert f"out/{name}" in last


def test_an_interrupted_design_ends_with_its_own_status(monkeypatch, commands):
    monkeypatch.setattr(system_libraries, "has_display", lambda: False)
    run = bootstrap._run
    monkeypatch.setattr(
        bootstrap, "_run", lambda command: run(command) or (130 if "design" in command else 0)
    )
    assert bootstrap.main([]) == 130
    assert "design" in commands[-1]


def test_root_on_debian_gets_missing_packages_installed(monkeypatch, commands, apt_get, capsys):
    monkeypatch.setattr(system_libraries, "missing", lambda _=(): [("libGL.so.1", "libgl1")])
    monkeypatch.setattr(system_libraries, "has_display", lambda: False)
    monkeypatch.setattr(system_libraries, "missing_programs", lambda programs: [("xauth", "xauth")])
    assert bootstrap.main(["test"]) == 0
    assert (apt_get.parent.parent / "apt.log").read_text().splitlines() == [
        "noninteractive -qq update",
        "noninteractive -qq install --yes --no-install-recommends libgl1 xauth",
    ]
    assert "Installing Debian packages: libgl1 xauth\n" in capsys.readouterr().out


def test_a_failing_apt_get_shows_its_reason(monkeypatch, commands, apt_get, capsys):
    apt_get.write_text("#!/bin/sh\necho 'E: no network'\nexit 100\n")
    monkeypatch.setattr(system_libraries, "missing", lambda _=(): [("libGL.so.1", "libgl1")])
    assert bootstrap.main([]) == 1
    assert commands == []
    assert capsys.readouterr().err == (
        "E: no network\napt-get update failed; its reason is above.\n"
    )


def test_without_root_the_command_to_type_is_printed(monkeypatch, commands, apt_get, capsys):
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(system_libraries, "missing", lambda _=(): [("libGL.so.1", "libgl1")])
    assert bootstrap.main([]) == 1
    assert commands == []
    assert capsys.readouterr().err == (
        "This machine lacks libGL.so.1; on Debian or Ubuntu type: sudo apt-get install libgl1\n"
    )


def test_a_python_without_its_venv_part_names_the_package(monkeypatch, commands, capsys):
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert bootstrap.main([]) == 1
    assert commands == []
    assert "python3-venv" in capsys.readouterr().err


def test_outside_a_checkout_it_refuses_in_one_line(tmp_path):
    (tmp_path / "workbench").mkdir()
    for name in ("__init__.py", "bootstrap.py", "system_libraries.py"):
        shutil.copy(ROOT / "workbench" / name, tmp_path / "workbench")
    done = ask_a_bare_python([], tmp_path)
    assert done.returncode == 1
    assert "is no source checkout" in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_an_unknown_word_is_wrong_use():
    done = ask_a_bare_python(["tset"], ROOT)
    assert done.returncode == 2
    assert done.stderr.startswith("'tset' is not known here; usage: ")


def test_help_needs_nothing_installed():
    done = ask_a_bare_python(["--help"], ROOT)
    assert done.returncode == 0
    assert done.stdout.rstrip().endswith(bootstrap.USAGE)


def ask_a_bare_python(arguments, folder):
    """Run the bootstrap with the standard library alone."""
    return subprocess.run(
        [sys.executable, "-S", "-m", "workbench.bootstrap", *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def test_a_command_runs_in_the_checkout_with_idle_threads_asleep(capfd):
    script = "import os; print(os.getcwd(), os.environ['OMP_WAIT_POLICY'])"
    assert bootstrap._run([sys.executable, "-c", script]) == 0
    assert capfd.readouterr().out.split() == [str(ROOT), "PASSIVE"]


@pytest.mark.usefixtures("usual_signals")
def test_ctrl_c_is_left_to_the_command(capfd):
    script = (
        "import os, signal\n"
        "try:\n"
        "    os.kill(os.getppid(), signal.SIGINT)\n"
        "    os.kill(os.getpid(), signal.SIGINT)\n"
        "except KeyboardInterrupt:\n"
        "    print('saved')\n"
        "    raise SystemExit(130)\n"
    )
    before = signal.getsignal(signal.SIGINT)
    assert bootstrap._run([sys.executable, "-c", script]) == 130
    assert signal.getsignal(signal.SIGINT) is before
    assert capfd.readouterr().out == "saved\n"


@pytest.mark.usefixtures("usual_signals")
def test_a_command_ended_by_a_signal_has_the_status_a_shell_gives_it():
    script = "import os, signal; os.kill(os.getpid(), signal.SIGTERM)"
    assert bootstrap._run([sys.executable, "-c", script]) == 143
