"""Measured light: files of luminaires and of rays, as arrays.

`photometry` reads intensity by direction (IES LM-63, EULUMDAT), `rays` reads rays (IES TM-25,
OpticStudio, CSV). Both take any open file, so that a content kept in a session is read like a file
on disk, and refuse what is wrong in one sentence.
"""
