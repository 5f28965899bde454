"""The tracer of the independent check: random rays through elements, in float64.

It shares no code with `workbench.optics`, which designs lenses, so that a defect there shows in a
check. The split is the same: sources, surfaces, interfaces and receivers, a file for each kind,
behind the protocols of `elements`; `train` makes a sequence of them and follows rays along it, and
`trace` does that for many rays in threads.
"""
