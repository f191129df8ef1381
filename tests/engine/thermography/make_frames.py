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


def lzw(data):
    """After TIFF 6.0, section 13."""
    bits = []
    table, width = {}, 9

    def put(code):
        bits.append(format(code, f"0{width}b"))

    def clear():
        put(256)
        table.clear()
        table.update({bytes([i]): i for i in range(256)})
        return 9

    width = clear()
    known, following = b"", 258
    for i in range(len(data)):
        byte = data[i:i + 1]
        if known + byte in table:
            known += byte
            continue
        put(table[known])
        table[known + byte] = following
        following += 1
        known = byte
        if following in (512, 1024, 2048):
            width += 1
        elif following == 4094:
            width, following = clear(), 258
    put(table[known])
    put(257)
    text = "".join(bits)
    text += "0" * (-len(text) % 8)
    return bytes(int(text[i:i + 8], 2) for i in range(0, len(text), 8))


def stack(pictures, order="<", pack=None, strip=None, tile=None, differences=False):
    """A TIFF with a page for each picture, in strips of some rows or in square tiles, packed with Deflate (8) or LZW (5)."""
    text = bytearray((b"II" if order == "<" else b"MM") + struct.pack(order + "HI", 42, 0))
    link = 4  # where the offset of the next directory goes
    for rows in pictures:
        height, width = len(rows), len(rows[0])
        if tile:
            pieces = [[[rows[min(y, height - 1)][min(x, width - 1)] for x in range(left, left + tile)] for y in range(top, top + tile)]
                      for top in range(0, height, tile) for left in range(0, width, tile)]
        else:
            pieces = [rows[top:top + (strip or height)] for top in range(0, height, strip or height)]
        offsets, lengths = [], []
        for piece in pieces:
            if differences:
                piece = [row[:1] + [(b - a) % 65536 for a, b in zip(row, row[1:])] for row in piece]
            data = raw(piece, order)
            data = {None: bytes, 8: zlib.compress, 5: lzw}[pack](data)
            offsets.append(len(text))
            lengths.append(len(data))
            text += data + b"\0" * (len(data) % 2)
        tags = [(256, 4, [width]), (257, 4, [height]), (258, 3, [16]), (259, 3, [pack or 1]), (262, 3, [1]), (277, 3, [1])]
        if differences:
            tags.append((317, 3, [2]))
        if tile:
            tags += [(322, 4, [tile]), (323, 4, [tile]), (324, 4, offsets), (325, 4, lengths)]
        else:
            tags += [(273, 4, offsets), (278, 4, [strip or height]), (279, 4, lengths)]
        entries = b""
        for tag, form, values in sorted(tags):
            packed = struct.pack(f"{order}{len(values)}{'H' if form == 3 else 'I'}", *values)
            if len(packed) > 4:
                packed, at = struct.pack(order + "I", len(text)), packed
                text += at
            entries += struct.pack(order + "HHI", tag, form, len(values)) + packed.ljust(4, b"\0")
        text[link:link + 4] = struct.pack(order + "I", len(text))
        text += struct.pack(order + "H", len(tags)) + entries
        link = len(text)
        text += b"\0\0\0\0"
    return bytes(text)


def expect(name, data, profile, rows, kelvin_of, warnings=0):
    (out / name).write_bytes(data)
    degC = [[kelvin_of(v) - 273.15 for v in row] for row in rows]
    flat = [t for row in degC for t in row]
    samples = [[x, y, degC[y][x]] for x, y in ((0, 0), (len(rows[0]) - 1, 0), (0, len(rows) - 1), (len(rows[0]) // 3, len(rows) // 2),
                                                (len(rows[0]) - 1, len(rows) - 1))]
    good[name] = {"profile": profile, "width": len(rows[0]), "height": len(rows), "min_degC": min(flat), "max_degC": max(flat),
                  "mean_degC": sum(flat) / len(flat), "samples": samples, "warnings": warnings}


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

expect("lepton_strips.tif", stack([lepton], strip=7), "lepton-3.5", lepton, centikelvin)
expect("lepton_lzw.tif", stack([lepton], pack=5, strip=32), "lepton-3.5", lepton, centikelvin)
expect("lepton_lzw_motorola.tif", stack([lepton], ">", 5, 32, differences=True), "lepton-3.5", lepton, centikelvin)
expect("lepton_tiles.tif", stack([lepton], tile=64), "lepton-3.5", lepton, centikelvin)
expect("lepton_tiles_motorola.tif", stack([lepton], ">", 8, tile=32), "lepton-3.5", lepton, centikelvin)
lepton25 = scene(80, 60, 25, 29515, 33315)
expect("lepton25.raw", raw(lepton25), "lepton-2.5", lepton25, centikelvin)
expect("lepton25_telemetry.raw", raw(lepton25 + [[i % 5 for i in range(80)]] * 3), "lepton-2.5", lepton25, centikelvin)

random = noise(5)
visible = [[next(random) for _ in range(256)] for _ in range(192)]
for name, profile in (("p2pro", "p2-pro"), ("tc001", "tc001")):
    cold = scene(256, 192, len(name), 18780, 21500)
    expect(f"{name}.yuyv", raw(visible + cold), profile, cold, sixtyfourths)
    expect(f"{name}.png", png(cold), profile, cold, sixtyfourths)
    expect(f"{name}_whole.png", png(visible + cold), profile, cold, sixtyfourths)
hot = scene(256, 192, 9, 18780, 30000)
expect("p2pro_hot.raw", raw(visible + hot), "p2-pro", hot, sixtyfourths, 1)

# A plain picture in YUYV: brightness in the low bytes; colour in the high ones, without any 128.
def shades(low, high):
    return [[low + (high - low) * (x + 2 * y) // (256 + 2 * 192) for x in range(256)] for y in range(192)]


grey = [[0x8000 + v for v in row] for row in shades(16, 235)]
dull = [[0x8000 + v for v in row] for row in shades(60, 190)]
colours = [[((90, 160)[x % 2] << 8) + v for x, v in enumerate(row)] for row in shades(16, 235)]
at_240 = [[0x8000 + 140 + next(random) % 23 - 11 for _ in range(256)] for _ in range(192)]  # 241.0 degC, and noise
about_240 = [[0x8000 - 60 + v + v // 2 for v in row] for row in shades(0, 255)]  # 237.9 to 243.9 degC
for name, upper in (("grey", grey), ("colours", colours), ("noise", visible)):
    expect(f"p2pro_at_240_{name}.yuyv", raw(upper + at_240), "p2-pro", at_240, sixtyfourths, 2)
expect("p2pro_at_240.png", png(at_240), "p2-pro", at_240, sixtyfourths, 2)
expect("p2pro_about_240.yuyv", raw(grey + about_240), "p2-pro", about_240, sixtyfourths, 1)
expect("p2pro_dull.yuyv", raw(grey + dull), "p2-pro", dull, sixtyfourths, 2)  # nothing tells
for name, upper, lower in (("exchanged", cold, grey), ("exchanged_dull", cold, dull), ("exchanged_hot", hot, dull), ("plain", grey, grey),
                           ("part_in_colour", grey, [colours[y] if y < 40 else row for y, row in enumerate(grey)]),
                           ("colours", cold, colours), ("plain_colours", colours, colours)):
    refuse(f"p2pro_{name}.yuyv", raw(upper + lower), "p2-pro", "ThermalPlainPicture")
refuse("p2pro_exchanged.png", png(cold + dull), "p2-pro", "ThermalPlainPicture")
refuse("tc001_plain.png", png(grey), "tc001", "ThermalPlainPicture")

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
counting = [",".join(str(i) for i in range(160))] + table(degC, ",", ".")
expect("counting_line.csv", "\n".join(counting).encode(), "lepton-3.5", degC, kelvin)
names = [",".join(f"x{i}" for i in range(160)), ",".join(["°C"] * 160)]
expect("names_any_size.csv", "\n".join(names + table(degC, ",", ".")).encode(), None, degC, kelvin)
expect("units.csv", "\n".join(names[1:] + table(degC, ",", ".")).encode(), "lepton-3.5", degC, kelvin)
expect("decimal_commas.txt", "\n".join(table(degC, " ", ",")).encode(), "lepton-3.5", degC, kelvin)
expect("decimal_commas_any_size.txt", "\n".join(table(degC, "  ", ",")).encode(), None, degC, kelvin)
quoted = [",".join(f'"{cell}"' for cell in line.split(";")) for line in semicolon]
expect("quoted.csv", "\n".join(quoted).encode(), "lepton-3.5", degC, kelvin)
expect("quoted_any_size.csv", "\n".join(['"a, b","c"'] + quoted).encode(), None, degC, kelvin)
ramp = [[float(x + 160 * y % 7) for x in range(160)] for y in range(120)]  # counts, but is the picture
expect("ramp.csv", "\n".join(table(ramp, ",", ".", 0)).encode(), "lepton-3.5", ramp, kelvin)
expect("ramp_any_size.csv", "\n".join(table(ramp, ",", ".", 0)).encode(), None, ramp, kelvin)

masked = [",".join(["---"] * 160)]
for profile, name in (("lepton-3.5", "masked"), (None, "masked_any_size")):
    refuse(f"{name}.csv", "\n".join(masked + table(degC[1:], ",", ".")).encode(), profile, "ThermalCellUnusable")
refuse("masked_with_names.csv", "\n".join(masked + names[:1] + masked + table(degC, ",", ".")).encode(), None, "ThermalCellUnusable")
refuse("empty_row.csv", "\n".join([";" * 159] + semicolon[1:]).encode(), None, "ThermalCellUnusable")
tabs = table(degC, "\t", ".")
refuse("gap_any_size.tsv", "\n".join(tabs[:40] + ["\t" * 159] + tabs[41:]).encode(), None, "ThermalRowLength")
expect("tabs_after.tsv", "\n".join(tabs + ["\t" * 159] * 2 + [""]).encode(), None, degC, kelvin)
refuse("counting_line_any_size.csv", "\n".join(counting).encode(), None, "ThermalLineCounts")
refuse("counting_column_any_size.csv", "\n".join(f"{i},{line}" for i, line in enumerate(table(degC, ",", "."))).encode(), None,
       "ThermalColumnCounts")
refuse("thousands.csv", "\n".join([quoted[0].replace(quoted[0].split('","')[1], "1,234", 1)] + quoted[1:]).encode(), "lepton-3.5",
       "ThermalCellUnusable")
refuse("either.raw", struct.pack("<H", 29999) * (61 * 19200), "lepton-3.5", "ThermalFramesEither")
refuse("big.tif", b"II+\0\x08\0\0\0" + struct.pack("<Q", 16) + bytes(100), "lepton-3.5", "ThermalBigTiff")
refuse("big_without_ending", b"MM\0+\0\x08\0\0" + struct.pack(">Q", 16) + bytes(100), "lepton-3.5", "ThermalBigTiff")
circle = bytearray(stack([lepton, lepton]))
circle[-4:] = circle[4:8]  # the last page is followed by the first
refuse("circle.tif", bytes(circle), "lepton-3.5", "ImageUnreadable")
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

# Files of three frames.
three = [scene(160, 120, seed, 29515, 33315) for seed in (21, 22, 23)]
(out / "three.raw").write_bytes(b"".join(raw(rows) for rows in three))
(out / "three.tif").write_bytes(stack(three, strip=40))
(out / "three_motorola.tif").write_bytes(stack(three, ">", 5))
(out / "three.json").write_text(json.dumps([rows[60][80] / 100 - 273.15 for rows in three]))

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
