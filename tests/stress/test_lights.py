"""Extreme scenes of version 2: any light, receiver and outline, coated and absorbing glass."""

import pytest
import torch
from hypothesis import HealthCheck, given, settings

from tests.stress.checks import any_light, check_traces
from tests.stress.lights import lit_cases
from tests.stress.scenes import Case

DTYPES = [torch.float64, torch.float32]
FEW = settings(max_examples=40, suppress_health_check=list(HealthCheck))
MANY = settings(max_examples=2000, suppress_health_check=list(HealthCheck))


@FEW
@given(case=lit_cases())
def test_traces_of_any_light(case):
    for dtype in DTYPES:
        check_traces(case, dtype, any_light)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@MANY
@given(case=lit_cases())
def test_many_traces_of_any_light(case: Case):
    for dtype in DTYPES:
        check_traces(case, dtype, any_light)
