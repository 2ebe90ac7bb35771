"""Counts the resources of a process and of its OpenGL contexts: memory, threads, files, and objects by glIs...(); the Python sibling of smProcessResources.h
and smGLObjects.h. Linux with glibc and GLVND."""
import ctypes
import gc
import os
import statistics

from smcheck import check_equal, check_true

_libc = ctypes.CDLL(None)
_opengl = ctypes.CDLL("libOpenGL.so.0")
# OpenGL names of objects from 1 to this one are asked for.
RANGE = 32768
KINDS = {"buffers": "glIsBuffer", "textures": "glIsTexture", "framebuffers": "glIsFramebuffer", "renderbuffers": "glIsRenderbuffer",
         "vertex arrays": "glIsVertexArray", "programs": "glIsProgram", "shaders": "glIsShader", "queries": "glIsQuery",
         "samplers": "glIsSampler", "pipelines": "glIsProgramPipeline"}


class _Mallinfo2(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


_libc.mallinfo2.restype = _Mallinfo2


class Process:
    """The resources of this process when the object is made. heap: bytes that malloc has given out; resident: bytes in memory."""

    def __init__(self):
        gc.collect()
        _libc.malloc_trim(ctypes.c_size_t(0))
        heap = _libc.mallinfo2()
        self.heap = heap.uordblks + heap.hblkhd
        with open("/proc/self/statm", encoding="ascii") as file:
            self.resident = int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
        self.threads = len(os.listdir("/proc/self/task"))
        self.files = len(os.listdir("/proc/self/fd"))

    def __str__(self):
        return f"heap {self.heap / 1e3:.0f} kB, in memory {self.resident / 1e6:.1f} MB, {self.threads} threads, {self.files} files"


def get_growth(what, counted):
    """Returns the growth in bytes per cycle of `what`, "heap" or "resident", from a Process after each cycle: the median of the growth over
    any four cycles, for some cycles have four steps that repeat. A leak grows in all of them; memory that is allocated now and then or comes
    and goes, in some."""
    return statistics.median(getattr(after, what) - getattr(before, what) for before, after in zip(counted, counted[4:])) / 4


def run_counted(cycle, first, cycles, count, describe):
    """Runs cycle(i), of at least eight numbers from `first` on, and prints what count() finds, a list with a Process in front, every now and
    then: `describe` makes text of the rest. Returns what it found at the start and the end, and the growth a cycle by name."""
    def report(done, held):
        print(f"after {done:4} cycles: {held[0]}; {describe(*held[1:])}", flush=True)

    start = end = count()
    report(0, start)
    counted = [start[0]]
    for i in range(1, cycles + 1):
        cycle(first + i - 1)
        counted.append(Process())
        if i == cycles or i % max(10, cycles // 10) == 0:
            end = count()
            report(i, end)
    return start, end, {what: get_growth(what, counted) for what in ("heap", "resident")}


def check_held(start, end, growth, heap, resident):
    """Checks the results of a run_counted() whose count() gives a Process and the objects of a view: as many objects at the end as at the
    start, and at most `heap` and `resident` bytes more a cycle."""
    # VTK's timers are a pool that grows with the frames by which the driver is late.
    check_true("queries of the view", end[1].pop("queries") <= 64)
    start[1].pop("queries")
    check_equal("other objects of the view", start[1], end[1])
    check_equal("threads", start[0].threads, end[0].threads)
    check_equal("files", start[0].files, end[0].files)
    check_true("growth of the heap", growth["heap"] <= heap, f"{growth['heap']:.0f} bytes a cycle, limit {heap:.0f}")
    check_true("growth in memory", growth["resident"] <= resident,
               f"{growth['resident']:.0f} bytes a cycle, limit {resident:.0f}")


def check_counting(window):
    """Checks that count_objects() counts a new buffer, and no longer one that is freed."""
    name = make_buffer(window)
    more = count_objects(window)["buffers"]
    free_buffer(window, name)
    check_equal("an object more is seen", more - 1, count_objects(window)["buffers"])


def count_objects(window):
    """Returns the number of objects by kind in the context of a vtkRenderWindow, which is the current context afterwards."""
    window.MakeCurrent()
    counts = {}
    highest = 0
    for kind, name in KINDS.items():
        function = getattr(_opengl, name)
        function.restype = ctypes.c_ubyte
        living = [i for i in range(1, RANGE) if function(i)]
        counts[kind] = len(living)
        highest = max([highest] + living)
    assert highest < RANGE // 2, f"objects may live beyond name {RANGE}"
    return counts


def count_errors(window):
    """Pending errors of the context of a vtkRenderWindow."""
    window.MakeCurrent()
    errors = 0
    while errors < 16 and _opengl.glGetError() != 0:
        errors += 1
    return errors


def make_buffer(window):
    """A buffer that nobody frees, for tests of the counting."""
    window.MakeCurrent()
    name = ctypes.c_uint(0)
    _opengl.glGenBuffers(1, ctypes.byref(name))
    _opengl.glBindBuffer(0x8F37, name)  # GL_COPY_WRITE_BUFFER
    _opengl.glBindBuffer(0x8F37, 0)
    return name


def free_buffer(window, name):
    window.MakeCurrent()
    _opengl.glDeleteBuffers(1, ctypes.byref(name))
