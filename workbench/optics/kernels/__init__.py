"""Fused kernels for the CPU: the twins of the torch reference that do a whole trace in one pass."""
