"""An X display over its plain protocol, without a library or a program: keys and mouse as by a user (the extension XTEST), and pictures of the screen."""
import os
import socket
import struct


def _find_cookie(number):
    """Name and data of the authorisation for a local display; empty where none is needed."""
    path = os.environ.get("XAUTHORITY", os.path.expanduser("~/.Xauthority"))
    if not os.path.exists(path):
        return b"", b""
    with open(path, "rb") as file:
        content = file.read()
    at = 0
    while at + 2 <= len(content):
        at += 2  # the family
        fields = []
        for _ in range(4):  # address, display, name, data
            size = struct.unpack(">H", content[at:at + 2])[0]
            fields.append(content[at + 2:at + 2 + size])
            at += 2 + size
        if fields[1] in (b"", number.encode()):
            return fields[2], fields[3]
    return b"", b""


def _pad(data):
    return data + bytes(-len(data) % 4)


class Display:
    """A connection to the display in the environment."""

    def __init__(self):
        number = os.environ["DISPLAY"].split(":")[1].split(".")[0]
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect("/tmp/.X11-unix/X" + number)
        name, data = _find_cookie(number)
        self.socket.sendall(struct.pack("<BxHHHHxx", ord("l"), 11, 0, len(name), len(data)) + _pad(name) + _pad(data))
        head = self._receive(8)
        rest = self._receive(4 * struct.unpack("<H", head[6:8])[0])
        self.setup = rest
        if head[0] != 1:
            raise OSError(f"the display refuses: {rest!r}")
        extension = b"XTEST"
        self.socket.sendall(struct.pack("<BxHHxx", 98, 2 + len(_pad(extension)) // 4, len(extension)) + _pad(extension))
        reply = self._receive(32)
        if not reply[8]:
            raise OSError("the display has no XTEST")
        self.opcode = reply[9]

    def _receive(self, size):
        data = b""
        while len(data) < size:
            more = self.socket.recv(size - len(data))
            if not more:
                raise OSError("the display closed the connection")
            data += more
        return data

    def _receive_reply(self):
        """The head of the next reply. Events are skipped: every client gets one when a pressed key changes the keyboard."""
        while (head := self._receive(32))[0] > 1:
            pass
        if head[0] == 0:
            raise OSError(f"the display refuses a request: {head!r}")
        return head

    def _send(self, events):
        """Sends events of the extension: kind, detail, x and y."""
        for kind, detail, x, y in events:
            self.socket.sendall(struct.pack("<BBHBBxxII8xHH7xB", self.opcode, 2, 9, kind, detail, 0, 0, x, y, 0))
        # A request with a reply, so that all are done.
        self.socket.sendall(struct.pack("<BxH", 43, 1))
        self._receive_reply()

    def tap(self, keycode):
        """Presses and lets go of a key."""
        self._send([(2, keycode, 0, 0), (3, keycode, 0, 0)])

    def move(self, x, y):
        """Moves the mouse to a place on the screen."""
        self._send([(6, 0, x, y)])

    def press(self, button=1):
        self._send([(4, button, 0, 0)])

    def release(self, button=1):
        self._send([(5, button, 0, 0)])

    def click(self, x, y):
        self.move(x, y)
        self.press()
        self.release()

    def grab(self):
        """The screen: width, height, and its pixels from the upper left corner, each as blue, green, red and a byte without meaning."""
        vendor, formats = struct.unpack("<H", self.setup[16:18])[0], self.setup[21]
        screen = self.setup[32 + vendor + -vendor % 4 + 8 * formats:]
        root, (width, height) = struct.unpack("<I", screen[:4])[0], struct.unpack("<HH", screen[20:24])
        self.socket.sendall(struct.pack("<BBHIHHHHI", 73, 2, 5, root, 0, 0, width, height, 0xffffffff))
        size = 4 * struct.unpack("<I", self._receive_reply()[4:8])[0]
        chunks = []
        while size > 0:
            chunks.append(self.socket.recv(min(size, 1 << 20)))
            if not chunks[-1]:
                raise OSError("the display closed the connection")
            size -= len(chunks[-1])
        return width, height, b"".join(chunks)
