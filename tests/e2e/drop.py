"""Drops a file on a window as a file manager does: the source's side of the XDND protocol, version 5
(freedesktop.org, "Drag-and-Drop Protocol for the X Window System")."""

import ctypes
import time
import urllib.parse

from program import ClientMessage

SELECTION_REQUEST, SELECTION_NOTIFY, CLIENT_MESSAGE = 30, 31, 33


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("owner", ctypes.c_ulong),
                ("requestor", ctypes.c_ulong), ("selection", ctypes.c_ulong),
                ("target", ctypes.c_ulong), ("property", ctypes.c_ulong),
                ("time", ctypes.c_ulong), ("padding", ctypes.c_long * 12)]


class SelectionNotify(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("requestor", ctypes.c_ulong),
                ("selection", ctypes.c_ulong), ("target", ctypes.c_ulong),
                ("property", ctypes.c_ulong), ("time", ctypes.c_ulong),
                ("padding", ctypes.c_long * 12)]


class Source:
    """The file manager: a window of its own that owns the selection while it drags."""

    def __init__(self, display_name):
        self.x = ctypes.CDLL("libX11.so.6")
        for name in ("XOpenDisplay",):
            getattr(self.x, name).restype = ctypes.c_void_p
        for name in ("XInternAtom", "XDefaultRootWindow", "XCreateSimpleWindow"):
            getattr(self.x, name).restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display_name.encode()))
        root = self.x.XDefaultRootWindow(self.display)
        self.window = self.x.XCreateSimpleWindow(self.display, ctypes.c_ulong(root), 0, 0, 1, 1, 0,
                                                 ctypes.c_ulong(0), ctypes.c_ulong(0))

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), 0)

    def send(self, target, kind, data):
        message = ClientMessage()
        message.type = CLIENT_MESSAGE
        message.window = target
        message.message_type = self.atom(kind)
        message.format = 32
        for i, value in enumerate([self.window, *data]):
            message.data[i] = value
        self.x.XSendEvent(self.display, ctypes.c_ulong(target), 0, ctypes.c_long(0),
                          ctypes.byref(message))
        self.x.XFlush(self.display)

    def next_event(self, end):
        event = ctypes.create_string_buffer(192)
        while not self.x.XPending(self.display):
            assert time.monotonic() < end, "the window has not answered the drop"
            time.sleep(0.01)
        self.x.XNextEvent(self.display, event)
        return event

    def answer(self, event, content):
        """Hands over what is dropped to whoever asks for the selection."""
        request = SelectionRequest.from_buffer_copy(event)
        self.x.XChangeProperty(self.display, ctypes.c_ulong(request.requestor),
                               ctypes.c_ulong(request.property), ctypes.c_ulong(request.target), 8,
                               0, content, len(content))
        notify = SelectionNotify(type=SELECTION_NOTIFY, requestor=request.requestor,
                                 selection=request.selection, target=request.target,
                                 property=request.property, time=request.time)
        self.x.XSendEvent(self.display, ctypes.c_ulong(request.requestor), 0, ctypes.c_long(0),
                          ctypes.byref(notify))
        self.x.XFlush(self.display)

    def drop(self, target, place, path, patience=20.0):
        end = time.monotonic() + patience
        content = ("file://" + urllib.parse.quote(path) + "\r\n").encode()
        kind = self.atom("text/uri-list")
        selection = self.atom("XdndSelection")
        self.x.XSetSelectionOwner(self.display, ctypes.c_ulong(selection),
                                  ctypes.c_ulong(self.window), ctypes.c_ulong(0))
        self.send(target, "XdndEnter", [5 << 24, kind, 0, 0])
        where = round(place[0]) << 16 | round(place[1])
        self.send(target, "XdndPosition", [0, where, 0, self.atom("XdndActionCopy")])
        is_dropped = False
        while True:
            event = self.next_event(end)
            number = ctypes.cast(event, ctypes.POINTER(ctypes.c_int))[0]
            if number == SELECTION_REQUEST:
                self.answer(event, content)
            elif number == CLIENT_MESSAGE:
                answer = ClientMessage.from_buffer_copy(event)
                if answer.message_type == self.atom("XdndStatus") and not is_dropped:
                    assert answer.data[1] & 1, "the window takes no drop"
                    self.send(target, "XdndDrop", [0, 0, 0, 0])
                    is_dropped = True
                elif answer.message_type == self.atom("XdndFinished"):
                    return


def drop_file(program, path, place):
    """Drops a file on the program's window at a place of the screen."""
    Source(program.environment["DISPLAY"]).drop(int(program.window()), place, path)
