"""The compiled train: one forward and one adjoint for each kind of element, for every train.

Rays go through the train in batches of samples of the first freeform face. For each further
element of the list the loops branch once a batch on its kind. The way back repeats a batch
forwards, keeps the registers of each element, and runs the adjoints in reverse order.
"""
