# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/Pictures/paraview.png: ParaView's window with a remesh and its panel, on an X server without a screen.

make-picture.py PARAVIEW MODEL PICTURE, with LD_LIBRARY_PATH and PV_PLUGIN_PATH as for ParaView.
"""
import ctypes
import os
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

WIDTH, HEIGHT = 1440, 900
SPLITTER, WIDER = (296, 500), (470, 500)  # between ParaView's panels and its view
SECONDS = 240  # on a busy machine
RESTLESS = 0.002  # of the pixels: the memory that ParaView tells of


def screen(path):
    """The pixels of a screen that Xvfb keeps in a file: XWD, 32 bits a pixel."""
    with open(path, "rb") as file:
        data = file.read()
    header = np.frombuffer(data[:100], dtype=">u4")
    size, width, height, stride, colors = header[0], header[4], header[5], header[12], header[19]
    begin = int(size + 12 * colors)
    rows = np.frombuffer(data[begin : begin + int(stride * height)], dtype=np.uint8).reshape(height, stride)
    return rows[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1]  # blue, green, red, nothing


def settled(path):
    """The pixels when they rest: a panel follows its script."""
    end = time.monotonic() + SECONDS
    before = screen(path).copy()
    while time.monotonic() < end:
        time.sleep(3)
        now = screen(path).copy()
        if (now != before).any(axis=2).mean() < RESTLESS:
            return now
        before = now
    sys.exit("ParaView's window did not come to rest.")


def drag(display, begin, end):
    """Moves what lies under the pointer."""
    x11, xtest = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    connection = ctypes.c_void_p(x11.XOpenDisplay(display.encode()))
    steps = [tuple(round(b + (e - b) * i / 8) for b, e in zip(begin, end)) for i in range(9)]
    for i, (x, y) in enumerate(steps):
        xtest.XTestFakeMotionEvent(connection, -1, x, y, 0)
        if i == 0:
            xtest.XTestFakeButtonEvent(connection, 1, 1, 0)
        x11.XFlush(connection)
        time.sleep(0.2)
    xtest.XTestFakeButtonEvent(connection, 1, 0, 0)
    xtest.XTestFakeMotionEvent(connection, -1, WIDTH - 1, HEIGHT - 1, 0)
    x11.XSync(connection, 0)
    x11.XCloseDisplay(connection)


def write(pixels, path):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    few = pixels // 8 * 8 + pixels // 32  # 32 levels a color: two thirds of the file's size
    colors = np.ascontiguousarray(few[::-1]).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    writer = vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def main(paraview, model, picture):
    work = tempfile.mkdtemp(prefix="stipple-picture-")
    ended = []
    try:
        read, write_end = os.pipe()
        server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-fbdir", work],
            pass_fds=[write_end],
            stderr=subprocess.DEVNULL,
        )
        ended.append(server)
        os.close(write_end)
        display = ":" + os.read(read, 16).decode().strip()
        ready = os.path.join(work, "ready")
        environment = dict(os.environ, DISPLAY=display, HOME=work, STIPPLE_MODEL=model, STIPPLE_READY=ready)
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "window.py")
        window = subprocess.Popen(
            [paraview, "--dr", f"--script={script}", "-geometry", f"{WIDTH}x{HEIGHT}+0+0"],
            env=environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        ended.append(window)
        end = time.monotonic() + SECONDS
        while not os.path.exists(ready) and window.poll() is None and time.monotonic() < end:
            time.sleep(0.5)
        if not os.path.exists(ready):
            window.kill()
            sys.exit("ParaView did not get ready:\n" + window.communicate()[1][-4000:])
        pixels = os.path.join(work, "Xvfb_screen0")
        settled(pixels)
        drag(display, SPLITTER, WIDER)
        write(settled(pixels), picture)
    finally:
        for process in reversed(ended):
            process.kill()
            process.wait()
        shutil.rmtree(work)


if __name__ == "__main__":
    main(*sys.argv[1:])
