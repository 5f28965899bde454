"""Sweeps: designs for all combinations of field values, in parallel, with one table."""
