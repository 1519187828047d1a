# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""A program's window on the X server of DISPLAY: its pixels, and a pointer that moves over it (by Xlib and XTest)."""
import ctypes
import subprocess
import time

import numpy as np

from stipple_program import LIMIT

X11 = ctypes.CDLL("libX11.so.6")
XTEST = ctypes.CDLL("libXtst.so.6")
ALL_PLANES = ctypes.c_ulong(~0)
ZPIXMAP = 2
STATUS_ROWS = 26  # at the bottom of a window of 1280x800
PROGRESS = (184, 98, 38)  # blue, green, red of the bar there while a mesh is made
for function, result in (("XOpenDisplay", ctypes.c_void_p), ("XDefaultRootWindow", ctypes.c_ulong)):
    getattr(X11, function).restype = result
for name in ("XStringToKeysym", "XInternAtom", "XCreateSimpleWindow"):
    getattr(X11, name).restype = ctypes.c_ulong
X11.XKeysymToKeycode.restype = ctypes.c_ubyte
X11.XGetImage.restype = ctypes.c_void_p
# What every XEvent begins with.
EVENT_HEAD = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int), ("display", ctypes.c_void_p)]


class ImageHead(ctypes.Structure):
    """The beginning of Xlib's XImage."""

    _fields_ = [(name, ctypes.c_int) for name in ("width", "height", "xoffset", "format")] + [("data", ctypes.c_void_p)]


class ClientMessage(ctypes.Structure):
    """Xlib's XClientMessageEvent, as long as an XEvent."""

    _fields_ = EVENT_HEAD + [
        ("window", ctypes.c_ulong),
        ("message_type", ctypes.c_ulong),
        ("format", ctypes.c_int),
        ("data", ctypes.c_long * 5),
        ("padding", ctypes.c_long * 24),
    ]


class SelectionRequest(ctypes.Structure):
    """Xlib's XSelectionRequestEvent, as long as an XEvent. Its answer has no owner, and begins with the requestor."""

    _fields_ = EVENT_HEAD + [(name, ctypes.c_ulong) for name in ("owner", "requestor", "selection", "target", "property", "time")] + [
        ("padding", ctypes.c_long * 24)
    ]


class SelectionAnswer(ctypes.Structure):
    """Xlib's XSelectionEvent, as long as an XEvent."""

    _fields_ = EVENT_HEAD + SelectionRequest._fields_[len(EVENT_HEAD) + 1 :]


class SizeHints(ctypes.Structure):
    """Xlib's XSizeHints."""

    _fields_ = [("flags", ctypes.c_long)] + [
        (name, ctypes.c_int) for name in ("x", "y", "width", "height", "min_width", "min_height", "max_width", "max_height")
    ] + [("others", ctypes.c_int * 12)]


class LiveWindow:
    """The program runs while the context is entered. Places are pixels from the upper left corner of a window there."""

    def __init__(self, *command, size=(1280, 800)):
        self.command = list(map(str, command))
        self.size = size
        self.owners = set()  # windows of ours that have selections
        self.rest = 0.5  # seconds without a change after which a picture is taken to stay

    def __enter__(self):
        self.display = ctypes.c_void_p(X11.XOpenDisplay(None))
        if not self.display:
            raise ConnectionError("no X server answers")
        self.root = ctypes.c_ulong(X11.XDefaultRootWindow(self.display))
        begin = time.monotonic()
        self.program = subprocess.Popen(self.command)
        while self.program.poll() is None and np.ptp(self.picture()) == 0:
            time.sleep(0.05)
        # A busy machine takes as much longer over each frame as over the first one.
        self.rest += time.monotonic() - begin
        return self

    def __exit__(self, *_):
        self.program.terminate()
        self.program.wait()
        X11.XCloseDisplay(self.display)

    def move(self, x, y):
        XTEST.XTestFakeMotionEvent(self.display, -1, x, y, ctypes.c_ulong(0))
        X11.XSync(self.display, 0)
        time.sleep(0.03)

    def button(self, number, down):
        XTEST.XTestFakeButtonEvent(self.display, number, int(down), ctypes.c_ulong(0))
        X11.XSync(self.display, 0)
        time.sleep(0.1)

    def key(self, symbol):
        """Presses a key, by X11's name of it, and lets it go; "Control_L+o": another one is held."""
        held = symbol.split("+")
        codes = [X11.XKeysymToKeycode(self.display, ctypes.c_ulong(X11.XStringToKeysym(k.encode()))) for k in held]
        for down, order in ((1, codes), (0, codes[::-1])):
            for code in order:
                XTEST.XTestFakeKeyEvent(self.display, ctypes.c_uint(code), down, ctypes.c_ulong(0))
                X11.XSync(self.display, 0)
        time.sleep(0.1)

    def paste(self, text):
        """Has the text in the clipboard, as another program does, presses Ctrl+V, and hands it over."""
        self.own("CLIPBOARD")
        self.key("Control_L+v")
        self.hand_over(text)

    def drop(self, *files, place=(300, 300)):
        """Drags files from another program, and lets them go there (XDND, version 5)."""
        source = self.own("XdndSelection")
        self.send("XdndEnter", source, 5 << 24, self.atom("text/uri-list"))
        self.send("XdndPosition", source, 0, place[0] << 16 | place[1], 0, self.atom("XdndActionCopy"))
        self.send("XdndDrop", source)
        self.hand_over("".join(f"{file.as_uri()}\r\n" for file in files))

    def close(self):
        """Asks the window to close, as a window manager does where its close button is pressed."""
        self.send("WM_PROTOCOLS", self.atom("WM_DELETE_WINDOW"))

    def atom(self, name):
        return X11.XInternAtom(self.display, name.encode(), 0)

    def send(self, message, *data):
        event = ClientMessage(type=33, window=self.window(), message_type=self.atom(message), format=32)
        event.data[: len(data)] = data
        X11.XSendEvent(self.display, ctypes.c_ulong(event.window), 0, ctypes.c_long(0), ctypes.byref(event))
        X11.XSync(self.display, 0)

    def own(self, selection):
        """The number of a window that has the selection from now on."""
        owner = X11.XCreateSimpleWindow(self.display, self.root, 0, 0, 1, 1, 0, 0, 0)
        self.owners.add(owner)
        X11.XSetSelectionOwner(self.display, ctypes.c_ulong(self.atom(selection)), ctypes.c_ulong(owner), ctypes.c_ulong(0))
        return owner

    def hand_over(self, text, limit=LIMIT):
        """Answers who asks for what is selected."""
        request, end = SelectionRequest(), time.monotonic() + limit
        while not X11.XCheckTypedEvent(self.display, 30, ctypes.byref(request)):
            if time.monotonic() > end:
                raise TimeoutError("nobody asks for what is selected")
            time.sleep(0.01)
        data = text.encode()
        X11.XChangeProperty(self.display, ctypes.c_ulong(request.requestor), ctypes.c_ulong(request.property),
            ctypes.c_ulong(request.target), 8, 0, data, len(data))
        answer = SelectionAnswer(type=31)
        for name in ("requestor", "selection", "target", "property", "time"):
            setattr(answer, name, getattr(request, name))
        X11.XSendEvent(self.display, ctypes.c_ulong(request.requestor), 0, ctypes.c_long(0), ctypes.byref(answer))
        X11.XSync(self.display, 0)

    def window(self):
        """The number of the program's window: the only one here but our own."""
        root, parent, children, number = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.c_void_p(), ctypes.c_uint()
        X11.XQueryTree(self.display, self.root, ctypes.byref(root), ctypes.byref(parent), ctypes.byref(children),
            ctypes.byref(number))
        windows = ctypes.cast(children, ctypes.POINTER(ctypes.c_ulong))[: number.value]
        window = [w for w in windows if w not in self.owners][-1]
        X11.XFree(children)
        return window

    def resize(self, width, height):
        """As if the user had drawn the window's corner; pictures are of this size from now on."""
        X11.XResizeWindow(self.display, ctypes.c_ulong(self.window()), ctypes.c_uint(width), ctypes.c_uint(height))
        X11.XSync(self.display, 0)
        self.size = width, height

    def least_size(self):
        """Width and height that the window asks window managers for."""
        hints, supplied = SizeHints(), ctypes.c_long()
        X11.XGetWMNormalHints(self.display, ctypes.c_ulong(self.window()), ctypes.byref(hints), ctypes.byref(supplied))
        return hints.min_width, hints.min_height

    def title(self):
        """What window managers write over the window."""
        atom = [ctypes.c_ulong(X11.XInternAtom(self.display, name, 0)) for name in (b"_NET_WM_NAME", b"UTF8_STRING")]
        kind, size, count, left = ctypes.c_ulong(), ctypes.c_int(), ctypes.c_ulong(), ctypes.c_ulong()
        text = ctypes.c_char_p()
        most = ctypes.c_long(1000)  # of four bytes
        X11.XGetWindowProperty(
            self.display, ctypes.c_ulong(self.window()), atom[0], ctypes.c_long(0), most, 0, atom[1],
            *map(ctypes.byref, (kind, size, count, left, text)),
        )  # fmt: skip
        return text.value.decode()

    def status_rows(self):
        """Of the status line, which is as much smaller or larger as the window is: Layout."""
        width, height = self.size
        return int(STATUS_ROWS * min(max(min(height / 800, width / 1280), 0.7), 2))

    def ended(self, limit=LIMIT):
        """Waits for the program's end; its exit status."""
        return self.program.wait(limit)

    def picture(self):
        """rows x columns x 3 (blue, green, red), of the screen's upper left part."""
        width, height = self.size
        image = X11.XGetImage(self.display, self.root, 0, 0, width, height, ALL_PLANES, ZPIXMAP)
        head = ctypes.cast(image, ctypes.POINTER(ImageHead)).contents
        raw = ctypes.string_at(head.data, 4 * width * height)
        X11.XDestroyImage(ctypes.c_void_p(image))
        return np.frombuffer(raw, np.uint8).reshape(height, width, 4)[..., :3].astype(int)

    def settle(self, after=None, rest=None, limit=LIMIT, seen=None, until=None):
        """Waits until the picture is not all of one color, differs from that of before, if given, is what `until` says
        True of, if given, shows no progress of a mesh, and has not changed for so many seconds (as long as this machine
        needs); the picture. What is seen on the way is added to a list, if one is given."""
        rest = self.rest if rest is None else rest
        end = time.monotonic() + limit
        picture, since = self.picture(), time.monotonic()
        while (
            np.ptp(picture) == 0
            or (after is not None and not (picture != after).any())
            or (until is not None and not until(picture))
            or (picture[-self.status_rows() :] == PROGRESS).all(axis=2).any()
            or time.monotonic() - since < rest
        ):
            if time.monotonic() > end:
                still = after is None and until is None
                raise TimeoutError("the window does not come to rest" if still else "the window stays as it was")
            time.sleep(0.05)
            new = self.picture()
            if (new != picture).any():
                picture, since = new, time.monotonic()
                if seen is not None:
                    seen.append(picture)
        return picture
