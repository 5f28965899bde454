"""What the engine logs while a command works."""

import logging
from types import SimpleNamespace

from workbench.cli import main


def test_log_goes_to_standard_error_only_while_the_command_runs(capsys, monkeypatch):
    log = logging.getLogger("workbench.some_room")

    def work(options):
        log.info("compiling; this takes a while")

    monkeypatch.setattr("workbench.cli.arguments.parse", lambda _: SimpleNamespace(command=work))
    assert main([]) == 0
    assert capsys.readouterr() == ("", "freeform: compiling; this takes a while\n")
    log.info("of another program, which did not ask for it")
    assert capsys.readouterr() == ("", "")
