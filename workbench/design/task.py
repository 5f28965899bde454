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

    Parameters
    ----------
    scene : Scene
        The task.
    folder : Path
        Where a relative image path starts.

    Raises
    ------
    Refused
        If the target cannot be drawn, or a file of light cannot be used.
    """
    from workbench.targets import load_target  # late: scipy.ndimage takes long to import

    scene = with_targets(with_light(scene, folder), folder)
    picture = picture_of(scene, folder)
    return Session(scene, load_target(scene, folder, picture), picture=picture)


def with_task(session: Session, scene: Scene, folder: Path) -> Session:
    """The session after an edit, as by `Session.with_scene`, its target drawn anew if need be.

    The picture that the session keeps of an image counts, not its file: the design is the same on
    every machine, and stays so when somebody paints. Another image, and one of which the session
    keeps no picture, is read from its file.

    Raises
    ------
    Refused
        If the target cannot be drawn.
    """
    before = session.scene.in_unit(scene.unit)
    scene = with_targets(with_light(scene.with_contents_of(before), folder), folder)
    if drawing(scene) == drawing(before):
        return session.with_scene(scene, session.target)
    if session.picture is None or scene.image != session.scene.image:
        task = begin(scene, folder)
        return replace(session.with_scene(scene, task.target), picture=task.picture)
    from workbench.targets import load_target  # late, as above

    return session.with_scene(scene, load_target(scene, folder, session.picture))


def with_file(session: Session, folder: Path) -> Session:
    """The session with its images read anew from their files.

    Raises
    ------
    Refused
        If the target cannot be drawn.
    """
    # Another target may be worth another net.
    scene = with_targets(without_targets(session.scene.with_net(None)), folder)
    task = begin(scene, folder)
    return replace(session.with_scene(scene, task.target), picture=task.picture)
