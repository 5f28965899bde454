"""Intensity by direction: IES LM-63 (.ies) and EULUMDAT (.ldt)."""

from workbench.measured.photometry.read import ENDINGS, read_photometry
from workbench.measured.photometry.table import IntensityTable

__all__ = ["ENDINGS", "IntensityTable", "read_photometry"]
