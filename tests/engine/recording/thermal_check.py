"""Compares the thermal pictures of a session, read without Bask's code, with those in its NeXus file and its TIFF files.

    thermal_check.py SESSION.bask FILE.nxs FOLDER

The session's PNG are unpacked here by hand, with zlib; NeXus is read with h5py, TIFF with Pillow. Prints the number of
pictures, the share of their size that they take in the NeXus file, and what differs. Exits 77 where a library is missing.
"""

import csv
import os
import sqlite3
import struct
import sys
import zlib

try:
    import h5py
    import numpy
    from PIL import Image
except ImportError:
    sys.exit(77)


def paeth(a, b, c):
    p = a + b - c
    distances = abs(p - a), abs(p - b), abs(p - c)
    return (a, b, c)[distances.index(min(distances))]


def unfiltered(kind, line, above):
    """A line of a PNG of 16 bits in one channel, after PNG (third edition), section 9.2."""
    out = bytearray(line)
    for i in range(len(out)):
        left, up, corner = (out[i - 2], above[i], above[i - 2]) if i > 1 else (0, above[i], 0)
        out[i] = (out[i] + (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]) & 255
    return out


def numbers_of_png(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    at, packed, size = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            columns, rows, bits, colours, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            assert (bits, colours, interlaced) == (16, 0, 0), "not one channel of 16 bits"
            size = rows, columns
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    plain, stride = zlib.decompress(packed), 1 + 2 * size[1]
    above, lines = bytearray(stride - 1), []
    for row in range(size[0]):
        above = unfiltered(plain[row * stride], plain[row * stride + 1:(row + 1) * stride], above)
        lines.append(above)
    return numpy.frombuffer(b"".join(lines), ">u2").reshape(size)


session, nexus, folder = sys.argv[1:]
with sqlite3.connect("file:" + session + "?mode=ro", uri=True) as store:
    rows = store.execute("SELECT time_s, png FROM thermal_frame ORDER BY rowid").fetchall()
with open(os.path.join(folder, "times.csv"), newline="") as table:
    listed = [(line["file"], float(line["time_s"])) for line in csv.DictReader(table)]

problems = []
with h5py.File(nexus, "r") as file:
    camera = file["entry/instrument/thermal_camera"]
    data = camera["data"]
    if data.dtype != numpy.uint16 or data.chunks != (1,) + data.shape[1:] or not data.shuffle:
        problems.append("not a chunk a picture, 16 bits, shuffled")
    if file["entry/thermal_pictures"]["data"] != data:
        problems.append("other pictures are plotted")
    if file["entry/thermal_pictures"]["time"] != camera["start_time"]:
        problems.append("they are plotted over other times")
    if not len(rows) == len(listed) == len(data) == len(camera["start_time"]):
        problems.append("not as many pictures")
    for k, (time_s, png) in enumerate(rows):
        expected = numbers_of_png(png)
        name, listed_s = listed[k]
        if not numpy.array_equal(data[k], expected):
            problems.append("picture %d of the NeXus file differs" % k)
        if not numpy.array_equal(numpy.array(Image.open(os.path.join(folder, name))), expected):
            problems.append(name + " differs")
        if camera["start_time"][k] != time_s or abs(listed_s - time_s) > 1e-9:
            problems.append("picture %d has another time" % k)
    print(len(rows))
    print(data.id.get_storage_size() / data.nbytes)
print(problems)
