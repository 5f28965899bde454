import pytest

from workbench.cli.arguments import VERBS


@pytest.fixture
def help_of(capsys, monkeypatch):
    from workbench.cli import main

    monkeypatch.setenv("COLUMNS", "80")

    def run(*verb):
        with pytest.raises(SystemExit) as ended:
            main([*verb, "--help"])
        assert ended.value.code == 0
        return capsys.readouterr().out

    return run


@pytest.mark.parametrize("verb", [(), *((name,) for name in VERBS)])
def test_help_fits_on_one_screen_and_shows_what_to_type(help_of, verb):
    lines = help_of(*verb).splitlines()
    assert len(lines) <= 40
    assert max(map(len, lines)) <= 80
    examples = lines[lines.index("examples:") + 1 :]
    assert examples[0].startswith(f"  freeform {' '.join(verb)}")


def test_the_first_help_names_every_verb(help_of):
    stderr = help_of()
    for name in VERBS:
        assert f"\n  {name} " in stderr
