"""Draws the target of a session's scene, from the picture that it keeps or from the file."""

from dataclasses import replace
from pathlib import Path

from workbench.design.further_targets import with_targets, without_targets
from workbench.design.light_files import with_light
from workbench.design.picture import picture_of
from workbench.design.session import Session
from workbench.scene import Scene
from workbench.scene.viewing import drawing


def begin(scene: Scene, folder: Path) -> Session:
    """A session without a lens, its target drawn from the files that the scene names.

    `folder`: where a relative image path starts. Raises `Refused` if the target cannot be drawn, or
    a file of light cannot be used.
    """
    from workbench.targets import draw_target  # late: scipy.ndimage takes long to import

    scene = with_targets(with_light(scene, folder), folder)
    picture = picture_of(scene, folder)
    drawn = draw_target(scene, folder, picture)
    return Session(scene, drawn.light, picture=picture, remarks=drawn.remarks)


def with_task(session: Session, scene: Scene, folder: Path) -> Session:
    """The session after an edit, as by `Session.with_scene`, its target drawn anew if need be.

    The picture that the session keeps of an image counts, not its file: the design is the same on
    every machine, and stays so when somebody paints. Another image, and one of which the session
    keeps no picture, is read from its file.

    Raises `Refused` if the target cannot be drawn.
    """
    before = session.scene.in_unit(scene.unit)
    scene = with_targets(with_light(scene.with_contents_of(before), folder), folder)
    if drawing(scene) == drawing(before):
        return session.with_scene(scene, session.target)
    if session.picture is None or scene.image != session.scene.image:
        return _with_drawn(session, begin(scene, folder))
    from workbench.targets import draw_target  # late, as above

    drawn = draw_target(scene, folder, session.picture)
    return replace(session.with_scene(scene, drawn.light), remarks=drawn.remarks)


def with_file(session: Session, folder: Path) -> Session:
    """The session with its images read anew from their files.

    Raises `Refused` if the target cannot be drawn.
    """
    # Another target may be worth another net.
    scene = with_targets(without_targets(session.scene.with_net(None)), folder)
    return _with_drawn(session, begin(scene, folder))


def _with_drawn(session: Session, task: Session) -> Session:
    """The session after an edit, with the target of a task that has just been drawn."""
    edited = session.with_scene(task.scene, task.target)
    return replace(edited, picture=task.picture, remarks=task.remarks)
