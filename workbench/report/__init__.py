"""What a session comes to on some pages, for people who do not have the program."""
