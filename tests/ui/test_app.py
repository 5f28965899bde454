"""The program as a process of its own: exit status, one line on standard error, signals."""

import os
import platform
import signal
import subprocess
import sys

import pytest

from ui import app
from ui.startup import display
from workbench import __version__, system_libraries

COMMAND = [sys.executable, "-m", "ui"]


def run(*arguments, **environment):
    return subprocess.run(
        [*COMMAND, *arguments],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        timeout=120,
    )


def test_the_version_is_printed(capsys):
    with pytest.raises(SystemExit) as left:
        app.main(["--version"])
    assert left.value.code == 0
    assert __version__ in capsys.readouterr().out


def test_wrong_use_is_status_2(capsys):
    with pytest.raises(SystemExit) as left:
        app.main(["--no-such-option"])
    assert left.value.code == 2


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux can be without a display")
@pytest.mark.parametrize("where", ["", ":987"])
def test_without_a_display_one_line_says_so(where):
    done = run(DISPLAY=where, QT_QPA_PLATFORM="")
    assert done.returncode == 1
    assert done.stderr.startswith("freeform-workbench: no display: ")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "platform", ["wayland", "eglfs", "linuxfb", "vkkhrdisplay", "nonsense", "wayland;eglfs"]
)
def test_a_platform_that_cannot_start_is_named_in_one_line(platform):
    done = run(QT_QPA_PLATFORM=platform, DISPLAY=":987", WAYLAND_DISPLAY="")
    assert (done.returncode, done.stdout) == (1, "")
    assert f"QT_QPA_PLATFORM={platform}" in done.stderr
    assert "type: env -u QT_QPA_PLATFORM freeform-workbench" in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("platform", ["minimal", "offscreen"])
def test_other_platforms_may_do_without_a_display(platform, monkeypatch):
    monkeypatch.setattr(system_libraries, "missing", list)
    monkeypatch.setenv("QT_QPA_PLATFORM", platform)
    monkeypatch.delenv("DISPLAY", raising=False)
    assert display.why_no_window() is None


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere the wheels bring all they need")
def test_missing_system_libraries_are_named_with_their_packages(monkeypatch, capsys):
    monkeypatch.setattr(
        system_libraries, "missing", lambda: [("libxcb-cursor.so.0", "libxcb-cursor0")]
    )
    assert app.main([]) == 1
    received = capsys.readouterr().err
    assert "libxcb-cursor.so.0" in received
    assert "apt-get install libxcb-cursor0" in received
    assert received.count("\n") == 1


def test_nothing_slow_is_imported_before_the_window_is_there():
    script = (
        "import sys, ui.main_window, ui.app;"
        "print([m for m in ('torch', 'numba', 'pyvista', 'matplotlib') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.stdout == "[]\n", done.stderr


@pytest.mark.skipif(not os.environ.get("DISPLAY"), reason="needs a display")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_closes_the_window_in_the_midst_of_loading_with_status_0(number, tmp_path):
    script = (
        "import sys, ui.app, ui.main_window as main_window;"
        "show = main_window.MainWindow.showEvent;"
        "main_window.MainWindow.showEvent = lambda *a: (show(*a), print('shown', flush=True))[0];"
        "sys.exit(ui.app.main([]))"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", script],
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline() == "shown\n"
    process.send_signal(number)
    _, received = process.communicate(timeout=120)
    assert process.returncode == 0, received
    assert "Traceback" not in received


@pytest.mark.skipif(not os.environ.get("DISPLAY"), reason="needs a display")
def test_a_window_that_is_told_to_end_does_not_wait_for_what_is_loading(tmp_path):
    script = (
        "import signal, sys, time, ui.app, ui.startup.warm_up as warm_up;"
        "warm_up._warm_up = lambda _: (signal.raise_signal(signal.SIGTERM), time.sleep(1e6));"
        "sys.exit(ui.app.main([]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert list(tmp_path.rglob("*.conf")), "settings are kept"


_ARENAS = """
import ctypes, os, threading
from ui.app import _prepare_environment
_prepare_environment()
libc = ctypes.CDLL(None)
libc.malloc.restype = libc.tmpfile.restype = ctypes.c_void_p
gate = threading.Barrier(9)
def use():
    libc.malloc(ctypes.c_size_t(1000))
    gate.wait(20)
threads = [threading.Thread(target=use) for _ in range(8)]
for thread in threads:
    thread.start()
gate.wait(20)
for thread in threads:
    thread.join()
libc.malloc_info(0, ctypes.c_void_p(file := libc.tmpfile()))
libc.rewind(ctypes.c_void_p(file))
text = ctypes.create_string_buffer(1 << 20)
length = libc.fread(text, 1, len(text), ctypes.c_void_p(file))
print(text.raw[:length].count(b"<heap nr="))
"""


def test_the_window_keeps_no_shaders_where_a_full_disk_would_end_it():
    script = (
        "import os; from ui.app import _prepare_environment; _prepare_environment();"
        "print(os.environ['MESA_SHADER_CACHE_DISABLE'])"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.stdout == "true\n", done.stderr


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="arenas are glibc's")
def test_threads_share_what_memory_was_freed():
    received = subprocess.run([sys.executable, "-c", _ARENAS], capture_output=True, text=True)
    assert received.stderr == ""
    assert 1 <= int(received.stdout) <= 2
