"""The program as a process of its own: exit status, one line on standard error, signals."""

import os
import signal
import subprocess
import sys

import pytest

from ui import app
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


@pytest.mark.skipif(sys.platform != "linux", reason="names platforms of Linux")
@pytest.mark.parametrize("platform", ["wayland", "nonsense"])
def test_a_platform_that_cannot_start_is_named_in_one_line(platform):
    done = run(QT_QPA_PLATFORM=platform, DISPLAY=":987", WAYLAND_DISPLAY="")
    assert (done.returncode, done.stdout) == (1, "")
    assert f"QT_QPA_PLATFORM={platform}" in done.stderr
    assert "type: env -u QT_QPA_PLATFORM freeform-workbench" in done.stderr
    assert done.stderr.count("\n") == 1


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


_CLOSED_FIRST = """
import sys, weakref
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
import ui.app as app
import ui.windows
from ui.windows import Windows

class Program(Windows):
    def __init__(self, *of):
        super().__init__(*of)
        self.loaded.connect(lambda: QTimer.singleShot(0, self, self.go_on))

    def go_on(self):
        first = weakref.ref(self.active())
        self.held = weakref.ref(first().document)
        self.forgotten.connect(lambda: QTimer.singleShot(0, self, self.tell))
        close = lambda: first().discard_and_close()
        self.open().built.connect(lambda: QTimer.singleShot(1000, self, close))

    def tell(self):
        print("gone" if self.held() is None else "still there", flush=True)
        self.leave()
        QTimer.singleShot(0, QApplication.quit)

ui.windows.Windows = Program
sys.exit(app.main([]))
"""


@pytest.mark.skipif(not os.environ.get("DISPLAY"), reason="needs a display")
def test_the_first_window_leaves_nothing_behind_when_another_stays(tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", _CLOSED_FIRST],
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.stdout == "gone\n", done.stderr
