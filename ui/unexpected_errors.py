"""Unexpected errors: shown once in the window, with details for a report.

Qt continues after an error in a slot. Each kind of error, by type and line, is shown once and
printed every time, and written to the file of `workbench.defects`.
"""

import logging
import sys
import threading
import traceback
from collections.abc import Callable
from types import TracebackType

from PySide6.QtCore import (
    QMessageLogContext,
    QObject,
    QtMsgType,
    Signal,
    qInstallMessageHandler,
    qVersion,
)

from ui.background import LOG
from ui.words import tr
from workbench.defects import details, unexpected

# The 3D view asks for its format when a context is there already, which serves it as well.
_HARMLESS = "Warning: Setting a new default format"
_SERIOUS = (QtMsgType.QtWarningMsg, QtMsgType.QtCriticalMsg, QtMsgType.QtFatalMsg)


class UnexpectedErrors(QObject):
    """Installs error hooks of Python and Qt until `close`."""

    happened = Signal(str, str)
    qt_warned = Signal(str)
    logged = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._known: set[tuple[str, str]] = set()
        self._qt_texts: set[str] = set()
        self._hooks = sys.excepthook, threading.excepthook
        sys.excepthook = self._report
        threading.excepthook = self._report_thread
        self._qt_handler = qInstallMessageHandler(self._handle_qt_message)
        self._relay = _Relay(self.logged.emit)
        LOG.addHandler(self._relay)

    def close(self) -> None:
        sys.excepthook, threading.excepthook = self._hooks
        qInstallMessageHandler(self._qt_handler)
        LOG.removeHandler(self._relay)

    def _report(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        traceback.print_exception(kind, error, trace)
        if not issubclass(kind, Exception):  # the end of the program, not a defect
            return
        known = kind.__name__, _place(trace)
        if known in self._known:
            return
        self._known.add(known)
        self.happened.emit(
            tr("Unexpected error: {error}. Save your work.").format(error=unexpected(error)),
            f"Qt {qVersion()}\n{details(error)}",
        )

    def _report_thread(self, arguments: threading.ExceptHookArgs) -> None:
        if arguments.exc_value is not None:
            self._report(arguments.exc_type, arguments.exc_value, arguments.exc_traceback)

    def _handle_qt_message(self, kind: QtMsgType, context: QMessageLogContext, text: str) -> None:
        if text.startswith(_HARMLESS):
            return
        print(text, file=sys.stderr)
        if kind in _SERIOUS and text not in self._qt_texts:
            self._qt_texts.add(text)
            self.qt_warned.emit(f"Qt: {text}")


def _place(trace: TracebackType | None) -> str:
    frames = traceback.extract_tb(trace)
    return f"{frames[-1].filename}:{frames[-1].lineno}" if frames else ""


class _Relay(logging.Handler):
    def __init__(self, show: Callable[[str], None]) -> None:
        super().__init__()
        self._show = show

    def emit(self, record: logging.LogRecord) -> None:
        text = self.format(record)
        print(text, file=sys.stderr)
        self._show(text)
