"""Starts the window: checks first, shows it soon, and loads what is slow behind it."""

import argparse
import os
import signal
import socket
import sys
import traceback
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

import workbench
from ui.display import why_no_window

if TYPE_CHECKING:
    from PySide6.QtWidgets import QApplication

    from ui.main_window import MainWindow
    from ui.recovery import Recovery
    from ui.warm_up import WarmUp

_PROGRAM = "freeform-workbench"


def main(arguments: list[str] | None = None) -> int:
    """Open the window and stay until it is closed.

    Parameters
    ----------
    arguments : list of str, optional
        Command line without the program's name; by default the process's own.

    Returns
    -------
    int
        Exit status: 0 closed, 1 no window can open here (2, wrong use, leaves by `SystemExit`).
    """
    options = _parser().parse_args(arguments)
    if reason := why_no_window():
        print(f"{_PROGRAM}: {reason}", file=sys.stderr)
        return 1
    _prepare_environment()
    application = _application()

    from PySide6.QtCore import QSettings, QStandardPaths

    from resources import EXAMPLES
    from ui.document import Document
    from ui.main_window import MainWindow
    from ui.recovery import Recovery
    from workbench.files.session import open_design

    first = EXAMPLES[0].file
    window = MainWindow(Document(open_design(first), first.stem), QSettings())
    beside_settings = QStandardPaths.StandardLocation.AppConfigLocation
    folder = Path(QStandardPaths.writableLocation(beside_settings)) / "recovery"
    recovery = Recovery(window.document, folder, window)
    _report_exceptions(window)
    signals = _leave_on_signals(window, recovery, application)
    window.show()
    warm_up = _load_behind(window, recovery, options.file, options.start)
    status = application.exec()
    warm_up.wait()
    recovery.close()
    signals.close()
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(_PROGRAM, description="Design a freeform lens in a window.")
    parser.add_argument(
        "file", nargs="?", type=Path, metavar="FILE", help="scene file or session to open"
    )
    parser.add_argument("--start", action="store_true", help="begin the design at once")
    parser.add_argument("--version", action="version", version=f"%(prog)s {workbench.__version__}")
    return parser


def _prepare_environment() -> None:
    # Threads of the optimiser that wait must sleep, or the window stutters on few cores.
    os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")
    if sys.platform.startswith("linux"):
        # The 3D view draws into an X window, also where the desktop speaks Wayland.
        os.environ.setdefault("QT_QPA_PLATFORM", "xcb")


def _application() -> "QApplication":
    from PySide6.QtCore import QCoreApplication, Qt
    from PySide6.QtWidgets import QApplication

    from ui import theme
    from ui.main_window import TITLE

    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)
    QCoreApplication.setOrganizationName(_PROGRAM)
    QCoreApplication.setApplicationName(_PROGRAM)
    application = QApplication([_PROGRAM])
    application.setApplicationDisplayName(TITLE)
    theme.apply(application)
    return application


def _load_behind(
    window: "MainWindow", recovery: "Recovery", file: Path | None, start: bool
) -> "WarmUp":
    """After the first paint: recover or open, import what is slow, build the views, start."""
    from PySide6.QtCore import Qt, QTimer

    from ui.warm_up import WarmUp

    warm_up = WarmUp()
    warm_up.done.connect(window.build)

    def follow() -> None:
        if window.control is not None:
            recovery.follow(window.control)

    window.built.connect(follow)

    def after_first_paint() -> None:
        warm_up.start()
        recovered = _recover(window, recovery)
        opened = not recovered and (file is None or window.files.open(file))
        if start and opened and window.control is None:
            window.built.connect(window.start)
        elif start and opened:  # all was loaded while a question stood
            window.start()

    window.painted.connect(
        lambda: QTimer.singleShot(0, after_first_paint), Qt.ConnectionType.SingleShotConnection
    )
    return warm_up


def _recover(window: "MainWindow", recovery: "Recovery") -> bool:
    """Offer what was left behind, then keep this window's work; whether any is open now."""
    from ui import left_behind

    def recover(work: left_behind.LeftBehind) -> bool:
        return window.files.recover(work.file, work.path, work.name) and recovery.keep_now()

    recovery.failed.connect(window.messages.warn)
    recovery.start()
    return left_behind.offer(left_behind.find(recovery.folder), recover, window)


def _report_exceptions(window: "MainWindow") -> None:
    """An error in a slot is a defect, but no reason to take the work away."""

    def report(
        kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        traceback.print_exception(kind, error, trace)
        text = f"{kind.__name__}: {error}".rstrip(": ")
        window.messages.warn(f"Something went wrong that should not ({text}). Save your work.")

    sys.excepthook = report


def _leave_on_signals(
    window: "MainWindow", recovery: "Recovery", application: "QApplication"
) -> socket.socket:
    """Close on SIGINT and SIGTERM. Python sees a signal only when it runs: a socket wakes it."""
    from PySide6.QtCore import QSocketNotifier, QTimer

    waking, woken = socket.socketpair()
    for end in (waking, woken):
        end.setblocking(False)
    signal.set_wakeup_fd(waking.fileno())
    notifier = QSocketNotifier(woken.fileno(), QSocketNotifier.Type.Read, window)
    notifier.activated.connect(lambda: woken.recv(64))

    def leave() -> None:
        recovery.close(leave=True)
        window.discard_and_close()
        application.exit(0)  # also out of a question that is open

    for number in (signal.SIGINT, signal.SIGTERM):
        # Through the event loop, which may not have begun yet.
        signal.signal(number, lambda *_: QTimer.singleShot(0, leave))
    return waking
