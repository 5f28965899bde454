"""Table of all commands; menus, toolbar and palette refer to it."""

from dataclasses import dataclass, replace
from typing import Literal

from PySide6.QtGui import QKeySequence

from resources import EXAMPLES
from ui.commands.panes import PANES
from ui.words import LANGUAGES, tr


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
        """Whether its words depend on the element."""
        return "{optic}" in self.text + self.tip

    def said_of(self, optic: str) -> "Command":
        """The command in the current language, for an element."""
        return replace(self, text=tr(self.text, optic=optic), tip=tr(self.tip, optic=optic))


_Key = QKeySequence.StandardKey

NEW = {f"new_{example.name}": example for example in EXAMPLES}
"""Commands that begin with an example."""

VIEWS = ("lens", "screen", "side", "top", "axis")
"""Where the 3D scene can be looked at from, each with a command; see `FittedCamera.fit`."""

RAYS = {f"rays_{rays}": rays for rays in (0, 5, 9, 15, 45)}
"""Commands for the number of rays in the 3D scene, along each axis."""
_FIRST_RAYS = 9

COLOURS = {f"colours_{name}": name for name in ("inferno", "viridis", "cividis", "gray")}
"""Commands for the colours in which light is shown; see `workbench.pictures.axes.UNSIGNED`."""

THEMES = {f"theme_{name}": name for name in ("system", "light", "dark")}
"""Commands for how the windows look; see `ui.widgets.theme.choose`."""

LANGUAGE_CHOICES = {f"language_{code}": code for code in ("system", *LANGUAGES)}
"""Commands for the language of the window; see `ui.commands.choices`."""

TOOLS = ("turn", "sculpt", "lock", "move_source")
"""Commands for what the left button does in the 3D scene."""

LOCKS = ("lock_all", "unlock_all", "invert_locks")
"""Commands for all locks at once."""

RAYS_BY = {"rays_by_outcome": False, "rays_by_weight": True}
"""Commands for the colours of rays: whether by their weight."""

FACES_BY: dict[str, Literal["material", "height", "curvature"]] = {
    "faces_material": "material",
    "faces_by_height": "height",
    "faces_by_curvature": "curvature",
}
"""Commands for the colours of freeform faces in the 3D scene."""

PICTURES = {f"save_scene_{times}": times for times in (1, 2, 4)}
"""Commands that save the 3D scene so many times as large as it is seen."""

COMMANDS = {
    **{name: Command(example.title, example.look) for name, example in NEW.items()},
    "new": Command(
        "&New…", "Begin a design: choose a job and answer its questions", _Key.New, "new"
    ),
    "gallery": Command(
        "New from &gallery…", "Choose an example by the picture of its light", "Ctrl+Shift+N"
    ),
    "new_window": Command(
        "New &window", "Open another window, with a design and a run of its own", "Ctrl+Shift+W"
    ),
    "open": Command("&Open…", "Open a design, or a scene file", _Key.Open, "open"),
    "save": Command("&Save", "Save scene, target and {optic}", _Key.Save, "save"),
    "save_as": Command("Save &as…", "Save under another name", "Ctrl+Shift+S"),
    "export": Command("&Export…", "Write the {optic} or its light for other programs", "Ctrl+E"),
    "cut": Command(
        "Cu&t with a ball cutter…",
        "Write a finishing pass as G-code; what the cut leaves of the image is found before",
    ),
    "report": Command(
        "&Report…", "Write scene, pictures, check and figures on some pages (HTML, PDF)", "Ctrl+R"
    ),
    "save_photo": Command(
        "Save &predicted photo…",
        "Save the predicted photo of the screen: what a camera would see, in colour (PNG)",
    ),
    "close": Command("&Close window", "Close this window; others stay open", "Ctrl+W"),
    "quit": Command("&Quit", "Close all windows of the workbench", "Ctrl+Q"),
    "revert": Command(
        "Re&vert", "Go back to the file as it was saved; this can be undone", "Ctrl+Shift+R"
    ),
    "undo": Command("&Undo", "Take the last change back", _Key.Undo, "undo"),
    "redo": Command("&Redo", "Make the change again", "Ctrl+Shift+Z", "redo"),
    "paste_picture": Command(
        "&Paste picture", "Make the picture on the clipboard the target", _Key.Paste
    ),
    "copy_plot": Command(
        "Copy &plot",
        "Copy a picture of the plot that was clicked last, to paste it elsewhere",
        "Ctrl+Shift+C",
    ),
    "save_plot": Command(
        "Save p&lot…",
        "Save the plot that was clicked last: as a picture (PNG, SVG) or its numbers (CSV)",
        "Ctrl+Shift+E",
    ),
    "start": Command(
        "&Start",
        "Design the {optic} from nothing; one that is there gives way, and Undo brings it back",
        "F5",
        "start",
    ),
    "continue": Command(
        "&Continue",
        "Go on designing from the {optic} as it is, with as many more iterations",
        "Shift+F5",
        "continue",
    ),
    "pause": Command("&Pause", "Hold the design; again to go on", "F6", "pause", checked=False),
    "stop": Command("S&top", "End the design and keep its best {optic}", "F7", "stop"),
    "follow": Command(
        "&Follow edits",
        "Design the {optic} anew after every edit, while no run goes on",
        "F9",
        "follow",
        checked=True,
    ),
    "sweep": Command(
        "S&weep…",
        "Design a {optic} for each of several values of a field, and see all in a table",
    ),
    "restore_run": Command(
        "&Restore run", "Give the design task and {optic} of the run chosen in the dock Runs"
    ),
    "compare_runs": Command(
        "&Compare runs",
        "See the two runs chosen in the dock Runs beside each other: light, figures, fields",
    ),
    "delete_run": Command("&Delete runs", "Forget the runs chosen in the dock Runs"),
    "check": Command(
        "&Check {optic}",
        "Trace the {optic} on show anew, with rays that its design never saw; again to cancel",
        "F8",
    ),
    "fit_view": Command("&Fit 3D view", "Show {optic} and screen whole", "Ctrl+0", "fit-view"),
    "lens_view": Command("Look at &{optic}", "See the {optic} as large as it can be", "Ctrl+1"),
    "screen_view": Command("Look at s&creen", "See the screen as large as it can be", "Ctrl+2"),
    "side_view": Command("From the &side", "Look at the 3D scene along x: light goes right"),
    "top_view": Command("From a&bove", "Look at the 3D scene along y: light goes right"),
    "axis_view": Command("Along the a&xis", "Look back along z from behind the screen"),
    "exploded": Command(
        "&Shorten gaps",
        "Draw a far source and screen nearer, and a large screen smaller, to see the {optic}",
        "Ctrl+D",
        checked=False,
    ),
    **{
        name: Command(
            f"{rays * rays} rays" if rays else "No rays",
            "Rays in the 3D scene",
            checked=rays == _FIRST_RAYS,
        )
        for name, rays in RAYS.items()
    },
    **{
        command: Command(
            name.capitalize(),
            "Colours of light in the images and on the screen of the 3D scene",
            checked=command == "colours_inferno",
        )
        for command, name in COLOURS.items()
    },
    **{
        command: Command(
            "As the &system" if name == "system" else f"&{name.capitalize()}",
            "Show all windows light, dark, or as the system is",
            checked=name == "system",
        )
        for command, name in THEMES.items()
    },
    **{
        command: Command(
            LANGUAGES.get(code, "As the &system"),
            "Language of the window; the command line speaks English",
            checked=code == "system",
        )
        for command, code in LANGUAGE_CHOICES.items()
    },
    **{
        name: Command(text, tip, checked=by_weight is False)
        for (name, by_weight), text, tip in zip(
            RAYS_BY.items(),
            ("Colour by &outcome", "Colour by &weight"),
            ("Rays that miss the screen are red", "By the part of a ray's light that arrives"),
            strict=True,
        )
    },
    **{
        name: Command(text, tip, checked=name == "faces_material")
        for name, text, tip in zip(
            FACES_BY,
            ("As their &material", "By &height", "By &curvature"),
            (
                "Faces of the {optic} as glass or metal",
                "Faces of the {optic} from dark, low along z, to bright",
                "Faces of the {optic} red where they are bowl-shaped towards +z, blue where humped",
            ),
            strict=True,
        )
    },
    "relief": Command(
        "&Relief exaggerated",
        "Light the fine shape of faces as if it were higher; the {optic} stays as it is",
        checked=False,
    ),
    "perspective": Command(
        "&Perspective", "Draw what is farther away smaller, instead of in parallel", checked=False
    ),
    "copy_scene": Command("Copy picture of 3&D", "Put the 3D scene on the clipboard"),
    **{
        name: Command(
            f"{times} × as large…", f"Save the 3D scene as PNG, {times} × as large as it is seen"
        )
        for name, times in PICTURES.items()
    },
    "turn": Command(
        "&Turn",
        "Mouse and arrow keys turn the 3D scene; click to pick",
        "Alt+T",
        "turn",
        checked=True,
    ),
    "sculpt": Command(
        "&Sculpt", "Drag control points of the {optic} along z", "Alt+S", "sculpt", checked=False
    ),
    "lock": Command(
        "&Lock points", "Paint control points that a run must leave", "Alt+L", "lock", checked=False
    ),
    "move_source": Command(
        "&Move source", "Drag the source; Ctrl: along z", "Alt+M", "move-source", checked=False
    ),
    "mark_region": Command(
        "Mark &regions",
        "Draw regions on the images of light, or move their edges: drag a rectangle, or click the "
        "corners of a polygon and double-click. Esc leaves",
        "Alt+G",
        "region",
        checked=False,
    ),
    "picture_aspect": Command(
        "Image as wide and high as the &picture",
        "Give screen or far field, and their pixels, the aspect of the target's picture",
    ),
    "second_face": Command(
        "&Freeform entrance face",
        "Let light meet a second freeform face first, or a flat one again; the exit face stays",
    ),
    "other_face": Command(
        "&Other face", "Turn the {optic} over, to sculpt or lock its other freeform face", "Alt+O"
    ),
    "brush_larger": Command("Lar&ger brush", "More control points at once; also Ctrl+wheel", "]"),
    "brush_smaller": Command(
        "Smaller brus&h", "Fewer control points at once; also Ctrl+wheel", "["
    ),
    "lock_all": Command("Lock &all points", "Leave the whole {optic} as it is in runs"),
    "unlock_all": Command("&Unlock all points", "Let runs change the whole {optic}"),
    "invert_locks": Command("&Invert locks", "Lock what is unlocked, and the reverse"),
    "scene_view": Command("&3D scene", "Show or hide the 3D scene", "Ctrl+3", checked=True),
    "reset_layout": Command("R&eset layout", "Put all docks where they stood at first"),
    "next_pane": Command("&Next pane", "Take the keyboard to the next pane", "Ctrl+F6"),
    "previous_pane": Command(
        "&Previous pane", "Take the keyboard to the pane before", "Ctrl+Shift+F6"
    ),
    **{
        f"go_{name}": Command(
            pane.title,
            "Show this pane and take the keyboard there",
            f"Alt+{pane.key}" if pane.key else "",
        )
        for name, pane in PANES.items()
    },
    "palette": Command("Command &palette", "Find any command by its name", "Ctrl+Shift+P"),
    "shortcuts": Command(
        "&Keyboard shortcuts", "All keys, to be found by name or by key", "Ctrl+F1"
    ),
    "tour": Command("&Tour", "A short tour of the window"),
    "manual": Command(
        "&Manual", "All that can be done, here and in a shell, and what has been measured", "F1"
    ),
    "about": Command("&About", "What this program is"),
}
