import numpy as np
import pytest
from PIL import Image

from tests.accounts import result_of
from ui.document.document import Document
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.scene import Scene
from workbench.targets import load_target


def small_scene(**changes):
    return Scene.from_data(
        {
            "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [6, 5]},
            "source": {"kind": "collimated", "rays": [16, 16]},
            "screen": {"z": 5, "half_width": [1, 1], "pixels": [12, 10]},
            "target": {"builtin": "tophat"},
            "run": {"iterations": 3},
            **changes,
        }
    )


def lens_result():
    return result_of(np.full((6, 5), 0.5), np.ones((10, 12)), [2.0, 1.0])


def with_pixels(document, *pixels):
    scene = document.session.scene
    return scene.with_receiver(scene.receiver.model_copy(update={"pixels": pixels}))


def with_seed(document, seed):
    scene = document.session.scene
    return scene.model_copy(update={"run": scene.run.model_copy(update={"seed": seed})})


@pytest.fixture
def document(qapp, tmp_path):
    scene = small_scene()
    document = Document(Session(scene, load_target(scene, tmp_path)), "small")
    yield document
    document.deleteLater()


def move_screen(document, z, key="images[0].receiver.position[2]"):
    scene = document.session.scene
    document.edit(scene.with_receiver(scene.receiver.moved_to(float(z))), "change of screen", key)


def test_consecutive_edits_of_one_field_are_one_step(document):
    for z in (6, 7, 8):
        move_screen(document, z)
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.session.scene.receiver.z == 5


def test_edits_of_different_fields_are_steps_of_their_own(document):
    move_screen(document, 6)
    document.edit(with_seed(document, 3), "change of seed", "run.seed")
    move_screen(document, 7)
    assert document.undo_stack.count() == 3


def test_an_edit_that_changes_nothing_is_no_step(document):
    move_screen(document, 5)
    assert document.undo_stack.count() == 0
    assert not document.dirty


def test_an_edit_after_saving_does_not_merge_into_what_was_saved(document, tmp_path):
    move_screen(document, 6)
    document.save(tmp_path / "a.freeform")
    move_screen(document, 7)
    assert document.dirty
    document.undo_stack.undo()
    assert document.session.scene.receiver.z == 6
    assert not document.dirty


def test_another_screen_loads_the_target_for_its_pixels(document):
    document.edit(with_pixels(document, 20, 8), "pixels", "pixels")
    assert document.session.target.shape == (8, 20)
    document.undo_stack.undo()
    assert document.session.target.shape == (10, 12)


def test_a_missing_image_is_refused_only_where_it_is_read_again(document, tmp_path):
    image = tmp_path / "target.png"
    Image.fromarray(np.full((4, 4), 200, np.uint8)).save(image)
    scene = small_scene(target={"image": str(image)})
    document.edit(scene, "target", "target")
    image.unlink()
    document.edit(with_pixels(document, 9, 9), "pixels", "pixels")
    session = document.session
    assert session.target.shape == (9, 9)
    with pytest.raises(Refused, match=r"target\.png"):
        document.read_image_again()
    assert document.session is session


def test_a_relative_image_starts_beside_the_file(document, tmp_path):
    Image.fromarray(np.full((4, 4), 200, np.uint8)).save(tmp_path / "target.png")
    document.save(tmp_path / "design.freeform")
    document.edit(small_scene(target={"image": "target.png"}), "target", "target")
    assert document.session.scene.target.image == str(tmp_path / "target.png")


def test_another_lens_removes_the_result_and_undo_restores_it(document):
    document.set_result(lens_result(), "design run")
    document.edit(with_seed(document, 3), "change of seed", "run.seed")
    assert document.session.result is not None
    move_screen(document, 6)
    assert document.session.result is None
    document.undo_stack.undo()
    assert document.session.result is not None
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert document.session.result is None


def test_a_saved_design_opens_as_it_was(document, tmp_path):
    move_screen(document, 6)
    document.set_result(lens_result(), "design run")
    saved = document.session
    path = tmp_path / "design.freeform"
    document.save(path)
    move_screen(document, 9)
    document.open(path)
    assert document.path == path
    assert document.name == "design"
    assert not document.dirty
    assert document.undo_stack.count() == 0
    assert document.session.scene == saved.scene
    np.testing.assert_array_equal(document.session.target, saved.target)
    np.testing.assert_array_equal(
        document.session.result.state.heights["lens.back"], saved.result.state.heights["lens.back"]
    )
    np.testing.assert_array_equal(document.session.result.losses, saved.result.losses)


def test_a_scene_file_opens_as_an_untitled_design(document, tmp_path):
    path = tmp_path / "task.json"
    path.write_text(small_scene(unit="m").to_json())
    document.open(path)
    assert document.session.scene.unit == "m"
    assert document.path is None
    assert document.suggested_path == tmp_path / "task.freeform"


@pytest.mark.parametrize("content", [b"", b"{", b"PK\x03\x04 no zip at all", b'{"lens": 1}'])
def test_a_file_that_is_refused_leaves_the_open_design_untouched(document, tmp_path, content):
    document.save(tmp_path / "mine.freeform")
    move_screen(document, 6)
    session, path = document.session, document.path
    bad = tmp_path / "bad.freeform"
    bad.write_bytes(content)
    with pytest.raises(Refused):
        document.open(bad)
    assert document.session is session
    assert document.path == path
    assert document.dirty
    document.undo_stack.undo()
    assert document.session.scene.receiver.z == 5


def test_saving_where_nothing_can_be_written_keeps_the_design_dirty(document, tmp_path):
    move_screen(document, 6)
    with pytest.raises(Refused):
        document.save(tmp_path / "missing" / "design.freeform")
    assert document.dirty
    assert document.path is None
