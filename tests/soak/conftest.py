"""What robots need."""

import pytest


@pytest.fixture(scope="session")
def kernels():
    """Kernels compiled beforehand: the program does not do so while it is monitored."""
    import torch

    from workbench.analysis.kernels import compile_all

    compile_all(dtypes=(torch.float32, torch.float64))
