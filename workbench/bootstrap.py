"""Sets the workbench up in ``.venv`` and opens it, or runs its tests.

``python3 -m workbench.bootstrap`` opens the window with the top-hat example and starts its design;
where there is no display, the same example runs from the command line and leaves its files in
``out/``. ``python3 -m workbench.bootstrap test`` runs the tests; further arguments go to
pytest. Whatever is there already is not installed again.

Only the standard library is used here: this runs before anything is installed.
"""

from __future__ import annotations

import contextlib
import hashlib
import importlib.util
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from workbench import system_libraries

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
SCRIPTS = VENV / ("Scripts" if os.name == "nt" else "bin")
STAMP = VENV / "installed"
EXAMPLE = "resources/examples/tophat.json"
USAGE = "usage: python3 -m workbench.bootstrap [test [PYTEST_ARGUMENT ...]]"


class SetUpFailed(Exception):
    """The set-up cannot go on; the message is one line that says why."""


def main(arguments: Sequence[str]) -> int:
    """Set up what is missing, run what was asked for and return its exit status."""
    if arguments and arguments[0] in ("-h", "--help"):
        print(f"{__doc__}\n{USAGE}")
        return 0
    if arguments and arguments[0] != "test":
        print(f"{arguments[0]!r} is not known here; {USAGE}", file=sys.stderr)
        return 2
    try:
        if not (ROOT / "pyproject.toml").is_file():
            raise SetUpFailed(
                f"{ROOT} is no source checkout; this command sets one up. "
                "Once installed, type freeform-workbench."
            )
        return _test(arguments[1:]) if arguments else _open()
    except SetUpFailed as failure:
        print(failure, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130


def _open() -> int:
    if not system_libraries.has_display():
        return _design_without_window()
    _provide(system_libraries.missing())
    _install()
    return _run([SCRIPTS / "freeform-workbench", EXAMPLE, "--start"])


def _design_without_window() -> int:
    print("There is no display: designing the top-hat example from the command line.", flush=True)
    _provide(system_libraries.missing(system_libraries.OFF_SCREEN))
    _install()
    (ROOT / "out").mkdir(exist_ok=True)
    session = "out/tophat.freeform"
    status = _run([SCRIPTS / "freeform", "design", EXAMPLE, "-o", session])
    if status == 0:
        status = _run([SCRIPTS / "freeform", "pictures", session, "out"])
    if status == 0:
        print(
            f"Left in {ROOT}: the session {session}, the light on the screen out/irradiance.png, "
            "the lens with its rays out/lens.png, the loss out/loss.png."
        )
    return status


def _test(pytest_arguments: Sequence[str]) -> int:
    command: list[str | Path] = [SCRIPTS / "python", "-m", "pytest", *pytest_arguments]
    missing = system_libraries.missing((*system_libraries.WINDOW, *system_libraries.MITSUBA))
    if not system_libraries.has_display():
        missing += system_libraries.missing_programs(system_libraries.VIRTUAL_SCREEN)
        command = ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24", *command]
    _provide(missing)
    _install("test")
    return _run(command)


def _provide(missing: list[tuple[str, str]]) -> None:
    """Install the missing Debian packages, where that is allowed, or say what to type."""
    if importlib.util.find_spec("ensurepip") is None:  # Debian keeps this part of Python apart
        missing = [*missing, ("Python's venv", "python3-venv")]
    if not missing:
        return
    if shutil.which("apt-get") is None or os.geteuid() != 0:
        raise SetUpFailed(system_libraries.advice(missing))
    packages = [package for _, package in missing]
    print(f"Installing Debian packages: {' '.join(packages)}", flush=True)
    _apt_get("update")
    _apt_get("install", "--yes", "--no-install-recommends", *packages)


def _apt_get(*arguments: str) -> None:
    with _ctrl_c_left_to_commands():
        done = subprocess.run(
            ["apt-get", "-qq", *arguments],
            env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
    if done.returncode != 0:
        print(done.stdout, end="", file=sys.stderr)
        raise SetUpFailed(f"apt-get {arguments[0]} failed; its reason is above.")


def _install(extra: str = "") -> None:
    """Install the project and its packages into ``.venv``, unless that has been done."""
    if STAMP.is_file() and _key(extra) in STAMP.read_text().split():
        return
    print("Installing the Python packages into .venv (minutes the first time)", flush=True)
    if _run([sys.executable, "-m", "venv", VENV]) != 0:
        raise SetUpFailed(f"Making {VENV} failed; the reason is above.")
    project = f".[{extra}]" if extra else "."
    if _run([SCRIPTS / "python", "-m", "pip", "install", "--quiet", "--editable", project]) != 0:
        raise SetUpFailed("Installing the Python packages failed; pip's reason is above.")
    # Python would compile the files at each start where PYTHONDONTWRITEBYTECODE is set: a second.
    _run([SCRIPTS / "python", "-m", "compileall", "-q", "resources", "ui", "workbench"])
    print("Compiling the tracing kernels (a minute or two, once)", flush=True)
    if _run([SCRIPTS / "python", "-m", "workbench.analysis.kernels", *filter(None, [extra])]) != 0:
        raise SetUpFailed("Compiling the tracing kernels failed; the reason is above.")
    STAMP.write_text("\n".join({_key(""), _key(extra)}) + "\n")


def _key(extra: str) -> str:
    """Name an installation: a change of any of these asks for a new one."""
    described = f"{extra}\n{ROOT}\n{sys.version_info[:2]}\n".encode()
    return hashlib.sha256(described + (ROOT / "pyproject.toml").read_bytes()).hexdigest()


def _run(command: Sequence[str | Path]) -> int:
    """Run a command in the checkout and return its exit status as a shell would."""
    # Idle OpenMP threads would otherwise spin and take the cores from the window.
    environment = {**os.environ, "OMP_WAIT_POLICY": "PASSIVE"}
    with _ctrl_c_left_to_commands():
        status = subprocess.run(command, cwd=ROOT, env=environment).returncode
    return status if status >= 0 else 128 - status


@contextlib.contextmanager
def _ctrl_c_left_to_commands() -> Iterator[None]:
    """Let a command that Ctrl-C reaches too decide how to end, and what to save first.

    A handler that does nothing, unlike an ignored signal, is not passed on to the command.
    """
    before = signal.signal(signal.SIGINT, lambda signal_number, frame: None)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
