import json

import pytest

FEW = ("--samples", 4, "--rays", 10_000)


def test_figures_and_plot(freeform, lens, tmp_path):
    plot = tmp_path / "errors.png"
    status, stdout, stderr = freeform(
        "tolerances", lens, *FEW, "--decentre", 0.3, "--tilt", 2, "--plot", plot, "--json"
    )
    assert (status, stderr) == (0, "")
    figures = json.loads(stdout)
    assert sorted(figures) == ["mean", "nominal", "percentiles", "samples", "worst"]
    errors = [each["relative_l2"] for each in figures["samples"]]
    assert len(errors) == 4
    assert figures["worst"] == max(errors)
    assert figures["mean"] == pytest.approx(sum(errors) / 4)
    assert min(errors) <= figures["percentiles"]["50"] <= max(errors)
    assert all(sum(x * x for x in each["tilt"]) <= 4 for each in figures["samples"])
    assert {each["index"] for each in figures["samples"]} == {0}
    assert plot.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    "arguments, reason",
    [
        ((), "usage: nothing is off; give --tilt"),
        (("--tilt", 50), "tilt: 50 degrees; at least 0, less than 45"),
        (("--index", 0.6), "index: 0.6; at least 0, less than 0.5"),
        (("--surface", 0.1), "usage: argument --surface: expected 2 arguments"),
        (("--samples", 0), "usage: argument --samples: '0'"),
    ],
)
def test_refusals(freeform, lens, arguments, reason):
    status, stdout, stderr = freeform("tolerances", lens, *arguments)
    assert (status, stdout) == (2, "")
    assert stderr.startswith(f"freeform: {reason}")
