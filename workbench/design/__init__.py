"""How a lens is found: parametrisation, loss, stages and the run itself."""
