"""Runs a command and expects an exit status and a text in what it prints.

    expect_command.py --status N --text REGEX [--without REGEX] -- COMMAND [ARGUMENT ...]

Standard output and standard error are searched together and printed. Exit status 0 when both are as expected.
"""
import argparse
import re
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--status", type=int, required=True)
    parser.add_argument("--text", required=True, help="regular expression that must be found")
    parser.add_argument("--without", help="regular expression that must not be found")
    parser.add_argument("command", nargs="+")
    options = parser.parse_args()
    done = subprocess.run(options.command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          check=False)
    print(done.stdout)
    problems = []
    if done.returncode != options.status:
        problems.append(f"exit status {done.returncode} instead of {options.status}")
    if not re.search(options.text, done.stdout):
        problems.append(f"no text matches {options.text!r}")
    if options.without and re.search(options.without, done.stdout):
        problems.append(f"a text matches {options.without!r}")
    for problem in problems:
        print("FAIL", problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
