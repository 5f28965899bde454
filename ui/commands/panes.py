"""Panes of the window, and workspaces that show some of them."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Pane:
    """A dock, a view of the image panel in the middle of the window, or the strip at its bottom."""

    title: str
    key: str = ""
    image: bool = False
    strip: bool = False


PANES = {
    "design": Pane("Design", "1"),
    "scene": Pane("3D scene", "2"),
    "irradiance": Pane("Irradiance", "3", image=True),
    "target": Pane("Target", image=True),
    "error": Pane("Difference", "4", image=True),
    "photo": Pane("Photo", image=True),
    "surface": Pane("Surface", "5", image=True),
    "derivative": Pane("Derivative", image=True),
    "focus": Pane("Through focus", image=True),
    "pinned": Pane("Pinned", image=True),
    "check": Pane("Check"),
    "manufacture": Pane("Manufacture"),
    "tolerances": Pane("Tolerances"),
    "result": Pane("Result"),
    "light": Pane("Light account"),
    "loss": Pane("Loss", "6", strip=True),
    "section": Pane("Cross-section", "7"),
    "runs": Pane("Runs"),
    "history": Pane("History", "8"),
    "log": Pane("Log", "9"),
}
"""By name, in the order in which menus list them and the focus goes.

What a pane holds is made where its libraries are loaded: `ui.window.docks.Panes.put_views` refuses
a table and widgets that do not agree.
"""


Tabs = tuple[str, ...]
"""Docks one behind the other, the front one first."""


@dataclass(frozen=True)
class Workspace:
    """What a window shows for one part of the work.

    `image`: the view of the image panel; `left`, `right`: docks beside it, from top to bottom;
    `strip`: whether the strip below them is shown. The 3D scene stands at the right of a narrow
    image, and below a wide one.
    """

    title: str
    tip: str
    image: str
    left: tuple[Tabs, ...]
    right: tuple[Tabs, ...]
    strip: bool = False


WORKSPACES = {
    "task": Workspace(
        "Task",
        "Describe the light, the element and the image",
        "target",
        (("design",),),
        (("scene",),),
    ),
    "design": Workspace(
        "Design",
        "Run the design and watch the image",
        "irradiance",
        (("design",),),
        (("scene",), ("result", "light", "runs", "log")),
        strip=True,
    ),
    "check": Workspace(
        "Check",
        "Verify the image: errors, cross-sections, through focus",
        "error",
        (),
        (("check", "light", "runs"), ("section",)),
    ),
    "make": Workspace(
        "Make",
        "Make the part: cutters, tolerances, exports",
        "surface",
        (),
        (("scene",), ("manufacture", "tolerances")),
    ),
}
"""By name, in the order of the work."""
