"""TestPluginWindowCloses.py PARAVIEW PLUGIN.so SOURCE OUTPUT: plays TestPluginWindowCloses.xml back in ParaView's window, which ends by itself."""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

paraview, plugin, source, output = sys.argv[1:5]
script = os.path.join(source, "Testing", "ParaViewPlugin", "Window", "TestPluginWindowCloses.xml")
played = subprocess.run([
    paraview, "--dr", "--plugin-search-paths=" + os.path.dirname(plugin), "--plugins=SolidMoments", "--data-directory=" + source,
    "--test-directory=" + output, "--test-script=" + script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    errors="replace")
check_equal("ParaView ends with", 0, played.returncode)
# A step that cannot be played does not change how ParaView ends.
check_true("every step was played", "Success =  true" in played.stdout, played.stdout[-400:])
finish()
