"""run_in_one_session.py SCRIPT [ARGUMENT ...] [-- SCRIPT [ARGUMENT ...]] ...: tests of the plugin in one pvpython, which takes seconds to start.

Each has a session of ParaView of its own. Exit status 1 if one fails; the others run all the same.
"""
import runpy
import sys
import traceback

from paraview import simple


def run(arguments):
    """True when the script passes."""
    print("\n==", *arguments, flush=True)
    sys.argv = arguments
    try:
        runpy.run_path(arguments[0], run_name="__main__")
    except SystemExit as end:
        return end.code in (None, 0)
    except Exception:  # as the interpreter ends
        traceback.print_exc()
        return False
    finally:
        simple.ResetSession()
    return True


scripts = [[]]
for word in sys.argv[1:]:
    if word == "--":
        scripts.append([])
    else:
        scripts[-1].append(word)
failed = [script[0] for script in scripts if not run(script)]
print("\nfailed:", ", ".join(failed) if failed else "none", flush=True)
if failed:  # as in smcheck.py
    sys.exit(1)
