"""The list of processes in the form, and presets."""

import pytest
from PySide6.QtWidgets import QInputDialog, QToolButton

from workbench.scene.making.presets import PRESETS


@pytest.fixture
def preset(document, open_forms):
    """The button that asks for a preset."""
    forms = open_forms(document)
    return next(each for each in forms.findChildren(QToolButton) if each.text() == "Preset…")


def test_a_preset_comes_with_its_source(document, preset, monkeypatch):
    asked = []

    def choose(_, title, label, items, **named):
        asked.extend(items)
        return items[0], True

    monkeypatch.setattr(QInputDialog, "getItem", choose)
    preset.click()
    (milling,) = document.session.scene.processes
    assert milling.scallop == pytest.approx(5e-4, rel=1e-3)  # cm
    assert asked[0] == "Milling: ball of 3 mm, scallops of 5 µm (typical value, no source)"
    assert len(asked) == len(PRESETS)


def test_none_is_added_where_none_is_chosen(document, preset, monkeypatch):
    monkeypatch.setattr(QInputDialog, "getItem", lambda *_, **named: ("", False))
    preset.click()
    assert document.session.scene.processes == ()
