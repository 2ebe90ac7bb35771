"""run_script_often.py SCRIPT LISTS: runs a Python script several times in one interpreter, for scripts whose imports take seconds.

LISTS: JSON, a list of argument lists. Standard output: JSON, a list of {"status": n, "stdout": text, "stderr": text}. What
libraries print past Python counts as the script's.
"""
import ctypes
import json
import os
import runpy
import sys
import tempfile
import traceback


def run(script, arguments):
    sys.argv = [script] + arguments
    kept = [os.dup(1), os.dup(2)]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        os.dup2(out.fileno(), 1)
        os.dup2(err.fileno(), 2)
        status = 0
        try:
            runpy.run_path(script, run_name="__main__")
        except SystemExit as end:
            status = end.code if isinstance(end.code, int) else 0 if end.code is None else 1
        except Exception:  # as the interpreter ends
            traceback.print_exc()
            status = 1
        sys.stdout.flush()
        sys.stderr.flush()
        # Python's streams are C's in pvpython 5.13, and a flush of the former leaves text in the latter.
        ctypes.CDLL(None).fflush(None)
        for number, stream in enumerate(kept, 1):
            os.dup2(stream, number)
            os.close(stream)
        texts = []
        for file in (out, err):
            file.seek(0)
            texts.append(file.read().decode("utf-8", "replace"))
    return {"status": status, "stdout": texts[0], "stderr": texts[1]}


script, argument_lists = sys.argv[1], json.loads(sys.argv[2])
print(json.dumps([run(script, arguments) for arguments in argument_lists]))
