"""TestExamplePrograms.py --pipeline P --sample FILE --output DIR PROGRAM...: help and wrong usage of all example programs, and the digits
that MassPropertiesPipeline prints next to a bound.
"""
import argparse
import decimal
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
for name in ("--pipeline", "--sample", "--output"):
    parser.add_argument(name, required=True)
parser.add_argument("programs", nargs="+")
options = parser.parse_args()


def run(*command):
    result = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=200, check=False)
    print("$", os.path.basename(command[0]), *command[1:], "->", result.returncode)
    return result


for program in options.programs + [options.pipeline]:
    name = os.path.basename(program)
    result = run(program, "--help")
    check_equal(name + " --help: exit status", 0, result.returncode)
    check_true(name + " --help: on the standard output", name in result.stdout and "Exit status" in result.stdout, result.stderr)
    check_equal(name + " --help: nothing else", "", result.stderr)
    result = run(program, "--no-such-option")
    check_equal(name + " --no-such-option: exit status", 1, result.returncode)
    check_true(name + " --no-such-option: a message", result.stderr and not result.stdout, result.stderr)

result = run(options.pipeline, options.sample, os.path.join(options.output, "example_programs.png"))
check_equal("pipeline: exit status", 0, result.returncode)
match = re.search(r"^volume (\S+) mm\^3 \(\+- (\S+)\)$", result.stdout, re.MULTILINE)
if check_true("pipeline: volume and bound", match, result.stdout):
    digit = decimal.Decimal(1).scaleb(decimal.Decimal(match.group(1)).as_tuple().exponent)
    bound = decimal.Decimal(match.group(2))
    check_true("the last digit is below that of the bound", bound / 1000 <= digit <= bound / 10, f"{digit} and {bound}")
finish()
