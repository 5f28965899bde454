"""Measured sources: photometric files and ray files, as arrays.

`photometry` reads intensity by direction (IES LM-63, EULUMDAT), `rays` reads rays (IES TM-25,
OpticStudio, CSV). Both read any open file, so that content kept in a session is read like a file on
disk, and refuse invalid files in one sentence.
"""
