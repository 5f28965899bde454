"""What a test of the window must not leave behind: threads, timers, widgets, VTK objects."""

import gc
import sys
import threading

from PySide6.QtCore import QCoreApplication, QEvent, QThread, QTimer
from PySide6.QtWidgets import QApplication
from shiboken6 import isValid

_SETTLING = 4  # rounds of events that may still be under way
_VTK = (
    ("vtkmodules.vtkRenderingCore", "vtkRenderWindow"),
    ("vtkmodules.vtkRenderingCore", "vtkRenderWindowInteractor"),
    ("pyvista.plotting.plotter", "BasePlotter"),
)


def living():
    """Everything that a test must not leave behind, by id, with a name for each."""
    found = {id(w): f"top-level widget {w!r}" for w in QApplication.topLevelWidgets()}
    for thread in threading.enumerate():
        # Python makes up a dummy for every QThread that it meets; those are reported below.
        if not isinstance(thread, threading._DummyThread):
            found[id(thread)] = f"thread {thread.name}"
    scene_parts = tuple(
        getattr(sys.modules[module], name) for module, name in _VTK if module in sys.modules
    )
    application = QCoreApplication.instance()
    window_thread = application.thread() if application else None
    # isinstance would wake lazy proxies; each of the few kinds is looked at once.
    sought = (QThread, QTimer, *scene_parts)
    kinds = {}
    for thing in gc.get_objects():
        kind = type(thing)
        if kind not in kinds:
            kinds[kind] = issubclass(kind, sought)
        if not kinds[kind]:
            continue
        if issubclass(kind, QThread):
            if isValid(thing) and thing.isRunning() and thing != window_thread:
                found[id(thing)] = f"running {thing!r}"
        elif issubclass(kind, QTimer):
            if isValid(thing) and thing.isActive():
                found[id(thing)] = f"active {thing!r} of {thing.parent()!r}"
        else:
            found[id(thing)] = f"VTK's {kind.__name__}"
    return found


def left_behind(before):
    """Names of what lives now and did not before, after giving it a chance to go."""
    application = QApplication.instance()
    for _ in range(_SETTLING):
        if application is not None:
            application.processEvents()
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        found = {key: name for key, name in living().items() if key not in before}
        if not found:
            return []
        gc.collect()
    return sorted(found.values())
