"""Starts the window: checks first, shows it soon, and loads what is slow behind it."""

import argparse
import ctypes
import gc
import os
import platform
import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import workbench
from workbench import system_libraries
from workbench.process import calm_library_threads, restart_in_utf8_mode
from workbench.system_libraries import keep_shaders_in_memory

if TYPE_CHECKING:
    from PySide6.QtCore import QSettings
    from PySide6.QtWidgets import QApplication

    from ui.main_window import MainWindow
    from ui.windows import Windows


_PROGRAM = "freeform-workbench"
_M_ARENA_MAX = -8  # of glibc's malloc.h


def main(arguments: list[str] | None = None) -> int:
    """Open a window and stay until all are closed."""
    if arguments is None:
        restart_in_utf8_mode()
    options = _parser().parse_args(arguments)
    if reason := why_no_window():
        print(f"{_PROGRAM}: {reason}", file=sys.stderr)
        return 1
    _prepare_environment()
    application = _application()

    from PySide6.QtCore import QSettings, QStandardPaths

    from ui.background import GarbageCollector, leave_cores
    from ui.dialogs.preferences import CORES, apply_look
    from ui.unexpected_errors import UnexpectedErrors
    from ui.windows import Windows

    beside_settings = QStandardPaths.StandardLocation.AppConfigLocation
    folder = Path(QStandardPaths.writableLocation(beside_settings)) / "recovery"
    settings = QSettings()
    leave_cores(int(CORES.kept(settings)))
    apply_look(settings)
    garbage = GarbageCollector(application)
    windows, unexpected = Windows(settings, folder), UnexpectedErrors()
    # Else each full search goes through 300,000 objects of the slow libraries: 0.2 s.
    windows.loaded.connect(gc.freeze)
    windows.forgotten.connect(_collect_frozen)
    unexpected.happened.connect(windows.show_unexpected_error)
    unexpected.qt_warned.connect(windows.log)
    unexpected.logged.connect(windows.log_details)
    if options.file is None and not options.start:
        options.file = _last_design(settings)
    signals = _leave_on_signals(windows, application)
    _open_first(windows, options)
    status = application.exec()
    windows.wait()
    unexpected.close()
    signals.close()
    garbage.close()
    return status


def _collect_frozen() -> None:
    """Free a closed window that was there when the libraries were loaded, with all that it held."""
    gc.unfreeze()
    gc.collect()
    gc.freeze()


def _last_design(settings: "QSettings") -> Path | None:
    """The file that was open last, where a person wants to begin with it."""
    from ui.dialogs.preferences import START
    from ui.files.actions import RecentFiles

    found = filter(Path.exists, RecentFiles(settings).paths())
    return next(found, None) if START.kept(settings) == "last" else None


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(_PROGRAM, description="Design a freeform lens in a window.")
    parser.add_argument(
        "file", nargs="?", type=Path, metavar="FILE", help="scene file or session to open"
    )
    parser.add_argument("--start", action="store_true", help="begin the design at once")
    parser.add_argument("--version", action="version", version=f"%(prog)s {workbench.__version__}")
    return parser


def _prepare_environment() -> None:
    calm_library_threads()
    keep_shaders_in_memory()
    # Torch's CUDA builds would load it for `paper`. It brings an LLVM of its own, which crashes
    # where that of Mesa draws already; nothing here uses it.
    sys.modules.setdefault("triton", None)  # type: ignore[arg-type]
    if sys.platform.startswith("linux"):
        # The 3D view draws into an X window, also where the desktop speaks Wayland.
        os.environ["QT_QPA_PLATFORM"] = os.environ.get("QT_QPA_PLATFORM") or "xcb"
    if platform.libc_ver()[0] == "glibc":
        # Threads come and go here, and each arena that one had keeps what was freed in it.
        ctypes.CDLL(None).mallopt(_M_ARENA_MAX, 2)


def _application() -> "QApplication":
    from PySide6.QtCore import QCoreApplication, Qt
    from PySide6.QtWidgets import QApplication

    from ui.dialogs.help import TITLE
    from ui.widgets import theme

    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)
    QCoreApplication.setOrganizationName(_PROGRAM)
    QCoreApplication.setApplicationName(_PROGRAM)
    application = QApplication([_PROGRAM])
    application.setApplicationDisplayName(TITLE)
    theme.apply(application)
    return application


def _open_first(windows: "Windows", options: argparse.Namespace) -> None:
    """Open a window that nothing here holds: it may be closed while others stay."""
    window = windows.open(at_start=options.file is None and not options.start)
    _begin_when_painted(window, lambda: _begin(windows, window, options))


def _begin_when_painted(window: "MainWindow", begin: Callable[[], None]) -> None:
    from PySide6.QtCore import Qt, QTimer

    def after_paint() -> None:
        if window.isVisible():  # unless a signal came first
            begin()

    window.painted.connect(
        lambda: QTimer.singleShot(0, window, after_paint), Qt.ConnectionType.SingleShotConnection
    )


def _begin(windows: "Windows", window: "MainWindow", options: argparse.Namespace) -> None:
    windows.warm_up()
    recovered = windows.recover(window)
    opened: MainWindow | None = None if recovered else window
    if options.file is not None:
        opened = windows.open_given(options.file, window, recovered)
    if options.start and opened is not None and opened.loaded is None:
        opened.built.connect(opened.start)
    elif options.start and opened is not None:  # all was loaded while a question stood
        opened.start()


def _leave_on_signals(windows: "Windows", application: "QApplication") -> socket.socket:
    """Close on SIGINT and SIGTERM. Python sees a signal only when it runs: a socket wakes it."""
    from PySide6.QtCore import QSocketNotifier, QTimer

    waking, woken = socket.socketpair()
    for end in (waking, woken):
        end.setblocking(False)
    signal.set_wakeup_fd(waking.fileno())
    notifier = QSocketNotifier(woken.fileno(), QSocketNotifier.Type.Read, windows)
    notifier.activated.connect(lambda: woken.recv(64))

    def leave() -> None:
        windows.leave()
        application.exit(0)  # also out of a question that is open

    for number in (signal.SIGINT, signal.SIGTERM):
        # Through the event loop, which may not have begun yet.
        signal.signal(number, lambda *_: QTimer.singleShot(0, leave))
    return waking


_PLATFORM = "QT_QPA_PLATFORM"
# Starts everywhere: tests use it.
_OFFSCREEN = "offscreen"
_X = "xcb"
# Vulkan alone draws there, and no widget.
_WITHOUT_WIDGETS = "vkkhrdisplay"
_PROBE = (
    "from PySide6.QtGui import QGuiApplication, QRasterWindow;a = QGuiApplication(['probe']); w = "
    "QRasterWindow(); w.resize(8, 8); w.show();a.processEvents()"
)
_PATIENCE_S = 20.0


def why_no_window() -> str | None:
    """Return why no window can open; None if it can."""
    chosen = os.environ.get(_PLATFORM, "")
    if sys.platform.startswith("linux"):
        if missing := system_libraries.missing():
            return system_libraries.advice(missing)
        if chosen in ("", _X) and (reason := _why_no_x_window()):
            return reason
    if chosen in ("", _OFFSCREEN, _X) or (chosen != _WITHOUT_WIDGETS and _starts()):
        return None
    return f"no window opens with {_PLATFORM}={chosen}; type: {_cure()}"


def _cure() -> str:
    if sys.platform == "win32":
        return f"set {_PLATFORM}= & freeform-workbench"
    return f"env -u {_PLATFORM} freeform-workbench"


def _why_no_x_window() -> str | None:
    if not os.environ.get("DISPLAY"):
        return "no display: DISPLAY is not set; use `freeform` to design without a window"
    if not _display_answers():
        return f"no display: {os.environ['DISPLAY']} does not answer; is an X server running?"
    return None


def _starts() -> bool:
    try:
        command = [sys.executable, "-c", _PROBE]
        done = subprocess.run(command, capture_output=True, timeout=_PATIENCE_S, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0


def _display_answers() -> bool:
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connect.argtypes = (ctypes.c_char_p, ctypes.c_void_p)
    xcb.xcb_connection_has_error.argtypes = (ctypes.c_void_p,)
    # Stays open as long as the process: a virtual screen starts anew when its last client leaves,
    # and would turn Qt away in the meantime.
    connection = xcb.xcb_connect(None, None)
    return bool(xcb.xcb_connection_has_error(connection) == 0)
