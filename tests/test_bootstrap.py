import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from workbench import bootstrap, system_libraries

ROOT = Path(bootstrap.__file__).resolve().parent.parent


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
        ".venv/bin/python -m compileall -q resources ui workbench",
        f".venv/bin/python -m workbench.analysis.kernels {extra.strip('[]')}".rstrip(),
    ]


WINDOW = [".venv/bin/freeform-workbench resources/examples/tophat.json --start"]
TESTS = [".venv/bin/python -m pytest"]


def test_the_first_start_sets_up_and_the_second_only_opens(commands):
    assert bootstrap.main([]) == 0
    assert commands == setting_up() + WINDOW
    commands.clear()
    assert bootstrap.main([]) == 0
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


def test_arguments_after_test_go_to_pytest_and_its_status_comes_back(monkeypatch, commands):
    bootstrap.main(["test"])
    run = bootstrap._run
    monkeypatch.setattr(bootstrap, "_run", lambda command: run(command) or 5)
    commands.clear()
    assert bootstrap.main(["test", "-k", "flame"]) == 5
    assert commands == [".venv/bin/python -m pytest -k flame"]


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


def test_without_root_the_command_to_type_is_printed(monkeypatch, commands, apt_get, capsys):
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(system_libraries, "missing", lambda _=(): [("libGL.so.1", "libgl1")])
    assert bootstrap.main([]) == 1
    assert commands == []
    assert capsys.readouterr().err == (
        "This machine lacks libGL.so.1; on Debian or Ubuntu type: sudo apt-get install libgl1\n"
    )


def test_outside_a_checkout_it_refuses_in_one_line(tmp_path):
    (tmp_path / "workbench").mkdir()
    for name in ("__init__.py", "bootstrap.py", "system_libraries.py"):
        shutil.copy(ROOT / "workbench" / name, tmp_path / "workbench")
    done = ask_a_bare_python([], tmp_path)
    assert done.returncode == 1
    assert "is no source checkout" in done.stderr
    assert len(done.stderr.splitlines()) == 1


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
