"""The manual's page of all fields of a scene, made from what the fields say of themselves."""

from collections.abc import Iterator

from pydantic.fields import FieldInfo

from workbench.scene import Part, Scene
from workbench.scene.fields import FieldDescription
from workbench.scene.part import summary_of, title_of

_HEAD = """# Every field of a scene

Made from the program itself: titles and tips are those of the forms, names those of scene files.
Lengths are in the scene's unit, angles in degrees. A field without a default has to be given.
"""


def fields_page() -> str:
    """Markdown with one section for each part of a scene, in the order in which they are met."""
    return "\n".join([_HEAD, *(_section(path, part) for path, part in _parts())]).rstrip() + "\n"


def _parts() -> Iterator[tuple[str, type[Part]]]:
    """Each kind of part once, with the path at which it is met first."""
    waiting: list[tuple[str, type[Part]]] = [("", Scene)]
    met: set[type[Part]] = set()
    for path, part in waiting:
        if part in met:
            continue
        met.add(part)
        yield path, part
        for field in part.fields():
            below = f"{path}.{field.name}".lstrip(".") + ("[…]" if field.listed else "")
            waiting += [(below, kind) for kind in field.parts if issubclass(kind, Part)]


def _section(path: str, part: type[Part]) -> str:
    title = f"## {title_of(part)}" + (f": `{path}`" if path else "")
    lines = [title, "", _sentence(summary_of(part)), ""]
    rows = [_row(field, part) for field in part.fields() if field.tip]
    if rows:
        lines += [
            "| field | in the window | default | what it is |",
            "|---|---|---|---|",
            *rows,
            "",
        ]
    return "\n".join(lines)


def _row(field: FieldDescription, part: type[Part]) -> str:
    known = part.model_fields[field.name]
    default = "" if known.is_required() else _default(known)
    unit = field.measure.words_in("length")
    sentences = [_sentence(field.tip)]
    if field.times != 1:
        sentences.append(f"The window shows {field.times:g} times this.")
    if field.limits:
        sentences.append(field.limits)
    if field.choices:
        sentences.append("One of " + ", ".join(f"`{value}`" for value, _ in field.choices) + ".")
    title = field.in_window.title
    named = f"{title} ({unit})" if unit else title
    return "| " + " | ".join((f"`{field.name}`", named, default, " ".join(sentences))) + " |"


def _default(known: FieldInfo) -> str:
    if known.default_factory is not None:
        return "by the other fields"
    return _written(known.default)


def _written(default: object) -> str:
    """A default as a scene file has it."""
    match default:
        case None | () | []:
            return "none"
        case bool():
            return str(default).lower()
        case Part():
            return title_of(type(default)).lower()
        case tuple():
            return ", ".join(map(_written, default))
        case _:
            return f"{default:g}" if isinstance(default, float) else str(default)


def _sentence(text: str) -> str:
    return " ".join(text.replace("|", "or").split())
