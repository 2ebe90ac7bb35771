"""Proves that only what carries its module's export macro leaves a library.

    check_exports.py --nm NM --source FOLDER LIBRARY...

Every function and variable of the namespace sm in the dynamic symbols of the libraries, and the class of every method, must have the
macro in a header of the modules.
"""
import argparse
import pathlib
import re
import subprocess
import sys


def find_marked(source):
    """Names of classes, functions and variables with a macro."""
    names = set()
    for room in ("Filters", "Readers", "Rendering"):
        for path in (pathlib.Path(source) / room).rglob("*.h"):
            text = path.read_text(encoding="utf-8")
            names.update(re.findall(r"(?:class|struct)\s+SM\w+_EXPORT\s+(\w+)", text))
            names.update(re.findall(r"extern\s+SM\w+_EXPORT\s+const\s+[\w ]+?(\w+)\s*[\[;]", text))
            for declaration in re.findall(r"SM\w+_EXPORT\s+([^;{]*\()", text):
                names.update(re.findall(r"(\w+)\s*\(", declaration))
    return names


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--nm", required=True)
    parser.add_argument("--source", required=True)
    parser.add_argument("libraries", nargs="+")
    options = parser.parse_args()
    marked = find_marked(options.source)
    symbols = 0
    unmarked = []
    for library in options.libraries:
        listing = subprocess.run([options.nm, "-D", "-C", "--defined-only", library], capture_output=True, text=True, check=True)
        for line in listing.stdout.splitlines():
            match = re.match(r"[0-9a-f]* \w (?:\w+ for )?(?:\w+ to )?(sm::[\w:]+)", line)
            if match:
                symbols += 1
                if not marked.intersection(match.group(1).split("::")):
                    unmarked.append(f"{pathlib.Path(library).name}: {line.split(' ', 2)[2]}")
    print(f"{symbols} symbols, {len(unmarked)} without a macro", *unmarked[:20], sep="\n  ")
    return 0 if symbols > 100 and not unmarked else 1


if __name__ == "__main__":
    sys.exit(main())
