"""Programs that use the real window; as in that, its threads leave a core to it."""

from ui.background import leave_core_for_window

leave_core_for_window()  # before any library is loaded that reads it
