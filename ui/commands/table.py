"""Table of all commands; menus, toolbar and palette refer to it."""

from dataclasses import dataclass, replace

from PySide6.QtGui import QKeySequence

from ui.commands.panes import PANES, WORKSPACES
from ui.words import tr


@dataclass(frozen=True)
class Command:
    """A command of the window."""

    text: str
    tip: str
    shortcut: str | QKeySequence.StandardKey = ""
    icon: str = ""
    checked: bool | None = None

    @property
    def names_optic(self) -> bool:
        return "{optic}" in self.text + self.tip

    def in_words(self, optic: str) -> "Command":
        """The command in the current language, for an element."""
        return replace(self, text=tr(self.text, optic=optic), tip=tr(self.tip, optic=optic))


_Key = QKeySequence.StandardKey

VIEWS = ("lens", "screen", "side", "top", "axis")
"""Where the 3D scene can be looked at from, each with a command; see `FittedCamera.fit`."""

_RAYS, _FIRST_RAYS = (0, 5, 9, 15, 45), 9  # along each axis of the 3D scene

_COLOURS = {
    "colours_by_target": ("By &target", ""),
    "colours_as_seen": ("As &seen", "as seen"),
    "colours_inferno": ("Inferno", "inferno"),
    "colours_viridis": ("Viridis", "viridis"),
    "colours_cividis": ("Cividis", "cividis"),
}
CHOICES: dict[str, dict[str, object]] = {
    "rays": {f"rays_{rays}": rays for rays in _RAYS},
    "by_weight": {"rays_by_outcome": False, "rays_by_weight": True},
    "faces": {
        "faces_material": "material",
        "faces_by_height": "height",
        "faces_by_curvature": "curvature",
        "faces_by_limits": "limits",
    },
    "colours": {command: name for command, (_, name) in _COLOURS.items()},
}
"""Commands of which one is on with its value, by the options of `ui.views.shared_view`."""

WORKSPACE_CHOICES = {f"workspace_{name}": name for name in (*WORKSPACES, "custom")}
"""Commands for what the window shows; see `ui.window.workspaces`."""

TOOLS = ("turn", "sculpt", "lock", "move_source", "measure")
"""Commands for what the left button does in the 3D scene."""

LOCKS = ("lock_all", "unlock_all", "invert_locks")
"""Commands for all locks at once."""

COMMANDS = {
    "new": Command("&New…", "Begin a design on the start page", _Key.New, "new"),
    "new_window": Command(
        "New &window", "Open another window with its own design and run", "Ctrl+Shift+W"
    ),
    "open": Command("&Open…", "Open a design, or a scene file", _Key.Open, "open"),
    "save": Command("&Save", "Save scene, target and {optic}", _Key.Save, "save"),
    "save_as": Command("Save &as…", "Save under another name", "Ctrl+Shift+S"),
    "export": Command(
        "&Export…", "Write the {optic} or its rays for other programs", "Ctrl+E", "export"
    ),
    "cut": Command("Cu&t with a ball cutter…", "Simulate a finishing pass and write it as G-code"),
    "plan": Command(
        "P&lan milling and polishing…",
        "Find step-over and polishing for a wanted error as made, with the least time",
    ),
    "photograph": Command(
        "Compare a p&hotograph…",
        "Compare a photograph of the projected light with the prediction, and find likely causes",
    ),
    "inspect": Command(
        "Read measured s&urfaces…",
        "Compare measured parts with the design, and correct the design for the next part",
    ),
    "report": Command(
        "&Report…", "Write scene, pictures, check and figures as a report (HTML, PDF)", "Ctrl+R"
    ),
    "close": Command("&Close window", "Close this window; others stay open", "Ctrl+W"),
    "quit": Command("&Quit", "Close all windows of the workbench", "Ctrl+Q"),
    "revert": Command("Re&vert", "Restore the saved file; Undo reverts", "Ctrl+Shift+R"),
    "undo": Command("&Undo", "Undo the last change", _Key.Undo, "undo"),
    "redo": Command("&Redo", "Redo the change", "Ctrl+Shift+Z", "redo"),
    "paste_picture": Command(
        "&Paste picture", "Use the picture on the clipboard as the target", _Key.Paste
    ),
    "copy_plot": Command(
        "Copy &plot", "Copy a picture of the plot that was clicked last", "Ctrl+Shift+C"
    ),
    "save_plot": Command(
        "Save p&lot…",
        "Save the plot that was clicked last, as picture (PNG, SVG) or numbers (CSV)",
        "Ctrl+Shift+E",
    ),
    "preferences": Command(
        "Pre&ferences…", "Theme, text size, language, start, checks and cores", "Ctrl+,"
    ),
    "start": Command(
        "&Start", "Design from scratch. Replaces this {optic}; Undo restores it.", "F5", "start"
    ),
    "continue": Command(
        "&Continue",
        "Continue the design of this {optic} with more iterations",
        "Shift+F5",
        "continue",
    ),
    "pause": Command("&Pause", "Pause the design, or resume it", "F6", "pause", checked=False),
    "stop": Command("S&top", "End the design and keep its best {optic}", "F7", "stop"),
    "follow": Command(
        "&Live update",
        "Update the {optic} after every edit, except during a run",
        "F9",
        "follow",
        checked=True,
    ),
    "sweep": Command("S&weep…", "Design a {optic} for each of several values of a field"),
    "save_video": Command(
        "Save &video of the run…",
        "Save the image after each iteration of this run as an animated picture (GIF, WebP)",
    ),
    "restore_run": Command(
        "&Restore run", "Restore task and {optic} of the run selected in the dock Runs"
    ),
    "compare_runs": Command(
        "&Compare runs",
        "Compare irradiance, figures and fields of the two runs selected in the dock Runs",
    ),
    "delete_run": Command("&Delete runs", "Delete the runs selected in the dock Runs"),
    "check": Command(
        "&Check {optic}", "Check this {optic} with an independent ray trace; again to cancel", "F8"
    ),
    "fit_view": Command(
        "&Fit 3D view", "Fit {optic} and screen into the view", "Ctrl+0", "fit-view"
    ),
    "lens_view": Command("Look at &{optic}", "Fit the {optic} into the view", "Ctrl+Alt+1"),
    "screen_view": Command("Look at s&creen", "Fit the screen into the view", "Ctrl+Alt+2"),
    "side_view": Command("From the &side", "View along x; light travels to the right"),
    "top_view": Command("From a&bove", "View along y; light travels to the right"),
    "axis_view": Command("Along the a&xis", "View along −z from behind the screen"),
    "exploded": Command(
        "&Compress distances",
        "Draw far elements nearer and a large screen smaller, to enlarge the {optic}",
        "Ctrl+D",
        checked=False,
    ),
    **{
        f"rays_{rays}": Command(
            f"{rays * rays} rays" if rays else "No rays",
            "Rays in the 3D scene",
            checked=rays == _FIRST_RAYS,
        )
        for rays in _RAYS
    },
    **{
        command: Command(
            title,
            "Colour map of images and 3D screen. By target: pictures as they are seen, unless the "
            "light is in lux; other light in Inferno",
            checked=not name,
        )
        for command, (title, name) in _COLOURS.items()
    },
    "rays_by_outcome": Command(
        "Colour by &outcome", "Rays that miss the screen are red", checked=True
    ),
    "rays_by_weight": Command(
        "Colour by &weight", "By the fraction of a ray's flux that arrives", checked=False
    ),
    "faces_material": Command(
        "As their &material", "Draw faces of the {optic} as glass or metal", checked=True
    ),
    "faces_by_height": Command(
        "By &height", "Colour faces of the {optic} by height along z: dark is low", checked=False
    ),
    "faces_by_curvature": Command(
        "By &curvature",
        "Colour faces of the {optic} by curvature: red is concave towards +z, blue convex",
        checked=False,
    ),
    "faces_by_limits": Command(
        "By &limits",
        "Colour faces of the {optic} by the limits of manufacture: red is exceeded, green within",
        checked=False,
    ),
    "relief": Command(
        "&Relief exaggerated",
        "Exaggerate the relief of faces in the 3D view; the {optic} is unchanged",
        checked=False,
    ),
    "perspective": Command(
        "&Perspective", "Perspective instead of parallel projection", checked=False
    ),
    "copy_scene": Command("Copy picture of 3&D", "Copy a picture of the 3D scene to the clipboard"),
    "save_scene": Command(
        "Save pict&ure of 3D…", "Save the 3D scene as PNG, about 1800 pixels wide"
    ),
    "turn": Command(
        "&Turn",
        "Rotate the 3D scene by mouse or arrow keys; click to select",
        "Alt+T",
        "turn",
        checked=True,
    ),
    "sculpt": Command(
        "&Sculpt", "Drag control points of the {optic} along z", "Alt+S", "sculpt", checked=False
    ),
    "lock": Command(
        "&Lock points",
        "Paint control points that runs must not change",
        "Alt+L",
        "lock",
        checked=False,
    ),
    "move_source": Command(
        "&Move parts",
        "Drag source, elements, the thickness of a lens, or the screen",
        "Alt+M",
        "move-source",
        checked=False,
    ),
    "measure": Command(
        "M&easure",
        "Click two points on {optic} or screen for their distance",
        icon="measure",
        checked=False,
    ),
    "mark_region": Command(
        "Mark &regions",
        "Drag a rectangle on an image, or click the corners of a polygon and double-click; drag "
        "edges to move them. Esc ends",
        "Alt+G",
        "region",
        checked=False,
    ),
    "picture_aspect": Command(
        "Use aspect of the &picture",
        "Set size and pixels of the receiver to the aspect of the target's picture",
    ),
    "second_face": Command(
        "&Freeform entrance face",
        "Make the entrance face freeform, or flat again; the exit face is unchanged",
    ),
    "other_face": Command(
        "&Other face",
        "Select the other freeform face of the {optic} for sculpting and locking",
        "Alt+O",
    ),
    "brush_larger": Command("Lar&ger brush", "More control points at once; also Ctrl+wheel", "]"),
    "brush_smaller": Command(
        "Smaller brus&h", "Fewer control points at once; also Ctrl+wheel", "["
    ),
    "lock_all": Command("Lock &all points", "Lock all control points of the {optic} in runs"),
    "unlock_all": Command("&Unlock all points", "Unlock all control points of the {optic}"),
    "invert_locks": Command(
        "&Invert locks", "Lock unlocked control points, and unlock locked ones"
    ),
    **{
        f"workspace_{name}": Command(each.title, each.tip, f"Ctrl+{number}", checked=number == 1)
        for number, (name, each) in enumerate(WORKSPACES.items(), 1)
    },
    "workspace_start": Command(
        "Start page",
        "Begin a design: a picture, a job, a recent file or an example",
        icon="start-page",
        checked=False,
    ),
    "workspace_custom": Command(
        "Custom", "Arrange docks by hand: drag their title bars", "Ctrl+5", checked=False
    ),
    "save_layout": Command("&Save layout…", "Save the arrangement of the docks under a name"),
    "delete_layout": Command("&Delete layout…", "Delete a saved arrangement of the docks"),
    "reset_layout": Command("R&eset layout", "Arrange this workspace as it was at first"),
    "next_pane": Command("&Next pane", "Move the keyboard focus to the next pane", "Ctrl+F6"),
    "previous_pane": Command(
        "&Previous pane", "Move the keyboard focus to the previous pane", "Ctrl+Shift+F6"
    ),
    **{
        f"go_{name}": Command(
            pane.title, "Show this pane and focus it", f"Alt+{pane.key}" if pane.key else ""
        )
        for name, pane in PANES.items()
    },
    "palette": Command("Command &palette", "Find any command by its name", "Ctrl+Shift+P"),
    "shortcuts": Command("&Keyboard shortcuts", "All keyboard shortcuts, with search", "Ctrl+F1"),
    "tour": Command("&Tour", "Four marks that explain the window"),
    "manual": Command("&Manual", "Manual of window, command line and methods", "F1"),
    "about": Command("&About", "About this program"),
}
