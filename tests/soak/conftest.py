"""What robots need."""

import pytest


@pytest.fixture(scope="session")
def kernels():
    """Kernels compiled beforehand: the program does not do so while it is watched."""
    from workbench.design.kernels import compile_all

    compile_all()
