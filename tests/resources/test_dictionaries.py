import re
from pathlib import Path

import pytest

import resources
from resources import dictionaries
from ui.commands.actions import MENUS
from ui.commands.table import COMMANDS
from ui.words import LANGUAGES

ROOT = Path(dictionaries.__file__).parent.parent
FOLDER = resources.path("translations")
TRANSLATED = [code for code in LANGUAGES if code != "en"]
CURE = "run `python -m resources.dictionaries`, translate what it lists, and run it again"

_BRACES = re.compile(r"\{[^}]*\}")


@pytest.fixture(scope="module")
def texts():
    """All texts of the window, and the files that they are in."""
    return dictionaries.keys()


@pytest.fixture(scope="module", params=TRANSLATED)
def dictionary(request):
    """The file of a language, and what stands in it."""
    file = FOLDER / f"{request.param}.ts"
    return file, dictionaries.translations(file)


def test_each_text_of_the_window_is_in_both_dictionaries_and_no_other_is(dictionary, texts):
    file, found = dictionary
    missing = {text: place for text, place in texts.items() if text not in found}
    assert not missing, f"{file} lacks texts by now: {CURE}"
    assert not found.keys() - texts.keys(), f"{file} has texts that are gone: {CURE}"


def test_each_translation_is_finished(dictionary):
    file, found = dictionary
    assert [text for text, stated in found.items() if not stated] == [], f"{file}: {CURE}"


def test_a_translation_has_the_values_mnemonic_and_ellipsis_of_its_text(dictionary):
    _, found = dictionary
    for text, stated in found.items():
        assert sorted(_BRACES.findall(stated)) == sorted(_BRACES.findall(text)), text
        assert stated.count("&") == text.count("&"), text
        assert stated.endswith("…") is text.endswith("…"), text


def test_compiled_dictionaries_are_what_their_sources_give(dictionary, tmp_path):
    file, _ = dictionary
    compiled = tmp_path / "compiled.qm"
    dictionaries.compile_to(file, compiled)
    assert compiled.read_bytes() == file.with_suffix(".qm").read_bytes(), CURE


def mnemonics(entries, stated):
    """Mnemonics of a menu, by letter, and those of menus within it."""
    found: dict[str, list[str]] = {}
    for entry in entries:
        if entry is None:
            continue
        text = entry[0] if isinstance(entry, tuple) else COMMANDS[entry].text
        text = stated.get(text.replace("{optic}", "lens"), text)
        if "&" in text:
            found.setdefault(text[text.index("&") + 1].lower(), []).append(text)
    return found


def menus(entries):
    """Entries of menus, and of those within them."""
    yield entries
    for entry in entries:
        if isinstance(entry, tuple):
            yield from menus(entry[1])


def test_no_two_entries_of_a_menu_have_one_mnemonic(dictionary):
    _, stated = dictionary
    for entries in menus([*MENUS.items()]):
        shared = [texts for texts in mnemonics(entries, stated).values() if len(texts) > 1]
        assert not shared


def test_fixed_sentences_of_the_engine_are_collected_from_its_code(texts):
    for text in (
        "all control points are locked",
        "all iterations are done",
        "designed for this task",
        "not designed for this task",
        "not designed yet",
        "stopped",
    ):
        file = ROOT / texts[text]
        assert file.is_relative_to(ROOT / "workbench" / "design")
        assert text in file.read_text(encoding="utf-8")


def test_sentences_of_the_optic_are_there_for_each_optic(texts):
    assert {f"There is no {optic} yet; Start designs one" for optic in ("lens", "mirror")} <= {
        *texts
    }
    assert not [text for text in texts if "{optic}" in text or "{receiver}" in text]
