"""What robots need."""

import pytest


@pytest.fixture(scope="session")
def kernels():
    """Kernels compiled beforehand: the program does not do so while it is watched."""
    import torch

    from workbench.analysis.kernels import compile_all
    from workbench.optics.kernels.ready import is_ready

    compile_all()
    for name in ("collimated", "face", "point"):
        assert is_ready(name, torch.float64)
