"""Theme of the window: Fusion in the system's colours, and icons in the text colour."""

from functools import cache
from pathlib import Path
from string import Template

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtGui import QColor, QFont, QFontDatabase, QIcon, QImage, QPainter, QPalette, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication, QWidget

import resources

_ICON_SIZES = (16, 24, 32, 48, 64)
_INK = "#666"  # the one colour of all icons but the program's own

COLOURS = {
    # Beside the palette's greys; readable (7:1) on both grounds, and marked by an icon as well.
    "refused": {"light": "#a40020", "dark": "#ff9a8d"},
    "warning": {"light": "#fff0c8", "dark": "#4d3f10"},
    # Fusion's buttons that are on look like the others in the dark.
    "on": {"light": "#b5d3ee", "dark": "#2a6296"},
    "muted": {"light": "#5f656d", "dark": "#a3a8b0"},  # 5:1 on both grounds
    "link": {"light": "#1f66a3", "dark": "#6cb0ea"},  # also of rings around what has the keyboard
    "disabled": {"light": "#6a7078", "dark": "#91969e"},
    "dashes": {"light": "#8d939b", "dark": "#6f7680"},  # 3:1 on both grounds
    "note": {"light": "#dcebfa", "dark": "#1d3a56"},
    "raised": {"light": "#ffffff", "dark": "#2d3138"},  # notices over something else, and
    "edge": {"light": "#b4bac2", "dark": "#4a505a"},  # their border
}
"""Colours of the style sheet by their names there and by schemes."""

_SCHEMES = {
    "system": Qt.ColorScheme.Unknown,
    "light": Qt.ColorScheme.Light,
    "dark": Qt.ColorScheme.Dark,
}
# Of buttons and windows; of fields; and text.
_GROUNDS = {"light": ("#f2f3f5", "#ffffff", "#16181b"), "dark": ("#23262b", "#181a1e", "#e9eaec")}
_HIGHLIGHT = "#2b78b8"
_FONT, _POINTS = "Inter", 9.75  # 13 pixels of 1/96 inch
_TITLE = 1.3  # of the size of other text


def apply(application: QApplication) -> None:
    """Set style, typeface and colours, and colours whenever the system's scheme changes."""
    application.setStyle("Fusion")
    application.setFont(_typeface())
    application.setWindowIcon(QIcon(str(_icon_file("workbench"))))
    _colour(application)
    # The palette follows only after this signal.
    application.styleHints().colorSchemeChanged.connect(
        lambda _: QTimer.singleShot(0, application, lambda: _colour(application))
    )


def set_text_size(application: QApplication, part: float) -> None:
    """Set the size of text, as a part of the usual one."""
    font = application.font()
    font.setPointSizeF(_POINTS * part)
    application.setFont(font)


def _typeface() -> QFont:
    for weight in ("Regular", "SemiBold"):
        QFontDatabase.addApplicationFont(str(resources.path("fonts", f"Inter-{weight}.otf")))
    font = QFont(_FONT)
    font.setPointSizeF(_POINTS)
    font.setFeature(QFont.Tag("tnum"), 1)  # digits of one width
    return font


def choose(application: QApplication, name: str) -> None:
    """Choose the "light" or "dark" scheme, or that of the "system"."""
    application.styleHints().setColorScheme(_SCHEMES[name])  # for what the system draws itself
    application.setPalette(_palette(name) if name in _GROUNDS else QPalette())
    _colour(application)


def is_dark(palette: QPalette) -> bool:
    """Whether text is brighter than the background."""
    return palette.windowText().color().lightness() > palette.window().color().lightness()


def icon(name: str, palette: QPalette) -> QIcon:
    """Return an icon of resources/icons in the text colour, paler when disabled."""
    made = QIcon()
    groups = {
        QIcon.Mode.Normal: QPalette.ColorGroup.Active,
        QIcon.Mode.Disabled: QPalette.ColorGroup.Disabled,
    }
    for mode, group in groups.items():
        colour = palette.color(group, QPalette.ColorRole.ButtonText)
        for size in _ICON_SIZES:
            made.addPixmap(QPixmap.fromImage(_drawn(name, colour.name(), size)), mode)
    return made


def muted(palette: QPalette) -> QColor:
    """Return the colour of text that says less than the one beside it."""
    return QColor(COLOURS["muted"]["dark" if is_dark(palette) else "light"])


def restyle(widget: QWidget) -> None:
    """Apply the style sheet again after a property changed."""
    for changed in (widget, *widget.findChildren(QWidget)):
        changed.style().unpolish(changed)
        changed.style().polish(changed)


def _palette(name: str) -> QPalette:
    ground, field, text = (QColor(colour) for colour in _GROUNDS[name])
    palette = QPalette(ground, ground)
    roles = QPalette.ColorRole
    for role, colour in {
        roles.Base: field,
        roles.AlternateBase: ground,
        roles.ToolTipBase: field,
        roles.ToolTipText: text,
        roles.WindowText: text,
        roles.Text: text,
        roles.ButtonText: text,
        roles.Highlight: QColor(_HIGHLIGHT),
        roles.HighlightedText: QColor("white"),
        roles.Link: QColor(COLOURS["link"][name]),
        roles.LinkVisited: QColor(COLOURS["link"][name]),
        roles.PlaceholderText: QColor(COLOURS["muted"][name]),
    }.items():
        palette.setColor(role, colour)
    for role in (roles.WindowText, roles.Text, roles.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(COLOURS["disabled"][name]))
    return palette


def _icon_file(name: str) -> Path:
    return resources.path("icons", f"{name}.svg")


@cache  # each window has the same icons
def _drawn(name: str, colour: str, size: int) -> QImage:
    drawing = _icon_file(name).read_text(encoding="utf-8").replace(_INK, colour)
    image = QImage(size, size, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    QSvgRenderer(QByteArray(drawing.encode())).render(painter)
    painter.end()
    return image


def _colour(application: QApplication) -> None:
    # Fusion's buttons of docks vanish in the dark; these are of a grey between both grounds.
    scheme = "dark" if is_dark(application.palette()) else "light"
    files = ("style", "dark") if scheme == "dark" else ("style",)
    text = "".join(resources.path(f"{name}.qss").read_text(encoding="utf-8") for name in files)
    sheet = Template(text).substitute(
        {name: colours[scheme] for name, colours in COLOURS.items()},
        highlight=_HIGHLIGHT,
        title=_TITLE * application.font().pointSizeF(),
        icons=resources.path("icons").as_posix(),
    )
    if sheet != application.styleSheet():  # else all widgets are polished anew: half a second
        application.setStyleSheet(sheet)
