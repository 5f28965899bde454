"""Words in the language of the person: English is the key, and what is shown without another.

Whole sentences are translated, with their values in braces: ``tr("{file} is written.")`` and then
``.format(file=path)``. Words for the optic and the receiver have a grammar, and are put in before:
``tr("There is no {optic} yet", optic="mirror")`` has a translation for each optic. What stands in
tables of modules is marked by `later`, since no language is chosen yet, and goes through `tr` where
it is shown. So does what the engine says of itself.

`resources.translations` collects all of it.
"""

import unicodedata
from typing import TypeVar

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

import resources
from workbench.errors import Refused, RunFailed
from workbench.said import Said

LANGUAGES = {"en": "English", "de": "Deutsch", "fr": "Français"}
"""Names by codes; see resources/translations for all but the first."""

_CONTEXT = "workbench"
_NOUNS_ARE_LARGE = ("de",)

Texts = TypeVar("Texts")

_spoken = "en"


def tr(text: str, *, optic: str = "", receiver: str = "") -> str:
    """A text in the language that is spoken; as it is where that has no words for it."""
    if isinstance(text, Said):
        return _said(text)
    if optic:
        text = text.replace("{optic}", optic)
    if receiver:
        text = text.replace("{receiver}", receiver)
    return QCoreApplication.translate(_CONTEXT, text) if text else ""


def _said(said: Said) -> str:
    values = {
        name: tr(value) if isinstance(value, Said) else value for name, value in said.values.items()
    }
    kinds = {name: str(values[name]) for name in ("optic", "receiver") if name in values}
    return tr(said.words, **kinds).format(**values)


def error_text(error: Refused | RunFailed) -> str:
    """What an error of the engine says, in the language that is spoken.

    Paths of fields stay as scene files have them.
    """
    if isinstance(error, Refused):
        return f"{error.path}: {tr(error.reason)}"
    return tr(*error.args)


def later(texts: Texts) -> Texts:
    """Texts as they are, or a table with some; they go through `tr` where they are shown."""
    return texts


def inside(text: str) -> str:
    """A title as it stands inside of a sentence of the language that is spoken.

    Abbreviations stay large; in German all does, as its nouns are.
    """
    if _spoken in _NOUNS_ARE_LARGE or text[1:2].isupper():
        return text
    return text[:1].lower() + text[1:]


def begun(text: str) -> str:
    """A text as it stands at the beginning of a sentence; symbols as λ stay small."""
    if not (text and unicodedata.name(text[0], "").startswith("LATIN")):
        return text
    return text[0].upper() + text[1:]


def spoken() -> str:
    """The language that is spoken, as one of `LANGUAGES`."""
    return _spoken


def spoken_by_system() -> str:
    """The first language of the system's that is one of `LANGUAGES`; English if none is."""
    wanted = (name.partition("-")[0] for name in QLocale.system().uiLanguages())
    return next((code for code in wanted if code in LANGUAGES), "en")


def speak(application: QCoreApplication, language: str) -> None:
    """Say all that is said from now on in a language; what is shown already stays as it is."""
    global _spoken
    code = spoken_by_system() if language == "system" else language
    if code not in LANGUAGES:
        raise ValueError(f"{code!r} is none of {', '.join(LANGUAGES)}")
    for before in application.findChildren(QTranslator):
        application.removeTranslator(before)
        before.deleteLater()
    _spoken = code
    if code == "en":
        return
    own = QTranslator(application)
    if not own.load(str(resources.path("translations", f"{code}.qm"))):
        raise RuntimeError(f"no dictionary for {code}: the installation is not complete")
    application.installTranslator(own)
    of_qt = QTranslator(application)  # OK, Cancel, and all that is in its dialogs
    if of_qt.load(f"qtbase_{code}", QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)):
        application.installTranslator(of_qt)


def field_title(title: str) -> str:
    """The title of a field with those of the parts that it is in: ``Lens · Half width``."""
    return " · ".join(map(tr, title.split(" · ")))
