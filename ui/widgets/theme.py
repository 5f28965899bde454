"""Theme of the window: Fusion in the system's colours, and icons in the text colour."""

from functools import cache
from pathlib import Path

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtGui import QColor, QFont, QFontDatabase, QIcon, QImage, QPainter, QPalette, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication, QWidget

import resources

_ICON_SIZES = (16, 24, 32, 48, 64)
_INK = "#666"  # the one colour of all icons but the program's own

# Beside the palette's greys; readable (7:1) on both grounds, and marked by an icon as well.
_REFUSED = {"light": "#a40020", "dark": "#ff9a8d"}
_WARNING = {"light": "#fff0c8", "dark": "#4d3f10"}
# Fusion's buttons that are on look like the others in the dark.
_ON = {"light": "#b5d3ee", "dark": "#2a6296"}
_MUTED = {"light": "#5f656d", "dark": "#a3a8b0"}  # 5:1 on both grounds
_LINK = {"light": "#1f66a3", "dark": "#6cb0ea"}  # also of rings around what has the keyboard
_DISABLED = {"light": "#6a7078", "dark": "#91969e"}
_DASHES = {"light": "#8d939b", "dark": "#6f7680"}  # 3:1 on both grounds
_NOTE = {"light": "#dcebfa", "dark": "#1d3a56"}
_RAISED = {"light": "#ffffff", "dark": "#2d3138"}  # notices over something else, and
_EDGE = {"light": "#b4bac2", "dark": "#4a505a"}  # their border
# Fusion draws boxes that are not ticked nearly black on dark grey; WCAG asks for 3:1.
_BOXES = {
    "light": "",
    "dark": """
        QCheckBox::indicator:unchecked, QAbstractItemView::indicator:unchecked {
            width: 12px; height: 12px; border: 1px solid #8f8f8f; border-radius: 2px;
            background: palette(base);
        }
        QCheckBox::indicator:unchecked:hover { border-color: palette(highlight); }
        QCheckBox::indicator:unchecked:disabled { border-color: #5c5c5c; }
        """,
}

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
    return QColor(_MUTED["dark" if is_dark(palette) else "light"])


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
        roles.Link: QColor(_LINK[name]),
        roles.LinkVisited: QColor(_LINK[name]),
        roles.PlaceholderText: QColor(_MUTED[name]),
    }.items():
        palette.setColor(role, colour)
    for role in (roles.WindowText, roles.Text, roles.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(_DISABLED[name]))
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
    title = _TITLE * application.font().pointSizeF()
    sheet = f"""
        QLabel[marked="true"] {{ background: {_HIGHLIGHT}; color: white; border-radius: 2px; }}
        QLabel#refusal {{ color: {_REFUSED[scheme]}; }}
        *[refused="true"] QLineEdit, *[refused="true"] QComboBox {{
            border: 1px solid {_REFUSED[scheme]}; border-radius: 2px;
        }}
        QToolButton#heading {{
            font-weight: 600; border: none; border-bottom: 1px solid palette(mid); padding: 4px;
            background: none;
        }}
        QToolButton#heading:hover {{ background: palette(midlight); }}
        QToolButton:focus, QToolButton#heading:focus, QTabBar:focus, QScrollArea:focus,
        QAbstractItemView:focus, QPushButton#primary:focus {{
            border: 1px solid {_LINK[scheme]}; border-radius: 2px;
        }}
        QLabel#title {{
            font-size: {title}pt; font-weight: 600; padding: 4px 0; qproperty-indent: 0;
        }}
        QLabel#muted {{ color: {_MUTED[scheme]}; }}
        QFrame#well {{
            background: palette(base); border: 2px dashed {_DASHES[scheme]}; border-radius: 8px;
        }}
        QFrame#well:hover, QFrame#well[active="true"] {{ border-color: {_HIGHLIGHT}; }}
        QPushButton#primary:enabled {{
            background: {_HIGHLIGHT}; color: white; border: 1px solid {_HIGHLIGHT};
            border-radius: 4px; padding: 5px 16px;
        }}
        QLabel#section {{ font-weight: 600; padding: 8px 8px 0 4px; }}
        QDockWidget {{
            titlebar-close-icon: url("{_icon_file("dock-close").as_posix()}");
            titlebar-normal-icon: url("{_icon_file("dock-float").as_posix()}");
        }}
        QDockWidget[active="true"]::title {{
            background: palette(midlight); border-left: 4px solid palette(highlight);
            padding-left: 3px;
        }}
        QFrame#handle {{ background: palette(highlight); }}
        QFrame#centre[active="true"] {{ border: 2px solid palette(highlight); }}
        QMainWindow > QTabBar {{
            qproperty-elideMode: ElideNone; qproperty-usesScrollButtons: true;
        }}
        QToolButton:checked, QPushButton:checked {{ background-color: {_ON[scheme]}; }}
        QTreeWidget#commands::item {{ padding: 3px; }}
        QLabel#hint {{ background: {_NOTE[scheme]}; padding: 6px; }}
        QFrame#card {{ background: palette(base); border-radius: 4px; }}
        QFrame#warning, QFrame#note, QFrame#done {{
            background: {_RAISED[scheme]}; border: 1px solid {_EDGE[scheme]}; border-radius: 6px;
        }}
        QFrame#warning {{ background: {_WARNING[scheme]}; }}
        QFrame#shelf {{ background: palette(window); border: 1px solid {_EDGE[scheme]}; }}
        QStatusBar::item {{ border: none; }}
        {_BOXES[scheme]}
        """
    if sheet != application.styleSheet():  # else all widgets are polished anew: half a second
        application.setStyleSheet(sheet)
