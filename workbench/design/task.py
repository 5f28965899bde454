"""The targets and files of a session's scene, and for which task a lens was designed."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from operator import attrgetter
from pathlib import Path
from typing import Any

import numpy as np

from workbench.design.session import KeptRun, Session, task_of
from workbench.errors import Refused, refused_within
from workbench.measured.lamps import check_file
from workbench.messages import Message
from workbench.reading import opened
from workbench.scene import DrawnTarget, Scene
from workbench.scene.image import drawing
from workbench.scene.run import refused_in_stage

LARGEST_PICTURE = 16 << 20
"""Most bytes of an image file that a design keeps."""


def picture_of(scene: Scene, folder: Path) -> bytes | None:
    """The content of the target's image file.

    `scene`: its target is used; `folder`: where a relative image path starts. Returns None for a
    built-in shape, and for a file that cannot be read or is larger than `LARGEST_PICTURE`.
    """
    return None if scene.image is None else content_of(folder / scene.image)


def content_of(path: Path) -> bytes | None:
    """The content of a file; None if it cannot be read or is larger than `LARGEST_PICTURE`."""
    try:
        with opened(path) as file:
            content = file.read(LARGEST_PICTURE + 1)
    except Refused:  # whoever needs it says so
        return None
    return content if len(content) <= LARGEST_PICTURE else None


def why_not_kept(scene: Scene, picture: bytes | None) -> str:
    """A sentence for people whose design cannot keep its picture; empty where it does."""
    if picture is not None or scene.image is None:
        return ""
    return (
        f"The design does not keep {scene.image}, which has more than "
        f"{LARGEST_PICTURE >> 20} MB: the file is needed to draw the target anew."
    )


def changed_on_disk(scene: Scene, picture: bytes | None) -> bool:
    """Whether the file of a kept picture holds something else now; not where it is gone."""
    if picture is None or scene.image is None:
        return False
    try:
        with opened(Path(scene.image)) as file:
            return file.read(LARGEST_PICTURE + 1) != picture
    except Refused:
        return False


def with_light(scene: Scene, folder: Path) -> Scene:
    """The scene with what its sources' files hold, those that are not too large to be kept.

    `scene`: its sources are used. What they carry already stays; `folder`: where relative names
    start. Raises `Refused` if a file cannot be read or used.
    """
    missing = [name for name, data in scene.light_files.items() if data is None]
    if missing:
        scene = scene.carrying({name: content_of(folder / name) for name in missing})
    stages = len(scene.run.stages)
    for number in range(stages + 1):
        with refused_in_stage(number, stages, scene):
            check_file(scene.source_of(number))
    return scene


def why_light_is_not_kept(scene: Scene) -> str:
    """A sentence for people whose design cannot keep a file of light; empty where it does."""
    for name, data in scene.light_files.items():
        if data is None:
            return (
                f"The design does not keep {name}, which has more than "
                f"{LARGEST_PICTURE >> 20} MB: the file is needed wherever the design is used."
            )
    return ""


def with_targets(scene: Scene, folder: Path) -> Scene:
    """The scene with the targets of its further images drawn, those that have yet to be.

    `scene`: what it carries along of an image file counts, rather than the file; `folder`: where a
    relative image path starts. Raises `Refused` if a target cannot be drawn.
    """
    if len(scene.images) == 1:
        return scene
    from workbench.targets import draw_target  # late: scipy.ndimage takes long to import

    images = [scene.images[0]]
    for number, (alone, image) in enumerate(
        zip(scene.single[1:], scene.images[1:], strict=True), start=1
    ):
        if image.drawn.light is None:
            picture = image.drawn.picture or picture_of(alone, folder)
            with refused_within(f"images[{number}]"):
                drawn = draw_target(alone, folder, picture)
            image = image.drawn_as(DrawnTarget(drawn.light, picture, drawn.remarks))
        images.append(image)
    return scene.with_images(images)


def without_targets(scene: Scene) -> Scene:
    """The scene with the targets of its further images yet to be drawn, from their files."""
    images = (image.drawn_as(DrawnTarget()) for image in scene.images[1:])
    return scene.with_images((scene.images[0], *images))


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
    edited = session.with_scene(task.scene, task.target)
    return replace(edited, picture=task.picture, remarks=task.remarks)


_MOST = 3  # differences between two tasks that are named
_ABSENT = Message("absent")


def origin(session: Session, called: Callable[[KeptRun], str] = attrgetter("name")) -> Message:
    """What the lens of a session was designed for, to be read after "the lens, ".

    The lens is looked for among the kept runs. Run settings are no part of a task: they say how to
    search, not what for.

    `session`: whose lens; `called`: names a kept run. Returns for another task, with the name of
    the run and what differs.
    """
    heights = session.heights
    if heights is None:
        return Message("not designed yet")
    found = [run for run in session.runs if run.result.state.heights == heights]
    if any(_is_of(session, run) for run in found):
        return Message("designed for this task")
    if found:
        differ = _differences(found[-1], session)
        some = {f"field_{number}": words for number, words in enumerate(differ[:_MOST])}
        more = ", …" if len(differ) > _MOST else ""
        return Message(
            "designed for another task ({run}): {differences}",
            run=called(found[-1]),
            differences=Message(", ".join(f"{{{name}}}" for name in some) + more, **some),
        )
    if session.result is not None and session.result.iterations:
        return Message("designed for this task")
    return Message("not designed for this task")


def _is_of(session: Session, run: KeptRun) -> bool:
    same_target = np.array_equal(run.target, session.target)
    return same_target and task_of(run.scene) == task_of(session.scene)


def _differences(run: KeptRun, session: Session) -> list[Message]:
    then, now = (
        {path: value for path, value in _fields(each.scene.to_data(), "") if path[:4] != "run."}
        for each in (run, session)
    )
    changed = [
        Message(
            "{path} {then}, now {now}",
            path=path,
            then=then.get(path, _ABSENT),
            now=now.get(path, _ABSENT),
        )
        for path in (*then, *(now.keys() - then.keys()))
        if then.get(path) != now.get(path)
    ]
    return changed or [Message("another target image")]


def _fields(part: Any, path: str) -> Iterator[tuple[str, Any]]:
    if isinstance(part, dict):
        for name, value in part.items():
            yield from _fields(value, f"{path}.{name}" if path else name)
    elif isinstance(part, list) and any(isinstance(each, dict) for each in part):
        for number, each in enumerate(part):
            yield from _fields(each, f"{path}[{number}]")
    else:
        yield path, part
