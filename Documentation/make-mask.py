#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Two inputs of the gallery, by Python's standard library alone: a mask and a picture of a spiral.

    python3 make-mask.py mask.off spiral.png
"""
import math
import struct
import sys
import zlib

RINGS = 70  # of triangles, from the middle to the rim


def bump(x, y, x0, y0, width, height):
    return math.exp(-(((x - x0) / width) ** 2) - ((y - y0) / height) ** 2)


def face(u, v):
    """A place of the unit disk on a face that looks to +z, with y up."""
    narrow = 0.76 - 0.16 * (0.5 - 0.5 * v) ** 2  # to the chin
    x, y = narrow * u, 1.05 * v
    z = 0.75 * math.sqrt(1.08 - u * u - v * v)
    z += 0.24 * bump(x, y, 0, -0.12, 0.12, 0.14) + 0.17 * bump(x, y, 0, 0.12, 0.08, 0.24)  # nose
    z += 0.07 * sum(bump(x, y, s * 0.11, -0.17, 0.05, 0.06) for s in (-1, 1))  # its wings
    z += 0.09 * sum(bump(x, y, s * 0.27, 0.40, 0.17, 0.07) for s in (-1, 1))  # brows
    z -= 0.17 * sum(bump(x, y, s * 0.27, 0.20, 0.14, 0.10) for s in (-1, 1))  # sockets
    z += 0.11 * sum(bump(x, y, s * 0.27, 0.20, 0.09, 0.055) for s in (-1, 1))  # eyes
    z += 0.07 * sum(bump(x, y, s * 0.36, -0.12, 0.16, 0.18) for s in (-1, 1))  # cheeks
    z += 0.06 * bump(x, y, 0, -0.42, 0.16, 0.05) + 0.07 * bump(x, y, 0, -0.54, 0.14, 0.06)  # lips
    z += 0.10 * bump(x, y, 0, -0.80, 0.18, 0.12)  # chin
    return x, y, z


def mask():
    """Rings of 6, 12, 18, ... points around one, and the triangles between them."""
    points, triangles, first = [face(0, 0)], [], [0]
    for ring in range(1, RINGS + 1):
        first.append(len(points))
        for i in range(6 * ring):
            angle, radius = math.pi * i / (3 * ring), ring / RINGS
            points.append(face(radius * math.cos(angle), radius * math.sin(angle)))
    for ring in range(1, RINGS + 1):
        inner, outer = max(1, 6 * (ring - 1)), 6 * ring
        for side in range(6):
            for i in range(ring):
                a = first[ring] + side * ring + i
                b = first[ring] + (side * ring + i + 1) % outer
                c = first[ring - 1] + (side * (ring - 1) + i) % inner
                triangles.append((a, b, c))
                if i + 1 < ring:
                    triangles.append((b, first[ring - 1] + (side * (ring - 1) + i + 1) % inner, c))
    return points, triangles


def spiral(size):
    """Rows of grey values, light where samples are wanted."""
    for row in range(size):
        for column in range(size):
            x, y = (2 * column + 1) / size - 1, 1 - (2 * row + 1) / size
            wave = math.cos(math.atan2(y, x) - 14 * math.hypot(x, y))
            yield round(8 + 247 / (1 + math.exp(-8 * wave)))


def write_png(path, grey, size):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows = b"".join(b"\0" + grey[size * row : size * (row + 1)] for row in range(size))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 0, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def main():
    points, triangles = mask()
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        file.writelines(f"{x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in points)
        file.writelines(f"3 {a} {b} {c}\n" for a, b, c in triangles)
    write_png(sys.argv[2], bytes(spiral(512)), 512)


if __name__ == "__main__":
    main()
