"""TestPluginClosing.py MODE PLUGIN.so FILE.step [SERVER]: views, filters, files and sessions are closed in any order, without crash or leak.

orders: view, filter and file in every order, two views, layouts. reset: a session ends with all of them open. exit: the program ends with
all of them open. server: the client leaves the server HOST:PORT, on which the filter is; with_server.py checks how the server ends.
killed: the server, started as the program SERVER, is killed instead.
With - for PLUGIN.so the same is done with ParaView's own sphere and filter; a failure there is one of ParaView.
"""
import atexit
import gc
import itertools
import os
import signal
import socket
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402
from vtkmodules.vtkCommonCore import vtkWeakReference  # noqa: E402

mode, plugin, path = sys.argv[1:4]
stock = plugin == "-"
ports = 1 if stock else 6


def load(remote):
    if not stock:
        simple.LoadPlugin(plugin, remote=remote, ns=globals())


def get_volume(mass):
    if stock:
        return servermanager.Fetch(mass).GetNumberOfPoints()
    return servermanager.Fetch(mass, idx=0).GetFieldData().GetArray("Volume").GetValue(0)


class Scene:
    """A file, its mass properties and a view of both, as after Apply."""

    def __init__(self, views=1):
        self.views = [simple.CreateRenderView(ViewSize=[200, 150]) for _ in range(views)]
        if stock:
            self.reader = simple.Sphere()
            self.mass = simple.Shrink(Input=self.reader)
        else:
            self.reader = simple.OpenDataFile(path)
            self.mass = MassProperties(Input=self.reader)  # noqa: F821
        controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
        for view in self.views:
            simple.Show(self.reader, view)
            for port in range(ports):
                controller.ShowInPreferredView(self.mass.SMProxy, port, view.SMProxy)
            simple.Hide(self.reader, view)
            simple.Render(view)
        self.volume = get_volume(self.mass)

    def watch(self):
        """Keeps a weak reference to the algorithm; only in a session without server."""
        self.watched = vtkWeakReference()
        self.watched.Set(self.mass.GetClientSideObject())

    def is_gone(self):
        gc.collect()
        return self.watched.Get() is None

    def delete(self, what):
        """Deletes "view", "mass" or "reader", and checks that the others still work."""
        if what == "view":
            simple.Delete(self.views.pop(0))
        else:
            simple.Delete(getattr(self, what))
            setattr(self, what, None)
        gc.collect()
        for view in self.views:
            simple.Render(view)
        if self.mass:
            if not stock:
                self.mass.RelativeTolerance = 1e-8 if self.mass.RelativeTolerance == 1e-9 else 1e-9
            assert abs(get_volume(self.mass) - self.volume) <= 1e-8 * self.volume


def check_orders():
    for order in itertools.permutations(["view", "mass", "reader"]):
        scene = Scene()
        scene.watch()
        check_true("the filter is there", not scene.is_gone())
        for what in order:
            scene.delete(what)
        check_true(", ".join(order), scene.is_gone())
    for order in sorted(set(itertools.permutations(["view", "view", "mass"]))):
        scene = Scene(2)
        scene.watch()
        check_true("the filter is there", not scene.is_gone())
        for what in order:
            scene.delete(what)
        simple.Delete(scene.reader)
        scene.reader = None
        check_true("two views: " + ", ".join(order), scene.is_gone())
    scene = Scene(2)
    for view in scene.views:
        simple.CreateLayout().AssignView(0, view)
    for layout in list(simple.GetLayouts().values()):
        simple.RemoveLayout(layout)
    check_true("layouts removed under their views", get_volume(scene.mass) == scene.volume)
    scene.views.clear()
    simple.RemoveViewsAndLayouts()
    check_equal("views left", 0, len(simple.GetRenderViews()))
    check_true("and then the views", get_volume(scene.mass) == scene.volume)
    view = simple.CreateRenderView(ViewSize=[200, 150])
    simple.Show(scene.mass, view)
    simple.Render(view)
    check_true("shown in a new view", get_volume(scene.mass) == scene.volume)


def check_sessions():
    scene = Scene(2)
    volume = scene.volume
    del scene
    simple.ResetSession()
    check_equal("sources after ResetSession()", 0, len(simple.GetSources()))
    scene = Scene()
    check_equal("volume in the new session", volume, scene.volume)
    # The Python proxies outlive their session.
    simple.Disconnect()
    check_true("disconnected", servermanager.ActiveConnection is None)
    del scene
    gc.collect()
    simple.Connect()
    again = Scene()
    check_equal("volume after connecting again", volume, again.volume)
    simple.Disconnect()
    gc.collect()


def check_server():
    load(False)
    here = Scene()
    volume = here.volume
    del here
    host, port = sys.argv[4].split(":")
    simple.Connect(host, int(port))
    load(True)
    scene = Scene(2)
    check_equal("volume on the server", volume, scene.volume)
    simple.Delete(scene.views.pop())
    simple.Disconnect()
    del scene
    gc.collect()
    simple.Connect()
    again = Scene()
    check_equal("volume here again", volume, again.volume)


def check_killed():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    server = subprocess.Popen([sys.argv[4], "--hostname=localhost", f"--server-port={port}"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
    atexit.register(server.kill)
    for line in server.stdout:
        if "Accepting" in line:
            break
    simple.Connect("localhost", port)
    load(True)
    load(False)
    scene = Scene()
    server.kill()
    check_equal("the server ends with", -signal.SIGKILL, server.wait(20))
    sys.stdout.flush()
    if not stock:
        scene.mass.Density = 1000.0
    # ParaView prints many messages about the broken connection.
    simple.Render(scene.views[0])
    check_true("the view is still there", True)
    simple.Disconnect()
    del scene
    gc.collect()
    simple.Connect()
    again = Scene()
    check_true("and computed here", again.volume > 0)


if mode == "orders":
    load(False)
    check_orders()
elif mode == "reset":
    load(False)
    check_sessions()
elif mode == "exit":
    load(False)
    kept = Scene(2)
    check_true("computed", kept.volume > 0)
elif mode == "server":
    check_server()
elif mode == "killed":
    check_killed()
finish()
