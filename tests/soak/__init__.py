"""Programs that use the real window; as in that, its threads leave a core to it."""

from ui.background import leave_cores

leave_cores()  # before any library is loaded that reads it
