"""A process that is killed while it saves leaves the old file or the new one, whole."""

import gc
import itertools
import multiprocessing
import os
import time
from dataclasses import replace
from random import Random

import pytest

from tests.accounts import result_of
from workbench.design.session import KeptRun, Session
from workbench.files.export.write import export
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import FaceArrays

EXPORTS = ("lens.stl", "lens.obj", "lens.glb", "lens.height.npy", "lens.irradiance.csv")


@pytest.fixture
def make_session(make_scene, rng):
    def make(net, pixels, kept):
        scene = make_scene({"lens.control_points": [net, net], "screen.pixels": [pixels, pixels]})
        heights = 0.5 + 0.01 * rng.random((net, net))
        result = result_of(heights, rng.random((pixels, pixels)), rng.random(300))
        target = rng.random((pixels, pixels))
        runs = tuple(KeptRun(f"run {k}", scene, target, result) for k in range(kept))
        return Session(scene, target, result, runs=runs)

    return make


def save(session, folder):
    write_session(session, folder / "lens.freeform")


def export_all(session, folder):
    for _ in export(session, [folder / name for name in EXPORTS]):
        pass


def save_for_ever(write, sessions, folder, message):
    """Save one after the other again and again; report how long the first round took."""
    gc.freeze()  # a search for garbage would copy all memory of the process that was forked
    begin = time.monotonic()
    for round_ in itertools.count():
        for session in sessions:
            write(session, folder)
        if round_ == 0:
            message.send(time.monotonic() - begin)


def kill(write, sessions, folder, part):
    """Let a process save, and kill it in a part of a round; the temporary files that it left."""
    context = multiprocessing.get_context("fork")
    hears, message = context.Pipe(duplex=False)
    process = context.Process(target=save_for_ever, args=(write, sessions, folder, message))
    process.start()
    assert hears.poll(60)
    time.sleep(part * hears.recv())  # by its own clock, however loaded the machine is
    process.kill()
    process.join()
    assert process.exitcode == -9  # and not by an error of its own
    hears.close()
    message.close()
    return {name for name in os.listdir(folder) if name.endswith(".tmp")}


def check(write, first, tmp_path, kills):
    """Kill so often; every file must be byte by byte one of the two that were to be written."""
    sessions = replace(first, target=first.target[::-1], result=moved(first.result)), first
    folder, *wholes = (tmp_path / name for name in ("folder", "new", "old"))
    for session, whole in zip(sessions, wholes, strict=True):
        whole.mkdir()
        write(session, whole)
    folder.mkdir()
    write(first, folder)
    names = set(os.listdir(folder))
    random, broken_off, seen = Random(0), 0, set()
    for _ in range(kills):
        left = kill(write, sessions, folder, random.random())
        broken_off += bool(left)
        assert set(os.listdir(folder)) == names | left
        for name in names:
            content = (folder / name).read_bytes()
            now = [content == (whole / name).read_bytes() for whole in wholes]
            assert any(now), f"{name} is broken"
            seen |= {name, now.index(True)}
        write(first, folder)
        assert set(os.listdir(folder)) == names, "left behind"
    # The moments were such that both were found, and saving was broken off.
    assert {0, 1} <= seen
    assert broken_off > 0.1 * kills


def moved(result):
    return result.with_state(
        heights=FaceArrays({"lens.back": result.state.heights["lens.back"][::-1]})
    )


def test_a_session(make_session, tmp_path):
    check(save, make_session(5, 40, 1), tmp_path, kills=20)
    assert read_session(tmp_path / "folder" / "lens.freeform").runs[0].name == "run 0"


@pytest.mark.slow
@pytest.mark.timeout(3600)
@pytest.mark.parametrize(
    "write, size, kills",
    [(save, (8, 8, 0), 200), (save, (64, 512, 4), 200), (export_all, (8, 16, 0), 200)],
    ids=["small", "large", "exports"],
)
def test_many_times(make_session, tmp_path, write, size, kills):
    check(write, make_session(*size), tmp_path, kills)
