"""The tracer of the independent check: random rays and cells through elements, in float64.

It shares no code with `workbench.optics`, which designs lenses, so that a defect there shows in a
check. Sources, surfaces, interfaces and receivers are a class a kind behind the protocols of
`elements`; `train` makes a sequence of them and follows rays along it, and `trace` does that for
many rays in threads.
"""

MOST_RAYS = 10_000_000_000
"""Most rays of a check, which take an hour on two cores."""
