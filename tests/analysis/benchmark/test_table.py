import json
from types import SimpleNamespace

import pytest

from workbench.analysis.benchmark.table import Table, TableColumn

COLUMNS = (
    TableColumn("name", "who"),
    TableColumn("part", "how much", ".1%"),
    TableColumn("curve", ""),
)
ROWS = [
    SimpleNamespace(name="a|b", part=0.25, curve=[1, 2]),
    SimpleNamespace(name="c", part=None, curve=[]),
]


@pytest.fixture
def table():
    return Table("Parts", COLUMNS, ROWS)


def test_markdown(table):
    assert table.to_markdown() == (
        "### Parts\n\n| who | how much |\n| --- | --- |\n| a\\|b | 25.0% |\n| c | – |\n"
    )


def test_data_has_every_column_unrounded(table):
    assert table.to_data() == [
        {"name": "a|b", "part": 0.25, "curve": [1, 2]},
        {"name": "c", "part": None, "curve": []},
    ]
    assert json.loads(json.dumps(table.to_data())) == table.to_data()
