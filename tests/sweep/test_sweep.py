import csv
import json
import os
import signal
import threading
from pathlib import Path

import numpy as np
import pytest

from tests.accounts import result_of
from workbench.errors import Refused
from workbench.files.session import Session, read_session
from workbench.scene import Scene
from workbench.sweep.cluster import Cluster
from workbench.sweep.points import Variation, key_of, points, points_of
from workbench.sweep.processes import DesignTask, Done, Failed, Processes, attempt
from workbench.sweep.sweep import Store, sweep

RAYS = 10_000
CHECK = {
    "loss": 0.25,
    "relative_l2": 0.25,
    "relative_l2_corrected": 0.125,
    "relative_l2_corrected_interval": [0.0, 0.2],
    "efficiency": 0.75,
}


@pytest.fixture
def scene_file(tmp_path, scene_data):
    scene_data["run"] = {"method": "paper", "iterations": 1}
    path = tmp_path / "hat.json"
    path.write_text(json.dumps(scene_data))
    return path


@pytest.fixture
def store(tmp_path):
    return Store(tmp_path / "out")


class Here:
    """Works at once, on as many tasks as it may."""

    def __init__(self, most=1000):
        self.asked = []
        self._most = most

    def work(self, tasks):
        for key, task in tasks:
            if len(self.asked) == self._most:
                raise KeyboardInterrupt
            self.asked.append(task.scene)
            if task.scene.run.seed == 2:
                yield key, Failed("stopped at iteration 3: no light")
                continue
            n_x, n_y = task.scene.receiver.pixels
            heights = np.full(task.scene.optic.net_shape, 0.5)
            result = result_of(heights, np.ones((n_y, n_x)), np.zeros(3), seconds=2.5)
            yield key, Done(result, CHECK)


def rows(found, store, workers):
    return [row for _, row in sorted(sweep(found, store, workers, RAYS), key=lambda each: each[0])]


class TestPoints:
    def test_the_last_field_changes_first(self, scene_file):
        vary = [Variation("run.seed", (0, 1)), Variation("images[0].receiver.position[2]", (5, 6))]
        found = points([scene_file], vary)
        assert [(p.scene.run.seed, p.scene.receiver.z) for p in found] == [
            (0, 5),
            (0, 6),
            (1, 5),
            (1, 6),
        ]
        assert found[3].name == "hat run.seed=1 images[0].receiver.position[2]=6"

    def test_processes_and_uncertainty_vary(self, make_scene):
        milled = {"processes": [{"kind": "milling", "ball_radius": 0.3, "step_over": 0.02}]}
        scene = Scene.from_data(make_scene().to_data() | milled)
        vary = [
            Variation.parse("processes[0].step_over=0.01,0.4"),
            Variation.parse("uncertainty.index=0,0.01"),
        ]
        session = Session(scene, np.ones((32, 32)))
        (_, found, *refused) = (point.scene for point in points_of([(Path("hat"), session)], vary))
        assert found.processes[0].step_over == 0.01 and found.uncertainty.index == 0.01
        assert all("leaves ridges of the tool's own size" in str(each) for each in refused)

    def test_an_impossible_point_is_kept_with_its_refusal(self, scene_file):
        bad, good = points([scene_file], [Variation("lens.back.control_points", (3, 12))])
        assert str(bad.scene).startswith("elements[0].faces[1].control_points[0]: 3 is too few")
        assert good.scene.optic.control_points == (12, 12)

    def test_keys_tell_what_a_result_depends_on(self, make_scene):
        target = np.ones((32, 32))
        keys = {
            key_of(Session(make_scene(changes), image), rays)
            for changes, image, rays in (
                ({}, target, RAYS),
                ({"run.seed": 1}, target, RAYS),
                ({}, 2 * target, RAYS),
                ({}, target, RAYS + 1),
            )
        }
        assert len(keys) == 4
        image = make_scene({"target": {"image": "/somewhere/else.png"}})
        assert key_of(Session(image, target), RAYS) in keys  # which image it was is all the same


class TestSweep:
    @pytest.fixture
    def found(self, scene_file):
        return points([scene_file], [Variation("run.seed", (0, 1, 2, 3))])

    def test_each_point_has_its_session(self, found, store):
        made = rows(found, store, Here())
        assert [row.changes for row in made] == [{"run.seed": str(seed)} for seed in range(4)]
        assert made[2].reason == "stopped at iteration 3: no light"
        assert made[2].session is None
        assert read_session(store.folder / made[3].session).scene.run.seed == 3
        assert made[3].figures == {
            **{name: CHECK[name] for name in ("loss", "relative_l2", "efficiency")},
            "relative_l2_corrected": 0.125,
            "relative_l2_corrected_low": 0.0,
            "relative_l2_corrected_high": 0.2,
            "iterations": 3.0,
            "seconds": 2.5,
        }

    def test_finished_points_are_not_computed_again(self, found, store):
        with pytest.raises(KeyboardInterrupt):
            rows(found, store, Here(most=2))
        again = Here()
        made = rows(found, store, again)
        assert [scene.run.seed for scene in again.asked] == [2, 3]
        assert all(row.session for row in made[:2])
        last = Here()
        assert rows(found, store, last) == made
        assert [scene.run.seed for scene in last.asked] == [2]  # what failed is tried again

    def test_one_sweep_at_a_time_works_in_a_folder(self, found, store):
        other = Store(store.folder)
        with store.locked():
            with pytest.raises(Refused, match="out: another sweep is at work"), other.locked():
                pytest.fail("two at a time")
            rows(found, store, Here())
        with other.locked():
            pass
        assert not [path for path in store.folder.iterdir() if "lock" in path.name]

    def test_table(self, found, store):
        made = rows(found, store, Here())
        store.write_table(made)
        with (store.folder / "table.csv").open(newline="") as file:
            table = list(csv.DictReader(file))
        assert [row["run.seed"] for row in table] == ["0", "1", "2", "3"]
        assert [float(row["relative_l2"] or "nan") for row in table[:2]] == [0.25, 0.25]
        assert table[2]["reason"] == "stopped at iteration 3: no light"
        data = json.loads((store.folder / "table.json").read_text())["points"]
        assert data[3]["session"] == made[3].session


class TestWorkers:
    @pytest.fixture
    def task(self, make_scene):
        scene = make_scene({"run": {"method": "paper", "iterations": 1}})
        return DesignTask(scene, np.ones((32, 32)), RAYS)

    def test_processes_give_the_same_and_survive_a_killed_point(self, task):
        impossible = task._replace(target=np.zeros((3, 3)))
        with Processes(1, 1) as workers:
            workers._idle.append(workers._start())
            (process,) = workers._all.values()
            tasks = [(1, task), (2, task), (3, impossible)]
            found = dict(workers.work(killing(process, tasks)))
        assert found[1] == Failed("its process ended with exit status -9")
        assert not process.is_alive()
        here = attempt(task, 1)
        assert found[2].check == here.check
        assert np.array_equal(
            found[2].result.state.heights["lens.back"], here.result.state.heights["lens.back"]
        )
        assert found[3].reason.startswith("unexpected ")

    @pytest.mark.full
    def test_a_cluster_gives_the_same(self, task):
        distributed = pytest.importorskip("distributed")
        with (
            distributed.LocalCluster(
                n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
            ) as local,
            Cluster(local.scheduler_address) as workers,
        ):
            impossible = task._replace(target=np.zeros((3, 3)))
            tasks = [(1, task), (2, impossible), (3, task), (4, task)]
            found = dict(workers.work(iter(tasks)))
        assert found[1].check == attempt(task).check
        assert found[2].reason.startswith("unexpected ")
        assert sorted(found) == [1, 2, 3, 4]


def killing(process, tasks):
    """Tasks; the process gets the first of them and is killed before it does anything."""
    os.kill(process.pid, signal.SIGSTOP)
    threading.Timer(0.2, process.kill).start()
    yield from tasks
