"""Loads a file for Sage with the modules of passagemath-schemes, as `sage FILE` does with all of Sage."""
import sys

from sage.all__sagemath_schemes import *
from sage.repl.preparse import preparse_file

exec(compile(preparse_file(open(sys.argv[1]).read()), sys.argv[1], "exec"), globals())
