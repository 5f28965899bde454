"""Measured rays: IES TM-25 (.tm25ray), OpticStudio (.dat), text (.csv, .txt)."""

from workbench.measured.rays.rayset import MOST_RAYS, RaySet
from workbench.measured.rays.read import ENDINGS, read_rays

__all__ = ["ENDINGS", "MOST_RAYS", "RaySet", "read_rays"]
