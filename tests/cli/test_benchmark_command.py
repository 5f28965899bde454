import json

import pytest

from workbench.analysis.benchmark import leds, suite
from workbench.analysis.benchmark.leds import LedDesign
from workbench.analysis.benchmark.names import BENCHMARKS

ROWS = [
    LedDesign("flat, freeform", seconds=16.0, efficiency=0.64, deviation=0.05),
    LedDesign("freeform, freeform", seconds=30.0, efficiency=0.8, deviation=0.04),
]


@pytest.fixture
def fake_suite(monkeypatch):
    """Puts a benchmark in place of ``led``: rows, or exceptions to raise."""

    def put(*events):
        limits = []

        def measure(settings, report):
            limits.append(settings.iterations)
            for event in events:
                report("which way", "soon")
                if isinstance(event, BaseException):
                    raise event
                yield event

        def tables(rows):
            return (leds.table(rows),)

        monkeypatch.setitem(suite.SUITE, "led", suite.Benchmark(measure, tables))
        return limits

    return put


def test_table_picture_and_json_agree(freeform, fake_suite, tmp_path):
    limits = fake_suite(*ROWS)
    folder = tmp_path / "new" / "folder"
    status, stdout, stderr = freeform("benchmark", "led", "--output", folder)
    assert status == 0
    assert limits == [None]
    assert "led: which way  soon" in stderr
    markdown = leds.table(ROWS).to_markdown()
    assert (folder / "led.md").read_text("utf-8") == markdown
    assert stdout.rstrip().endswith(markdown.rstrip())
    assert (folder / "led.png").read_bytes().startswith(b"\x89PNG")
    kept = json.loads((folder / "led.json").read_text("utf-8"))
    assert kept[leds.table(ROWS).title] == leds.table(ROWS).to_data()
    assert {path.suffix for path in folder.iterdir()} == {".md", ".json", ".png"}
    status, _, stderr = freeform("benchmark", "led", "--pixels", 512, "--output", folder)
    assert status == 2 and "led: has no pictures; --pixels is for pictures" in stderr


def test_ctrl_c_keeps_what_is_finished(freeform, fake_suite, tmp_path):
    fake_suite(ROWS[0], KeyboardInterrupt(), ROWS[1])
    arguments = ("led", "bound", "--json", "--output", tmp_path)
    status, stdout, stderr = freeform("benchmark", *arguments)
    assert status == 130
    assert f"interrupted; what was finished is in {tmp_path}" in stderr
    data = json.loads(stdout)
    assert data["benchmarks"]["led"][leds.table(ROWS).title] == leds.table(ROWS[:1]).to_data()
    assert list(data["benchmarks"]) == ["led"]
    assert (tmp_path / "led.png").exists()


def test_help_lists_every_benchmark(capsys):
    from workbench.cli import main

    with pytest.raises(SystemExit):
        main(["benchmark", "--help"])
    stdout = " ".join(capsys.readouterr().out.split())
    for name, does in BENCHMARKS.items():
        assert f" {name} {does} " in stdout
