"""Keeps the dictionaries of the window in resources/translations.

Run ``python -m resources.dictionaries`` after a change to any text that a person reads in the
window. It collects these texts from `tr` and `later` in the code and from what commands, examples
and the engine say of themselves, writes them into ``de.ts`` and ``fr.ts``, new ones as unfinished
and without those that are gone, and compiles these to ``.qm``. What it lists as unfinished is then
translated there, by hand or with Qt Linguist, and the command is run again.
"""

import ast
import re
import subprocess
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import PySide6

import resources
from ui.commands.actions import MENUS
from ui.commands.panes import PANES
from ui.commands.table import COMMANDS
from ui.words import LANGUAGES
from workbench.analysis.inspection.options import InspectionOptions
from workbench.analysis.making.photograph_options import PhotographOptions
from workbench.analysis.making.plan_options import PlanOptions
from workbench.analysis.shop_limits import Limits
from workbench.analysis.tolerance_fields import ABOUT
from workbench.design.snapshot import ENDINGS, FAILED
from workbench.files.export.options import GROUPS
from workbench.jobs import JOBS
from workbench.materials import CATALOGUE
from workbench.optics.account import LOSSES, words_of
from workbench.option_groups import OptionGroup
from workbench.pictures.manufacture import LEGEND, MAPS
from workbench.pictures.surface import ASPECTS
from workbench.refusals import SENTENCES
from workbench.scene import FarField, Lens, Mirror, Part, Scene, Screen, Unit
from workbench.scene.fields import BOUNDS, LeftOut
from workbench.scene.part import Kinds, summary_of, title_of
from workbench.units import WRITTEN

CONTEXT = "workbench"
OPTICS, RECEIVERS = (Lens, Mirror), (Screen, FarField)

_ROOT = Path(__file__).parent.parent
_MARKS = ("tr", "later", "Message")
_NO_TEXT = re.compile(r"[\W\d_]*|\.?[a-z_]+")


def keys() -> dict[str, str]:
    """All texts that are translated, and where each stands first, in the order of the places."""
    found: dict[str, str] = {}
    for text, place in _all():
        for key in _of_each_kind(text):
            found.setdefault(key, place)
    return found


def _all() -> Iterator[tuple[str, str]]:
    """Texts and their places."""
    for title, entries in MENUS.items():
        yield from ((text, "ui/commands/actions.py") for text in _menu(title, entries))
    for command in COMMANDS.values():
        yield from ((text, "ui/commands/table.py") for text in (command.text, command.tip))
    yield from ((pane.title, "ui/commands/panes.py") for pane in PANES.values())
    for file in sorted((_ROOT / "ui").rglob("*.py")):
        yield from ((text, file.relative_to(_ROOT).as_posix()) for text in marked(file))
    for example in resources.EXAMPLES:
        yield from (
            (text, "resources/__init__.py") for text in (example.group, example.title, example.look)
        )
    yield from ((text, "workbench") for text in _of_engine())
    yield from ((text, "workbench/design/snapshot.py") for text in (*ENDINGS, FAILED))
    for file in sorted((_ROOT / "workbench").rglob("*.py")):
        if "Message(" in file.read_text(encoding="utf-8"):
            yield from ((text, file.relative_to(_ROOT).as_posix()) for text in marked(file))


def _menu(title: str, entries: list[Any]) -> Iterator[str]:
    yield title
    for entry in entries:
        if isinstance(entry, tuple):
            yield from _menu(*entry)


def _of_engine() -> Iterator[str]:
    """What the engine says of itself, as far as the window shows it as it is."""
    for optic in OPTICS:
        yield from (optic.called, optic.face_called, "entrance face")
    for receiver in RECEIVERS:
        density = receiver.density
        yield from (receiver.called, receiver.place, density, density.capitalize())
        for loss in ("on_screen", *LOSSES):
            yield from words_of(loss, receiver)
    seen: set[type[Part]] = set()
    parts: tuple[type[Part], ...] = (Scene, *JOBS)
    for part in parts:
        yield from _of_part(part, seen)
    yield from BOUNDS.values()
    yield from (text for each in LOSSES.values() for text in (each.where, each.cure))
    yield from (optic.body_called for optic in OPTICS)
    yield from SENTENCES.values()
    groups: tuple[type[OptionGroup], ...] = (
        *GROUPS,
        Limits,
        PlanOptions,
        PhotographOptions,
        InspectionOptions,
    )
    for _, option in (each for group in groups for each in group.about()):
        yield from (option.title, option.tip, option.empty, *_worded(option.choices.values()))
    for tolerance in ABOUT.values():
        yield from (tolerance.title, tolerance.tip)
    for aspect in ASPECTS:
        yield from (aspect.name, aspect.tip)
    yield from (*MAPS, *LEGEND)
    yield from (name for name in CATALOGUE if " " in name)  # others are codes


def _worded(titles: Iterable[str]) -> Iterator[str]:
    """Titles that are words, not names, sizes or units."""
    return (title for title in titles if title[0].islower() and title not in WRITTEN)


def _of_part(part: type[Part], seen: set[type[Part]]) -> Iterator[str]:
    """What a part of the scene says of itself and of its fields."""
    if part in seen:
        return
    seen.add(part)
    if part is not Scene:
        yield from (title_of(part), summary_of(part))
    for field in part.fields():
        if not (field.tip or field.parts):
            continue
        yield from (field.title, field.tip)
        if kinds := field.mark(Kinds):
            yield kinds.title
        if left_out := field.mark(LeftOut):
            yield left_out.title
        if field.type != Unit:  # which is the same in all languages
            yield from (title for _, title in field.choices)
        shown = field.in_window
        yield from (shown.title, shown.tip, *(member.title for member in field.members))
        if field.between.isalpha():
            yield field.between
        if " " in field.measure.sign:  # units are the same everywhere
            yield field.measure.sign
        for each in field.parts:
            assert issubclass(each, Part)
            yield from _of_part(each, seen)


def marked(file: Path) -> Iterator[str]:
    """Texts in the calls of `tr`, `later` and `Message` in a file of Python, in their order."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call) and node.args]
    for call in sorted(calls, key=lambda call: (call.lineno, call.col_offset)):
        if isinstance(call.func, ast.Name) and call.func.id in _MARKS:
            yield from _texts(call.args[0])


def _texts(node: ast.AST) -> Iterator[str]:
    """Texts in an argument: itself, or those of a table; names and endings of files are none."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
        return
    inner: list[ast.expr | None] = []
    if isinstance(node, ast.Dict):
        inner = [part for entry in zip(node.keys, node.values, strict=True) for part in entry]
    elif isinstance(node, ast.Tuple | ast.List):
        inner = [*node.elts]
    elif isinstance(node, ast.Call) and getattr(node.func, "id", "") not in _MARKS:
        inner = [*node.args]
    for each in inner:
        if each is not None:
            yield from (text for text in _texts(each) if not _NO_TEXT.fullmatch(text))


def _of_each_kind(text: str) -> Iterator[str]:
    """A text with what each kind of optic and receiver is called, where it speaks of one."""
    texts = [text] if text else []
    for name, kinds in (("{optic}", OPTICS), ("{receiver}", RECEIVERS)):
        texts = [
            each.replace(name, kind.called)
            for each in texts
            for kind in (kinds if name in each else kinds[:1])
        ]
    return iter(texts)


def translations(file: Path) -> dict[str, str]:
    """Translations of a .ts file by their keys; empty for those that are not finished."""
    found = {}
    if file.exists():
        for message in ElementTree.parse(file).iter("message"):
            translation = message.find("translation")
            done = translation is not None and translation.get("type") != "unfinished"
            text = translation.text if translation is not None and done else ""
            found[message.findtext("source") or ""] = text or ""
    return found


def write(file: Path, language: str, places: dict[str, str], known: dict[str, str]) -> list[str]:
    """Write a .ts file of all keys; those without a translation."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ElementTree.SubElement(root, "context")
    ElementTree.SubElement(context, "name").text = CONTEXT
    unfinished = []
    for key, place in places.items():
        message = ElementTree.SubElement(context, "message")
        ElementTree.SubElement(message, "location", filename=f"../../{place}")
        ElementTree.SubElement(message, "source").text = key
        translation = ElementTree.SubElement(message, "translation")
        translation.text = known.get(key, "")
        if not translation.text:
            translation.set("type", "unfinished")
            unfinished.append(key)
    ElementTree.indent(root, "    ")
    text = ElementTree.tostring(root, encoding="unicode")
    file.write_text(
        f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{text}\n', encoding="utf-8"
    )
    return unfinished


def compile_to(source: Path, target: Path) -> None:
    """Compile a .ts file to a .qm file."""
    program = Path(PySide6.__file__).parent / (
        "lrelease.exe" if sys.platform == "win32" else "lrelease"
    )
    subprocess.run([program, "-silent", source, "-qm", target], check=True)


def make(folder: Path) -> dict[str, list[str]]:
    """Bring all dictionaries up to date; what is unfinished in each, by language."""
    places, unfinished = keys(), {}
    for language in LANGUAGES:
        if language != "en":
            file = folder / f"{language}.ts"
            unfinished[language] = write(file, language, places, translations(file))
            compile_to(file, file.with_suffix(".qm"))
    return unfinished


if __name__ == "__main__":
    for language, texts in make(resources.path("translations")).items():
        print(f"{language}: {len(texts)} unfinished", *texts, sep="\n    ")
