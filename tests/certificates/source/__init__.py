"""The parts of make.py and cbor.py. They share no code with the program."""
