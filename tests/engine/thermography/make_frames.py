"""Writes frames of thermal cameras, good and bad, for frame_decoder_test.cpp and thermal_frame_command_test.cpp.

Usage: make_frames.py DIR. Shares nothing with Bask: its own writers of PNG and TIFF, its own numbers. expected.json says what
each good file holds, and which message each bad one is refused with.
"""

import json
import struct
import sys
import zlib
from pathlib import Path

out = Path(sys.argv[1])
out.mkdir(parents=True, exist_ok=True)
good, bad = {}, {}


def noise(seed):
    """Whole numbers from 0 to 65535."""
    state = seed
    while True:
        state = (6364136223846793005 * state + 1442695040888963407) % 2 ** 64
        yield state >> 48


def scene(width, height, seed, low, high):
    """Numbers of a warm disk on a cool ground, noisy, as rows."""
    random = noise(seed)
    rows = []
    for y in range(height):
        row = []
        for x in range(width):
            inside = (x - 0.4 * width) ** 2 + (y - 0.6 * height) ** 2 < (0.3 * height) ** 2
            base = high if inside else low + (high - low) * x // (4 * width)
            row.append(base + next(random) % 23 - 11)
        rows.append(row)
    return rows


def raw(rows, order="<"):
    return b"".join(struct.pack(f"{order}{len(row)}H", *row) for row in rows)


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(rows, bits=16, colour=0, channels=1):
    sample = ">H" if bits == 16 else ">B"
    lines = b"".join(b"\0" + b"".join(struct.pack(sample, v) * channels for v in row) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), bits, colour, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


def tiff(rows, order="<", compression=1, pages=1, bits=16, kind=1):
    data = raw(rows, order) if bits == 16 else b"".join(struct.pack(f"{order}{len(row)}f", *row) for row in rows)
    if compression == 8:
        data = zlib.compress(data)
    text = (b"II" if order == "<" else b"MM") + struct.pack(order + "HI", 42, 8)
    tags = [(256, 4, len(rows[0])), (257, 4, len(rows)), (258, 3, bits), (259, 3, compression), (262, 3, 1), (273, 4, None),
            (277, 3, 1), (278, 4, len(rows)), (279, 4, len(data)), (339, 3, kind)]
    size = 2 + 12 * len(tags) + 4
    for page in range(pages):
        start = 8 + page * size
        text += struct.pack(order + "H", len(tags))
        for tag, form, value in tags:
            value = 8 + pages * size if value is None else value
            text += struct.pack(order + "HHI", tag, form, 1)
            text += struct.pack(order + "HH", value, 0) if form == 3 else struct.pack(order + "I", value)
        text += struct.pack(order + "I", start + size if page + 1 < pages else 0)
    return text + data


def expect(name, data, profile, rows, kelvin_of):
    (out / name).write_bytes(data)
    degC = [[kelvin_of(v) - 273.15 for v in row] for row in rows]
    flat = [t for row in degC for t in row]
    samples = [[x, y, degC[y][x]] for x, y in ((0, 0), (len(rows[0]) - 1, 0), (0, len(rows) - 1), (len(rows[0]) // 3, len(rows) // 2),
                                                (len(rows[0]) - 1, len(rows) - 1))]
    good[name] = {"profile": profile, "width": len(rows[0]), "height": len(rows), "min_degC": min(flat), "max_degC": max(flat),
                  "mean_degC": sum(flat) / len(flat), "samples": samples}


def refuse(name, data, profile, code):
    (out / name).write_bytes(data)
    bad[name] = {"profile": profile, "code": code}


def centikelvin(value):
    return value / 100


def sixtyfourths(value):
    return value / 64


lepton = scene(160, 120, 1, 29515, 33315)
telemetry = [[i % 7 for i in range(160)], [65535] * 160]
expect("lepton.raw", raw(lepton), "lepton-3.5", lepton, centikelvin)
expect("lepton_telemetry.y16", raw(lepton + telemetry), "lepton-3.5", lepton, centikelvin)
expect("lepton_without_ending", raw(lepton), "lepton-3.5", lepton, centikelvin)
letters = [[0x7441 + (7 * x + 3 * y) % 25 for x in range(160)] for y in range(120)]  # bytes that are all letters
expect("letters", raw(letters), "lepton-3.5", letters, centikelvin)
expect("lepton.png", png(lepton), "lepton-3.5", lepton, centikelvin)
expect("lepton_telemetry.png", png(lepton + telemetry), "lepton-3.5", lepton, centikelvin)
expect("lepton.tif", tiff(lepton), "lepton-3.5", lepton, centikelvin)
expect("lepton_motorola.TIFF", tiff(lepton, ">"), "lepton-3.5", lepton, centikelvin)
expect("lepton_deflated.tiff", tiff(lepton, "<", 8), "lepton-3.5", lepton, centikelvin)
expect("tiff_without_ending", tiff(lepton), "lepton-3.5", lepton, centikelvin)

random = noise(5)
visible = [[next(random) for _ in range(256)] for _ in range(192)]
for name, profile in (("p2pro", "p2-pro"), ("tc001", "tc001")):
    cold = scene(256, 192, len(name), 18780, 21500)
    expect(f"{name}.yuyv", raw(visible + cold), profile, cold, sixtyfourths)
    expect(f"{name}.png", png(cold), profile, cold, sixtyfourths)
    expect(f"{name}_whole.png", png(visible + cold), profile, cold, sixtyfourths)
hot = scene(256, 192, 9, 18780, 30000)
expect("p2pro_hot.raw", raw(visible + hot), "p2-pro", hot, sixtyfourths)

own = {"name": "ours", "width": 80, "height": 60, "skip_top": 1, "skip_bottom": 2, "bits": 14, "byte_order": "big", "scale": 0.04,
       "unit": "degC", "offset": -40, "min_degC": -40, "max_degC": 500, "frame_rate_Hz": 2}
(out / "ours.json").write_text(json.dumps(own))
small = scene(80, 60, 3, 1600, 2400)
whole = [[7] * 80] + small + [[9] * 80] * 2
expect("ours.bin", raw(whole, ">"), "ours.json", small, lambda v: v * 0.04 - 40 + 273.15)
refuse("ours_swapped.bin", raw(whole, "<"), "ours.json", "ThermalBitsOver")
refuse("ours_without_rows.bin", raw(small, ">"), "ours.json", "ThermalFrameSize")


def table(rows, separator, decimal, digits=2):
    return [separator.join(f"{v:.{digits}f}".replace(".", decimal) for v in row) for row in rows]


degC = [[round(centikelvin(v) - 273.15, 2) for v in row] for row in lepton]
def kelvin(value):
    return value + 273.15


semicolon = table(degC, ";", ",")
expect("semicolon.csv", "\r\n".join(semicolon).encode(), "lepton-3.5", degC, kelvin)
head = ["\ufeffFile;C:\\IR\\FLIR0042.jpg", "Emissivity;0,95", "Reflected temperature;20,0;°C", ""]
expect("flir_header.csv", "\n".join(head + [line + ";" for line in semicolon]).encode(), "lepton-3.5", degC, kelvin)
expect("comma.csv", "\n".join(table(degC, ",", ".")).encode(), "lepton-3.5", degC, kelvin)
expect("any_size.csv", "\n".join(table(small_degC := [[v / 100 for v in row] for row in small], ",", ".")).encode(), None, small_degC, kelvin)
expect("tab.txt", "\n".join(table(degC, "\t", ",")).encode(), "lepton-3.5", degC, kelvin)
expect("blanks.tsv", ("# comment\n" + "\n".join(table(degC, "  ", "."))).encode(), "lepton-3.5", degC, kelvin)
expect("text_without_ending", "\n".join(semicolon).encode(), "lepton-3.5", degC, kelvin)
counted = [",".join([""] + [str(i) for i in range(160)])] + [f"{i},{line}" for i, line in enumerate(table(degC, ",", "."))]
expect("counted.csv", "\n".join(counted).encode(), "lepton-3.5", degC, kelvin)
expect("counted_any_size.csv", "\n".join(counted).encode(), None, degC, kelvin)
ramp = [[float(x + 160 * y % 7) for x in range(160)] for y in range(120)]  # counts, but is the picture
expect("ramp.csv", "\n".join(table(ramp, ",", ".", 0)).encode(), "lepton-3.5", ramp, kelvin)
expect("ramp_any_size.csv", "\n".join(table(ramp, ",", ".", 0)).encode(), None, ramp, kelvin)

refuse("empty.raw", b"", "lepton-3.5", "FileEmpty")
refuse("short.raw", raw(lepton)[:-1], "lepton-3.5", "ThermalFrameSize")
refuse("long.raw", raw(lepton) + b"\0", "lepton-3.5", "ThermalFrameSize")
refuse("one_telemetry_row.raw", raw(lepton + telemetry[:1]), "lepton-3.5", "ThermalFrameSize")
refuse("two_frames.raw", raw(lepton + lepton), "lepton-3.5", "ThermalFramesSeveral")
refuse("lower_half_alone.yuyv", raw(cold), "p2-pro", "ThermalFrameSize")
refuse("constant.raw", struct.pack("<H", 30000) * 19200, "lepton-3.5", "ThermalPictureConstant")
refuse("tlinear_off.raw", raw(scene(160, 120, 4, 7800, 8300)), "lepton-3.5", "ThermalNotTemperatures")
refuse("tenths_of_kelvin.raw", raw(scene(160, 120, 4, 2950, 3300)), "lepton-3.5", "ThermalNotTemperatures")
refuse("rgb.png", png(lepton, 16, 2, 3), "lepton-3.5", "ThermalPictureKind")
refuse("grey8.png", png([[v % 256 for v in row] for row in lepton], 8), "lepton-3.5", "ThermalPictureKind")
refuse("floats.tif", tiff([[float(v) for v in row] for row in lepton], "<", 1, 1, 32, 3), "lepton-3.5", "ThermalPictureKind")
refuse("signed.tif", tiff(lepton, "<", 1, 1, 16, 2), "lepton-3.5", "ThermalPictureKind")
refuse("two_pages.tif", tiff(lepton, "<", 1, 2), "lepton-3.5", "ThermalPictureSeveral")
refuse("truncated.png", png(lepton)[:-30], "lepton-3.5", "ImageUnreadable")
damaged = bytearray(png(lepton))
damaged[3000] ^= 0x55
refuse("damaged.png", bytes(damaged), "lepton-3.5", "ImageUnreadable")
refuse("truncated.tif", tiff(lepton)[:-1000], "lepton-3.5", "ImageUnreadable")
refuse("no_picture.png", b"a picture of a plate", "lepton-3.5", "ImageUnreadable")
refuse("other_size.png", png(small), "lepton-3.5", "ThermalPictureSize")
refuse("huge.png", b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 2 ** 31 - 1, 2 ** 31 - 1, 16, 0, 0, 0, 0)), "lepton-3.5",
       "ThermalPictureSize")
nan = list(semicolon)
nan[40] = nan[40].replace(nan[40].split(";")[3], "NaN", 1)
refuse("nan.csv", "\n".join(nan).encode(), "lepton-3.5", "ThermalCellUnusable")
refuse("nan_first.csv", "\n".join(["NaN;" + semicolon[0].split(";", 1)[1]] + semicolon[1:]).encode(), "lepton-3.5", "ThermalCellUnusable")
refuse("gap.csv", "\n".join(semicolon[:9] + [semicolon[9].replace(";", ";;", 1).rsplit(";", 1)[0]] + semicolon[10:]).encode(), "lepton-3.5",
       "ThermalCellUnusable")
refuse("below_absolute_zero.csv", "\n".join(semicolon[:-1] + [";".join(["-300"] * 160)]).encode(), "lepton-3.5", "ThermalCellUnusable")
refuse("ragged.csv", "\n".join(semicolon[:50] + [semicolon[50].rsplit(";", 1)[0]] + semicolon[51:]).encode(), "lepton-3.5", "ThermalRowLength")
refuse("missing_row.csv", "\n".join(semicolon[:-1]).encode(), "lepton-3.5", "ThermalPictureSize")
refuse("words.csv", b"File,plate.jpg\nno temperatures here\n", "lepton-3.5", "ThermalNoTable")
refuse("utf16.csv", "\n".join(semicolon).encode("utf-16"), "lepton-3.5", "FileUnreadable")
refuse("bytes.csv", raw(lepton), "lepton-3.5", "FileUnreadable")
refuse("constant.csv", "\n".join(table([[25.0] * 160] * 120, ",", ".")).encode(), "lepton-3.5", "ThermalPictureConstant")
refuse("no_profile.raw", raw(lepton), None, "ThermalProfileNeeded")

# A few pixels that the camera cannot tell: decoded, but the whole picture has no maximum.
saturated = [list(row) for row in lepton]
saturated[70][60] = saturated[70][61] = 65535
saturated[3][150] = 0
(out / "saturated.raw").write_bytes(raw(saturated))

folder = out / "folder"
folder.mkdir(exist_ok=True)
for name, seed in (("frame2.bin", 11), ("frame10.bin", 12), ("frame1.bin", 13)):
    (folder / name).write_bytes(raw([[7] * 80] + scene(80, 60, seed, 1600, 2400) + [[9] * 80] * 2, ">"))
(folder / "notes.md").write_text("not a frame")
timed = out / "timed"
timed.mkdir(exist_ok=True)
for name in ("b.csv", "a.csv"):
    (timed / name).write_bytes("\n".join(table(small_degC, ",", ".")).encode())
(timed / "times.csv").write_text("file;time_s\nb.csv;100,5\na.csv;101,75\n")

(out / "expected.json").write_text(json.dumps({"good": good, "bad": bad}, indent=1))
