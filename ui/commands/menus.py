"""Menus, toolbar and exclusive groups of commands."""

from typing import Any

from ui.commands.panes import PANES
from ui.commands.table import (
    COLOURS,
    FACES_BY,
    LANGUAGE_CHOICES,
    LOCKS,
    NEW,
    PICTURES,
    RAYS,
    RAYS_BY,
    THEMES,
    TOOLS,
    VIEWS,
)


def _examples() -> list[Any]:
    groups: dict[str, list[str]] = {}
    for name, example in NEW.items():
        groups.setdefault(example.group, []).append(name)
    (_, first), *others = groups.items()
    return [*first, None, *others]


_RUN = ["start", "continue", "pause", "stop"]

# Menus by name; None is a separator, a tuple a menu within. Open recent and the docks are added
# by the window, because they come and go.
MENUS: dict[str, list[Any]] = {
    "&File": [
        "new",
        ("&New from example", _examples()),
        "gallery",
        "new_window",
        "open",
        ("Open &recent", []),
        None,
        "save",
        "save_as",
        "revert",
        None,
        "export",
        "cut",
        "report",
        "save_photo",
        None,
        "close",
        "quit",
    ],
    "&Edit": ["undo", "redo", None, "paste_picture", None, "copy_plot", "save_plot"],
    "&Design": [
        *TOOLS,
        None,
        "mark_region",
        None,
        "picture_aspect",
        "second_face",
        "other_face",
        None,
        "brush_larger",
        "brush_smaller",
        None,
        *LOCKS,
        None,
        "check",
    ],
    "&Run": [*_RUN, None, "follow", "sweep", None, "restore_run", "compare_runs", "delete_run"],
    "&View": [
        "fit_view",
        *(f"{view}_view" for view in VIEWS),
        None,
        "exploded",
        "perspective",
        ("&Rays", [*RAYS, None, *RAYS_BY]),
        ("F&aces", [*FACES_BY, None, "relief"]),
        ("Save pict&ure of 3D", list(PICTURES)),
        "copy_scene",
        ("&Colours of light", list(COLOURS)),
        ("Th&eme", list(THEMES)),
        ("La&nguage", list(LANGUAGE_CHOICES)),
        None,
        ("&Go to", [*(f"go_{name}" for name in PANES), None, "next_pane", "previous_pane"]),
        "reset_layout",
        None,
        "scene_view",
    ],
    "&Help": ["tour", "manual", "shortcuts", "palette", None, "about"],
}
_FILES, _STEPS = ["new", "open", "save"], ["undo", "redo"]
TOOLBAR = [
    *_FILES,
    None,
    *_STEPS,
    None,
    *_RUN,
    "follow",
    None,
    *TOOLS,
    None,
    "mark_region",
    "fit_view",
]
"""Names and separators, as in a menu."""
LABELLED = _RUN
"""Those whose name stands beside the icon in the toolbar."""
CHOICES = [
    list(RAYS),
    list(RAYS_BY),
    list(FACES_BY),
    list(COLOURS),
    list(THEMES),
    list(LANGUAGE_CHOICES),
    list(TOOLS),
]
"""Groups of commands of which one is on."""
LOOK = ["scene_view", "exploded", "perspective", *RAYS, *RAYS_BY, *FACES_BY, "relief", *COLOURS]
"""Those whose state is part of how a design is looked at, and travels with it."""
