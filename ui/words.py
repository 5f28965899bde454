"""Translation: English is the key, and is shown where there is no translation.

Whole sentences are translated: ``tr("{file} is written.").format(file=path)``. Nouns for element
and receiver are put in first: ``tr("There is no {optic} yet", optic="mirror")`` has a translation
for each. `later` marks texts in tables of modules, which go through `tr` where they are shown.
`resources.dictionaries` collects all texts.
"""

from typing import TypeVar

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

import resources
from workbench.errors import Refused, RunFailed
from workbench.messages import Message
from workbench.messages import capitalised as capitalised

LANGUAGES = {"en": "English", "de": "Deutsch", "fr": "Français"}
"""Names by codes; see resources/translations for all but the first."""

_CONTEXT = "workbench"
_NOUNS_ARE_LARGE = ("de",)

Texts = TypeVar("Texts")

_language = "en"


def tr(text: str, *, optic: str = "", receiver: str = "") -> str:
    """Translate a text or message into the language of the window."""
    if isinstance(text, Message):
        return _translated(text)
    if optic:
        text = text.replace("{optic}", optic)
    if receiver:
        text = text.replace("{receiver}", receiver)
    return QCoreApplication.translate(_CONTEXT, text) if text else ""


def _translated(message: Message) -> str:
    values = {
        name: tr(value) if isinstance(value, Message) else value
        for name, value in message.values.items()
    }
    kinds = {name: str(values[name]) for name in ("optic", "receiver") if name in values}
    return tr(message.words, **kinds).format(**values)


def error_text(error: Refused | RunFailed) -> str:
    """Return the message of an engine error, translated; paths of fields stay as in scene files."""
    if isinstance(error, Refused):
        return f"{error.path}: {tr(error.reason)}"
    return tr(*error.args)


def later(texts: Texts) -> Texts:
    """Mark texts, or a table with some, for translation where they are shown."""
    return texts


def in_sentence(text: str) -> str:
    """Return a title as it stands inside a sentence; abbreviations and German nouns stay large."""
    if _language in _NOUNS_ARE_LARGE or text[1:2].isupper():
        return text
    return text[:1].lower() + text[1:]


def system_language() -> str:
    """First of the system's languages among `LANGUAGES`; English by default."""
    wanted = (name.partition("-")[0] for name in QLocale.system().uiLanguages())
    return next((code for code in wanted if code in LANGUAGES), "en")


def set_language(application: QCoreApplication, language: str) -> None:
    """Set the language of texts that are shown from now on."""
    global _language
    code = system_language() if language == "system" else language
    if code not in LANGUAGES:
        raise ValueError(f"{code!r} is none of {', '.join(LANGUAGES)}")
    for before in application.findChildren(QTranslator):
        application.removeTranslator(before)
        before.deleteLater()
    _language = code
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
    """Translate the title of a field with its parts: ``Lens · Half width``."""
    return " · ".join(map(tr, title.split(" · ")))
