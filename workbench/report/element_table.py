"""The elements of a scene as a table."""

from workbench.powers import written
from workbench.report.content import Table
from workbench.report.scene_rows import field_words
from workbench.scene import Element, Face, Part, Scene
from workbench.scene.part import title_of

_HEADER = ("Element", "Kind", "Material", "Position", "Tilt", "Thickness", "Size", "Faces")
_NONE = "–"


def element_table(scene: Scene) -> Table:
    """Return a row for each element, in the order in which light meets them."""
    return Table(
        _HEADER, tuple(_row(each.lit(scene.source.wavelength), scene) for each in scene.elements)
    )


def _row(element: Element, scene: Scene) -> tuple[str, ...]:
    words = {field.name: field_words(element, field, scene) for field in element.fields()}
    size = words["half_width"]
    return (
        element.name,
        title_of(type(element)).lower(),
        _material(element, words.get("material", _NONE)),
        words["position"],
        words["tilt"] if any(element.tilt) else "none",
        words.get("thickness", _NONE),
        f"{size}, ellipse" if element.outline == "ellipse" else size,
        "; ".join(_face(placed.face, scene) for placed in element.placed_faces),
    )


def _material(element: Element, words: str) -> str:
    material = getattr(element, "material", None)
    return f"n = {written(element.index)}" if isinstance(material, Part) else words


def _face(face: Face, scene: Scene) -> str:
    shown = [field for field in face.fields() if field.name != "shape"]
    if face.designed:
        shown = [field for field in shown if field.name == "control_points"]
    shape = [
        f"{field.title.lower()} {field_words(face, field, scene)}"
        for field in shown
        if getattr(face, field.name) not in ((), 0.0)
    ]
    title = title_of(type(face))
    return ", ".join([title if title[1:2] == "-" else title.lower(), *shape])
