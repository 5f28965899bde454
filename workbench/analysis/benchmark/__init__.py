"""Run time against error: what can be measured, and how.

Times are medians of interleaved runs and their ratios are taken in one process; errors are those
of `workbench.analysis.validation`, never the optimiser's own loss.
"""
