"""The fields of a mirror are shown where a scene has one, and those of a lens are not."""

from ui.document.document import Document
from workbench.files.session import Session
from workbench.scene import Scene


def mirrored(**parts):
    return Scene.from_data(
        {
            **parts,
            "mirror": {"half_width": [1.0, 1.0], "control_points": [8, 8]},
            "source": {"kind": "collimated"},
            "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )


def titles(forms):
    return [panel._heading.text() for panel in forms.panels if panel.isVisibleTo(forms)]


def test_a_scene_with_a_mirror_shows_its_fields(qapp, open_forms, session):
    document = Document(Session(mirrored(), session.target[:16, :16] + 1.0), "mirror")
    forms = open_forms(document)
    assert "Mirror" in titles(forms)
    assert "Lens" not in titles(forms)


def test_a_scene_with_a_lens_does_not(forms):
    assert "Lens" in titles(forms)
    assert "Mirror" not in titles(forms)
