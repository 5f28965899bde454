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

    from PySide6.QtCore import QSettings

    from resources import EXAMPLES
    from ui.document import Document
    from ui.main_window import MainWindow
    from workbench.files.session import open_design

    first = EXAMPLES[0].file
    window = MainWindow(Document(open_design(first), first.stem), QSettings())
    _report_exceptions(window)
    signals = _leave_on_signals(window, application)
    window.show()
    warm_up = _load_behind(window, options.file, options.start)
    status = application.exec()
    warm_up.wait()
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


def _load_behind(window: "MainWindow", file: Path | None, start: bool) -> "WarmUp":
    """After the first paint: open the file, import what is slow, build the views, start."""
    from PySide6.QtCore import Qt, QTimer

    from ui.warm_up import WarmUp

    warm_up = WarmUp()
    warm_up.done.connect(window.build)

    def after_first_paint() -> None:
        opened = file is None or window.files.open(file)
        if start and opened:
            window.built.connect(window.start)
        warm_up.start()

    window.painted.connect(
        lambda: QTimer.singleShot(0, after_first_paint), Qt.ConnectionType.SingleShotConnection
    )
    return warm_up


def _report_exceptions(window: "MainWindow") -> None:
    """An error in a slot is a defect, but no reason to take the work away."""

    def report(
        kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        traceback.print_exception(kind, error, trace)
        text = f"{kind.__name__}: {error}".rstrip(": ")
        window.messages.warn(f"Something went wrong that should not ({text}). Save your work.")

    sys.excepthook = report


def _leave_on_signals(window: "MainWindow", application: "QApplication") -> socket.socket:
    """Close on SIGINT and SIGTERM. Python sees a signal only when it runs: a socket wakes it."""
    from PySide6.QtCore import QSocketNotifier, QTimer

    waking, woken = socket.socketpair()
    for end in (waking, woken):
        end.setblocking(False)
    signal.set_wakeup_fd(waking.fileno())
    notifier = QSocketNotifier(woken.fileno(), QSocketNotifier.Type.Read, window)
    notifier.activated.connect(lambda: woken.recv(64))

    def leave() -> None:
        window.discard_and_close()
        application.exit(0)  # also out of a question that is open

    for number in (signal.SIGINT, signal.SIGTERM):
        # Through the event loop, which may not have begun yet.
        signal.signal(number, lambda *_: QTimer.singleShot(0, leave))
    return waking
