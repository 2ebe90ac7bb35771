"""What a process and its OpenGL contexts hold: memory, threads, files, and objects by glIs...(); the Python sibling of smProcessResources.h
and smGLObjects.h. Linux with glibc and GLVND."""
import ctypes
import gc
import os

_libc = ctypes.CDLL(None)
_opengl = ctypes.CDLL("libOpenGL.so.0")
# Names above are not asked for.
RANGE = 32768
KINDS = {"buffers": "glIsBuffer", "textures": "glIsTexture", "framebuffers": "glIsFramebuffer", "renderbuffers": "glIsRenderbuffer",
         "vertex arrays": "glIsVertexArray", "programs": "glIsProgram", "shaders": "glIsShader", "queries": "glIsQuery",
         "samplers": "glIsSampler", "pipelines": "glIsProgramPipeline"}


class _Mallinfo2(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


_libc.mallinfo2.restype = _Mallinfo2


class Process:
    """Of this process now. heap: bytes that malloc has given out; resident: bytes in memory."""

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


def get_growth(what, *counted):
    """Bytes a cycle, from (cycles, Process) of the start, the middle and the end, the smaller of both halves: what grows does so in
    both; what is made once, late, in one. what: heap or resident."""
    return min((getattr(after, what) - getattr(before, what)) / (last - first)
               for (first, before), (last, after) in zip(counted, counted[1:]))


def count_objects(window):
    """Objects by kind that live in the context of a vtkRenderWindow, and what is current afterwards is that context."""
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
