import json
import os

import pytest

from workbench.analysis.benchmark import suite
from workbench.analysis.benchmark.comparison import Measured, table
from workbench.analysis.benchmark.names import BENCHMARKS

ROWS = [
    Measured("which way", "this", 2.0, 1.0, 1000, None),
    Measured("which way", "that", 5.0, 2.5, 1000, 1e-3),
]


@pytest.fixture
def fake_suite(monkeypatch):
    """Puts a benchmark in place of ``kernels``: rows, or exceptions to raise."""

    def put(*events):
        limits = []

        def measure(iterations, tell):
            limits.append(iterations)
            for event in events:
                tell("which way", "soon")
                if isinstance(event, BaseException):
                    raise event
                yield event

        def tables(rows):
            return (table("Ways", rows),)

        monkeypatch.setitem(suite.SUITE, "kernels", suite.Benchmark(measure, tables))
        return limits

    return put


def test_table_picture_and_json_agree(freeform, fake_suite, tmp_path):
    limits = fake_suite(*ROWS)
    folder = tmp_path / "new" / "folder"
    status, printed, told = freeform("benchmark", "kernels", "--output", folder)
    assert status == 0
    assert limits == [None]
    assert "kernels: which way  soon" in told
    markdown = table("Ways", ROWS).to_markdown()
    assert (folder / "kernels.md").read_text("utf-8") == markdown
    assert printed.rstrip().endswith(markdown.rstrip())
    assert (folder / "kernels.png").read_bytes().startswith(b"\x89PNG")
    kept = json.loads((folder / "kernels.json").read_text("utf-8"))
    assert kept["Ways"] == table("Ways", ROWS).to_data()
    assert {path.suffix for path in folder.iterdir()} == {".md", ".json", ".png"}


def test_json_is_one_object_and_last(freeform, fake_suite, tmp_path):
    limits = fake_suite(*ROWS)
    arguments = ("kernels", "--json", "--iterations", 7, "--output", tmp_path)
    status, printed, _ = freeform("benchmark", *arguments)
    assert status == 0
    assert limits == [7]
    data = json.loads(printed)
    assert data["machine"]["cores"] == len(os.sched_getaffinity(0))
    assert data["benchmarks"]["kernels"]["Ways"] == table("Ways", ROWS).to_data()


def test_ctrl_c_keeps_what_is_finished(freeform, fake_suite, tmp_path):
    fake_suite(ROWS[0], KeyboardInterrupt(), ROWS[1])
    arguments = ("kernels", "precision", "--json", "--output", tmp_path)
    status, printed, told = freeform("benchmark", *arguments)
    assert status == 130
    assert f"interrupted; what was finished is in {tmp_path}" in told
    data = json.loads(printed)
    assert data["benchmarks"]["kernels"]["Ways"] == table("Ways", ROWS[:1]).to_data()
    assert list(data["benchmarks"]) == ["kernels"]
    assert (tmp_path / "kernels.png").exists()


def test_ctrl_c_before_anything_is_finished(freeform, fake_suite, tmp_path):
    fake_suite(KeyboardInterrupt())
    status, _, told = freeform("benchmark", "kernels", "--output", tmp_path)
    assert status == 130 and "nothing was finished" in told
    assert list(tmp_path.iterdir()) == []


def test_an_unknown_name_is_refused_with_those_there_are(freeform, tmp_path):
    folder = tmp_path / "untouched"
    status, printed, told = freeform("benchmark", "kernels", "speed", "--output", folder)
    assert (status, printed) == (2, "")
    assert told == f"freeform: speed: is no benchmark; there are {', '.join(BENCHMARKS)}\n"
    assert not folder.exists()


def test_a_file_in_the_way_is_refused(freeform, fake_suite, tmp_path):
    limits = fake_suite(*ROWS)
    (tmp_path / "taken").write_text("")
    status, _, told = freeform("benchmark", "kernels", "--output", tmp_path / "taken")
    assert status == 2 and "cannot be made" in told
    assert limits == []


def test_help_lists_every_benchmark(capsys):
    from workbench.cli import main

    with pytest.raises(SystemExit):
        main(["benchmark", "--help"])
    printed = " ".join(capsys.readouterr().out.split())
    for name, does in BENCHMARKS.items():
        assert f" {name} {does} " in printed


def test_without_a_name_the_quick_one_runs(monkeypatch):
    from workbench.cli import main

    asked = []
    monkeypatch.setattr("workbench.cli.benchmark.benchmark", lambda *given: asked.append(given))
    assert main(["benchmark"]) == 0
    ((names, folder, iterations, as_json),) = asked
    assert (names, folder.name, iterations, as_json) == (["quick"], "benchmark", None, False)
