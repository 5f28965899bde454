import dataclasses
from pathlib import Path

from PIL import Image

from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.files.session import Session
from workbench.pictures import write_pictures
from workbench.targets import load_target


def test_writes_three_pictures_of_a_result(make_scene, tmp_path):
    scene = make_scene({"run.iterations": 2})
    target = load_target(scene, Path.cwd())
    history = History()
    for snapshot in run(scene, target):
        history.add(snapshot)
    session = Session(scene, target)
    assert write_pictures(session, tmp_path) == []
    session = dataclasses.replace(session, result=history.result())
    written = write_pictures(session, tmp_path)
    assert [path.name for path in written] == ["irradiance.png", "lens.png", "loss.png"]
    for path in written:
        with Image.open(path) as picture:
            low, high = picture.convert("L").getextrema()
            assert low < 60 and high > 200
