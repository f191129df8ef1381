"""Reads what Bask recorded: sessions (*.bask), also while they are recorded, and the NeXus files (*.nxs) made of them.
It never writes.

Copy this file beside your own program, or name its folder in PYTHONPATH. It needs Python 3.9 and NumPy; pandas, xarray
and h5py only for what they are named for.

    import bask

    session = bask.open("run.bask")
    session.time_s                                  # s since Start
    session["bunny measured (degC)"]                # columns are named as in traces.csv of `bask export`
    session.objects["bunny"]["measured (degC)"]     # the same array
    print(session)                                  # an overview

A value that is not known is NaN. docs/python.md says what else there is.
"""

import importlib
import io
import itertools
import json
import math
import os
import pathlib
import re
import sqlite3
import sys
from collections import namedtuple

import numpy as np

_APPLICATION = 0x4261736B  # "Bask", in the header of the file
_VERSION = 2  # of session files, the newest that is read here
_CHUNK = 4096  # samples that fit the processor's cache

# name: in traces.csv; key: in the session file; table: in its version 1 (None: it came later); log: in the NeXus file
_Column = namedtuple("_Column", "name unit key table log")
_POSE = tuple(_Column("", "", key, "pose", f"instrument/robot/{key.split('_')[0]}")
              for key in ("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"))
_SOURCE_POSE = [f"source_{column.key}" for column in _POSE]  # looked at, not shown; unknown where it is the experiment's
# From engine/model/trace_sample.h, by the test PythonColumns (CONTRIBUTING.md):
_RUN = (
    _Column("source", "degC", "source_K", "source",
            "instrument/heat_source_surface/value_log"),
)
_OBJECT = (
    _Column("measured", "degC", "measured_K", "sample",
            "temperature_env/sensor/value_log"),
    _Column("estimate", "degC", "estimated_K", "sample",
            "temperature_estimate"),
    _Column("target", "degC", "target_K", "sample",
            "temperature_target"),
    _Column("error", "K", "", None,
            None),
    _Column("rate", "K/s", "rate_K_s", "sample",
            "temperature_env/sensor/value_deriv1_log"),
    _Column("view factor", "1", "view_factor", "sample",
            "view_factor"),
    _Column("view factor without shade", "1", "view_factor_unshaded", None,
            "view_factor_unshaded"),
    _Column("reading valid", "1", "reading_valid", "object_state",
            "temperature_env/sensor/valid_log"),
    _Column("true", "degC", "temperature_K", "truth",
            "temperature_true"),
    _Column("camera", "degC", "camera_K", None,
            "temperature_env/thermal_camera/value_log"),
    _Column("camera standard uncertainty", "K", "camera_uncertainty_K", None,
            "temperature_env/thermal_camera/uncertainty_log"),
    _Column("camera spread", "K", "camera_spread_K", None,
            "temperature_env/thermal_camera/spread_log"),
    _Column("camera pixels", "1", "camera_pixels", None,
            "temperature_env/thermal_camera/pixels_log"),
)
# Not in traces.csv:
_OTHER_RUN = (
    _Column("vx", "m/s", "vx_m_s", "motion",
            "instrument/robot/vx"),
    _Column("vy", "m/s", "vy_m_s", "motion",
            "instrument/robot/vy"),
    _Column("vz", "m/s", "vz_m_s", "motion",
            "instrument/robot/vz"),
    _Column("wx", "rad/s", "wx_rad_s", "motion",
            "instrument/robot/wx"),
    _Column("wy", "rad/s", "wy_rad_s", "motion",
            "instrument/robot/wy"),
    _Column("wz", "rad/s", "wz_rad_s", "motion",
            "instrument/robot/wz"),
    _Column("smallest singular value", "1", "smallest_singular_value", "motion",
            "instrument/robot/smallest_singular_value"),
    _Column("limited", "1", "limited", "motion",
            "instrument/robot/limits"),
)
_OTHER_OBJECT = (
    _Column("lambda1", "K/s", "lambda1_K_s", "object_state",
            "lambda1"),
    _Column("lambda2", "1/(K^3 s)", "lambda2_1_K3s", "object_state",
            "lambda2"),
)
# That far.
_THETA = tuple(f"theta_{axis} (rad)" for axis in "xyz")
_EQUAL_TIMES = 10  # samples of one moment; no run has more than two
# Where NeXus files of Bask 0.2.0 have what has another place now:
_EARLIER = {"run/simulated": "simulated", "run/outcome": "outcome", "properties/time": "time",
            "instrument/heat_source_surface/value_log/value": "instrument/heat_source/surface/value_log/value"}


Event = namedtuple("Event", "time_s code text args")  # text: in English; args: what it is filled with, None from NeXus
Command = namedtuple("Command", "time_s name value operator", defaults=("",))  # value: JSON
Note = namedtuple("Note", "time_s text operator", defaults=("",))


class FileError(ValueError):
    """A file that cannot be read. Its text says what is wrong, where, and what to do."""


class Session:
    """A recorded run, as it was at the moment of opening."""

    def __init__(self, path):
        self.path = os.fsdecode(path)
        with io.open(path, "rb") as file:
            start = file.read(100)
        try:
            if start.startswith(b"SQLite format 3\0"):
                found = _read_session(self.path, start)
            elif start.startswith(b"\x89HDF\r\n\x1a\n"):
                found = _read_nexus(self.path)
            else:
                raise _foreign(self.path)
            self._take(*found)
        except FileError:
            raise
        except sqlite3.Error as error:
            raise _refused(self.path, error) from None
        except (ArithmeticError, AttributeError, LookupError, OSError, RuntimeError, TypeError, ValueError) as error:
            raise _damaged(self.path, error) from None

    def _take(self, rig, header, events, commands, notes, values):
        self.header, self.experiment = header, rig.experiment
        self.events, self.commands, self.notes = events, commands, notes
        self.time_s = values["time_s"]
        for column, number in rig.stored:  # what came later than the file
            if _key(column, number) not in values:
                values[_key(column, number)] = np.full(len(self.time_s), np.nan)
        why = _impossible(rig, values)
        if why:
            raise _damaged(self.path, why)
        traces, other = {"time (s)": self.time_s}, {}
        for into, columns in ((traces, _RUN), (other, _OTHER_RUN)):
            into.update((_header(column), _shown(column, values[column.key])) for column in columns)
        traces.update({f"{axis} (m)": values[f"{axis}_m"] for axis in "xyz"})
        self._rotation = {key: values[key] for key in ("qw", "qx", "qy", "qz")}
        traces.update(dict.fromkeys(_THETA))  # they take a quarter of the time: when they are asked for
        self.objects = {}
        for number, name in enumerate(rig.names, 1):
            values[f"_{number}"] = _without_rest(values[f"measured_K_{number}"] - values[f"target_K_{number}"])
            own = self.objects[name] = {}
            for into, columns in ((traces, _OBJECT), (other, _OTHER_OBJECT)):
                for column in filter(rig.has, columns):
                    shown = _shown(column, values[f"{column.key}_{number}"])
                    own[_header(column)] = into[f"{name} {_header(column)}"] = shown
        self.columns, self.other_columns = list(traces), list(other)
        self._arrays = {**traces, **other}

    def __getitem__(self, column):
        if column not in self._arrays:
            raise KeyError(f"no column {column!r}; session.columns and session.other_columns name them")
        if self._arrays[column] is None:
            self._arrays.update(zip(_THETA, _angles(self._rotation)))
        return self._arrays[column]

    def __iter__(self):
        return iter(self.columns)

    def to_pandas(self):
        """The columns as a DataFrame over the time."""
        pandas = _module("pandas")
        index = pandas.Index(self.time_s, name="time (s)")
        return pandas.DataFrame({column: self[column] for column in self.columns[1:]}, index)

    def to_xarray(self):
        """All columns as a Dataset over `time`, or `object` and `time`, with the attribute `units` at each variable."""
        xarray = _module("xarray")
        of_objects = {f"{name} {column}" for name, columns in self.objects.items() for column in columns}
        values = {column: ("time", self[column]) for column in self._arrays if column not in of_objects}
        for column in next(iter(self.objects.values())):
            values[column] = (("object", "time"), np.stack([columns[column] for columns in self.objects.values()]))
        variables = {}
        for column, value in values.items():
            name, unit = column[:-1].split(" (", 1)
            variables[name] = (*value, {"units": unit})
        variables["object"] = ("object", list(self.objects))
        facts = {key: str(value) for key, value in self.header.items() if value is not None}
        return xarray.Dataset(variables, attrs=facts)

    def __repr__(self):
        header, time_s = self.header, self.time_s
        outcome = header["outcome"] or "none: interrupted, or still being recorded"
        lines = [f"{self.path}: {header['title']}",
                 f"  recorded by {header['software']} on a {'simulated' if header['simulated'] else 'real'} rig"
                 f" from {header['created']}; outcome {outcome}",
                 f"  {len(time_s)} samples" + (f" from {time_s[0]:.6g} s to {time_s[-1]:.6g} s" if len(time_s) else "")]
        for name, columns in self.objects.items():
            last = [f"{key} {columns[f'{key} (degC)'][-1]:.2f} degC" for key in ("measured", "target") if len(time_s)]
            lines.append(f"  {name}" + (f": at the end {', '.join(last)}" if last else ""))
        lines.append(f"  {len(self.events)} events, {len(self.commands)} commands, {len(self.notes)} notes")
        return "\n".join("".join(c if c.isprintable() else " " for c in line) for line in lines)


def open(path):  # io.open is the one of Python
    """Opens a session, or a NeXus file that Bask exported, and reads all of it."""
    return Session(path)


class Field:
    """A field of `bask field ... -o FIELD.h5`. Nothing but its axes is read before it is asked for:

        field = bask.open_field("field.h5")
        field.axes                   # {"x": array, "y": array, ...}: the first one runs fastest
        field.values[3, :, :]        # h5py's data set: indexed by the last axis first
    """

    def __init__(self, path):
        h5py = _module("h5py")
        os.stat(path)  # FileNotFoundError
        try:
            self._file = h5py.File(path, "r")
            group = self._file["entry/field"]
            self.quantity = group.attrs["signal"].decode()
            names = [name if isinstance(name, str) else name.decode() for name in group.attrs["axes"]]
            self.axes = {name: group[name][()] for name in reversed(names)}
            self.values = group[self.quantity]
            self.gradient = group.get("view_factor_gradient")  # None: not sampled
            self.units = {name: data.attrs["units"].decode() for name, data in group.items()}
            self.held = {name: data[()] for name, data in self._file["entry/held"].items()}
            self.sampling = {name: data[()] for name, data in self._file["entry/sampling"].items()}
            self.title = _text(self._file["entry/title"][()])
        except (OSError, KeyError, AttributeError) as error:
            raise FileError(f"{path}: this is not a field that `bask field` wrote as HDF5 (*.h5), or it is damaged"
                            f" ({error}).") from None

    def close(self):
        self._file.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def to_xarray(self):
        """Reads all samples into a DataArray over the axes."""
        dims = list(reversed(self.axes))
        return _module("xarray").DataArray(self.values[()], dims=dims, coords={name: self.axes[name] for name in dims},
                                           name=self.quantity, attrs={"units": self.units[self.quantity], **self.held})


def open_field(path):
    """Opens a field of up to six axes; reads of it what is asked for."""
    return Field(path)


class _Rig:
    """The experiment of a recording, what its rig had, and what is therefore stored."""

    def __init__(self, experiment, simulated):
        self.experiment = json.loads(experiment)
        objects = self.experiment["objects"]
        self.names = [each["name"] for each in objects]
        self.simulated = {"true": True, "false": False}[simulated]
        self.has_camera = "thermal_camera" in self.experiment.get("simulation" if self.simulated else "rig", {}) or (
            self.simulated and any(each.get("read_by", "contact") != "contact" for each in objects))
        # each column with the number of its object; 0: of the run
        self.stored = [(column, 0) for column in _POSE + _RUN + _OTHER_RUN] + [
            (column, number) for number in range(1, len(objects) + 1)
            for column in filter(self.has, _OBJECT + _OTHER_OBJECT) if column.key]

    def has(self, column):
        return self.simulated if column.name == "true" else self.has_camera or not column.name.startswith("camera")

    def header(self, facts):
        known = dict.fromkeys(("version", "software", "created", "finished", "outcome", "operator", "sample", "batch", "tags"))
        return {**known, **facts, "simulated": self.simulated, "title": self.experiment.get("title", ""),
                "seed": self.experiment.get("simulation", {}).get("seed")}


def _header(column):
    return f"{column.name} ({column.unit})"


def _key(column, number):
    return f"{column.key}_{number}" if number else column.key


def _read_session(path, start):
    real = pathlib.Path(path).resolve()  # the log lies beside the file itself, not beside a link to it
    has_log = os.path.exists(f"{real}-wal")
    page, pages = int.from_bytes(start[16:18], "big"), int.from_bytes(start[28:32], "big")
    if len(start) < 100 or (not has_log and start[24:28] == start[92:96] and
                            os.path.getsize(path) < pages * (65536 if page == 1 else page)):
        raise _damaged(path, "it is cut short")
    # Without a log nobody writes: read without locks, which leaves nothing beside the file and works in any folder.
    con = sqlite3.connect(real.as_uri() + ("?mode=ro" if has_log else "?mode=ro&immutable=1"), uri=True)
    try:
        con.text_factory = lambda text: text.decode("utf-8", "replace")
        con.execute("BEGIN")  # all of one moment
        if con.execute("PRAGMA application_id").fetchone()[0] != _APPLICATION:
            raise _foreign(path)
        version = con.execute("PRAGMA user_version").fetchone()[0]
        if version > _VERSION:
            raise FileError(f"{path}: the file has version {version}, and this bask.py reads versions up to {_VERSION}."
                            " Take the bask.py of the Bask that recorded it.")
        tables = _Tables(con, path)
        facts = dict(tables.select("meta", "key, value", ""))
        rig = _Rig(tables.select("experiment", "json").fetchone()[0], facts["simulated"])
        facts.update(version=version, tags=json.loads(facts.get("tags", "[]")))
        events = [Event(time_s, code, text, tuple(json.loads(args)))
                  for time_s, code, text, args in tables.select("event", "time_s, code, text, args")]
        commands = [Command(*row) for row in tables.signed("command", "time_s, name, value")]
        notes = [Note(*row) for row in tables.signed("note", "time_s, text")]
        if not all(isinstance(row.time_s, (int, float)) and math.isfinite(row.time_s) for row in (*events, *commands, *notes)):
            raise _damaged(path, "an event, a command or a note has a time that is none")
        values = tables.first_version(rig) if version < 2 else tables.steps(rig, None if has_log else real)
        return rig, rig.header(facts), events, commands, notes, values
    finally:
        con.close()


class _Tables:
    """The tables of a session file."""

    def __init__(self, con, path):
        self.con, self.path = con, path
        self.made = dict(con.execute("SELECT name, sql FROM sqlite_master WHERE type = 'table'"))

    def select(self, table, columns, order="ORDER BY rowid"):
        # A file from elsewhere must not compute when it is read: that need not end.
        made = self.made.get(table) or ""
        if not made.startswith("CREATE TABLE ") or re.search(r"\bAS\b", made, re.IGNORECASE):
            raise _damaged(self.path, f"it has no plain table {table}")
        return self.con.execute(f"SELECT {columns} FROM {table} {order}")

    def signed(self, table, columns):
        """With the operator, whom files did not name before."""
        has_operator = re.search(r"\boperator TEXT\b", self.made.get(table) or "")
        return self.select(table, columns + (", operator" if has_operator else ""))

    def numbers(self, table, columns):
        flat = itertools.chain.from_iterable(self.select(table, ", ".join(columns)))
        return np.fromiter(flat, float).reshape(-1, len(columns)).T.copy()  # NULL becomes NaN

    def check(self):
        verdict = self.con.execute("PRAGMA quick_check(1)").fetchone()[0]
        if verdict != "ok":
            raise _damaged(self.path, verdict)

    def steps(self, rig, file):
        """The samples of version 2, a row each."""
        if list(self.select("object", "number, name", "ORDER BY number")) != list(enumerate(rig.names, 1)):
            raise _damaged(self.path, "its objects are not those of its experiment")
        count = self.select("step", "max(number)", "").fetchone()[0] or 0
        there = [row[1] for row in self.con.execute("PRAGMA table_info(step)")]
        wanted = ["time_s"] + [_key(*each) for each in rig.stored if each[0].table or _key(*each) in there] + _SOURCE_POSE
        rows = None
        if file:
            root = self.con.execute("SELECT rootpage FROM sqlite_master WHERE name = 'step'").fetchone()[0]
            rows = _from_pages(file, root, [there.index(name) for name in wanted], len(there), count)
        if rows is None:
            self.check()
            numbers, *rows = self.numbers("step", ["number", *wanted])
            if not np.array_equal(numbers, np.arange(1, count + 1)):
                raise _damaged(self.path, "samples are missing")
        return dict(zip(wanted, rows))

    def first_version(self, rig):
        """The samples of version 1, in tables with a row a sample, or a row a sample and object."""
        self.check()
        values = {"time_s": self.numbers("pose", ["time_s"])[0]}
        for table in dict.fromkeys(column.table for column, _ in rig.stored if column.table):
            own = [each for each in rig.stored if each[0].table == table]
            keys = list(dict.fromkeys(column.key for column, _ in own))
            time_s, *rows = self.numbers(table, ["time_s", *keys] if table != "source" else ["time_s", "temperature_K"])
            owners = rig.names if own[0][1] else [""]
            objects = [row[0] for row in self.select(table, "object" if own[0][1] else "''")]
            if not np.array_equal(time_s, np.repeat(values["time_s"], len(owners))) or (
                    objects != owners * len(values["time_s"])):
                raise _damaged(self.path, f"the rows of table {table} do not go with the poses")
            for column, number in own:
                values[_key(column, number)] = rows[keys.index(column.key)][max(number - 1, 0)::len(owners)]
        if "source_pose" in self.made:  # later than the first files
            time_s, *rows = self.numbers("source_pose", ["time_s", *(column.key for column in _POSE)])
            if not np.array_equal(time_s, values["time_s"]):
                raise _damaged(self.path, "the rows of table source_pose do not go with the poses")
            values.update(zip(_SOURCE_POSE, rows))
        return values


def _from_pages(file, root, wanted, width, count):
    """The columns `wanted` of a table of `width` columns, from the pages of a file that nobody writes; None where only
    SQLite can read them.

    It is three times as fast as a SELECT, since no number becomes an object of Python on the way. The format is that of
    https://www.sqlite.org/fileformat2.html, sections 1.6 and 2.1.
    """
    data = np.asarray(np.memmap(file, np.uint8, "r"))
    u2, u4, i8, f8 = (np.ndarray(len(data) - int(kind[2]) + 1, kind, data, strides=(1,))
                      for kind in (">u2", ">u4", ">i8", ">f8"))  # what begins at each byte
    size = int(u2[16]) if u2[16] > 1 else 65536
    bytes_of = np.array([0, 1, 2, 3, 4, 6, 8, 8, 0, 0])  # of a value, by its type
    try:
        pages = np.array([(root - 1) * size])
        while data[pages[0]] == 5:  # from the root down to the leaves
            below = [np.append(u4[page + u2[page + 12:page + 12 + 2 * int(u2[page + 3]):2]], u4[page + 8])
                     for page in pages]
            if not len(pages) < sum(map(len, below)) <= len(data) // size:
                return None
            pages = (np.concatenate(below).astype(int) - 1) * size
        rows = u2[pages + 3].astype(int)
        if (data[pages] != 13).any() or rows.sum() != count:
            return None
        slots = np.arange(count) - np.repeat(np.cumsum(rows) - rows, rows)
        cells = np.repeat(pages, rows)
        cells = cells + u2[cells + 8 + 2 * slots]
        for _ in range(2):  # past the record's size and its number, of at most nine bytes each
            for _ in range(8):
                more = data[cells] >= 128
                if not more.any():
                    break
                cells += more
            cells += 1
        heads = np.lib.stride_tricks.sliding_window_view(data, width + 1)
        out = np.empty((len(wanted), count))
        for first in range(0, count, _CHUNK):
            begin = cells[first:first + _CHUNK]
            head = heads[begin]
            kinds = head[:, 1:].T
            ends = begin + (width + 1) + np.cumsum(bytes_of[kinds], axis=0)
            if (head[:, 0] != width + 1).any() or (ends[-1] - begin > size - int(data[20]) - 35).any():
                return None
            for row, index in zip(out, wanted):
                kind, end = kinds[index], ends[index]
                if not kind.any():  # nothing is known
                    row[first:first + _CHUNK] = np.nan
                    continue
                value = f8[end - 8].astype(float)
                for other in np.unique(kind[kind != 7]):
                    at = kind == other
                    unused = 64 - 8 * bytes_of[other]
                    value[at] = (np.nan if other == 0 else other - 8 if other >= 8
                                 else i8[end[at] - 8] << unused >> unused)
                row[first:first + _CHUNK] = value
        return out
    except IndexError:
        return None


def _read_nexus(path):
    h5py = _module("h5py")
    with h5py.File(path, "r") as file:
        if not _text(file.attrs.get("creator", "")).startswith("Bask "):
            raise _foreign(path)
        entry = file["entry"]
        rig = _Rig(_text(entry["experiment/data"][()]), _text(_at(entry, "run/simulated")[()]))
        values = {"time_s": entry["temperatures/time"][:]}
        for column, number in rig.stored:
            log = f"sample_{number}/{column.log}/value" if number else f"{column.log}/value"
            if column.table or log in entry:
                values[_key(column, number)] = _at(entry, log)[:].astype(float)
        facts = {"created": _text(entry["start_time"][()]), "outcome": _text(_at(entry, "run/outcome")[()]),
                 "software": _text(entry["run/recorded_by"][()] if "run/recorded_by" in entry
                                   else entry["program_name"].attrs["recorded_by"])}
        places = {"operator": "user/name", "sample": "sample_1/identifier_sample", "batch": "collection_identifier",
                  "finished": "end_time"}
        facts.update((key, _text(entry[place][()])) for key, place in places.items() if place in entry)

        def rows(group, *names):
            return zip(entry[f"{group}/time"][:].tolist(), *(map(_text, entry[f"{group}/{name}"][:]) for name in names))

        events = [Event(*row, None) for row in rows("events", "code", "text")]
        names = ("name", "value", "operator") if "commands/operator" in entry else ("name", "value")
        commands = [Command(*row) for row in rows("commands", *names)]
        places = itertools.takewhile(entry.__contains__, (f"note_{k}" for k in itertools.count(1)))
        notes = [Note(float(_at(entry[place], "properties/time")[()]),
                      _text(entry[place]["data"][()]).replace("\r\n", "\n"),
                      _text(entry[place]["author"][()]) if "author" in entry[place] else "") for place in places]
        return rig, rig.header(facts), events, commands, notes, values


def _at(group, place):
    return group[place if place in group else _EARLIER.get(place, place)]


def _text(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _without_rest(difference):
    """Without the digits that a difference brings: 40.23 and not 40.230000000000075."""
    return np.where(np.abs(difference) < 1e6, np.rint(difference * 1e9) / 1e9 + 0.0, difference)


def _impossible(rig, values):
    """What no run records, in words, as the program refuses it; None if there is nothing."""
    time_s = values["time_s"]
    if not np.isfinite(time_s).all():
        return "a sample has no time"
    if (np.diff(time_s) < 0.0).any():
        return "the times of its samples do not ascend"
    if (time_s[_EQUAL_TIMES:] == time_s[:-_EQUAL_TIMES]).any():
        return f"it has more than {_EQUAL_TIMES} samples of one moment"
    for which, keys in (("", [column.key for column in _POSE]), (" of the source", _SOURCE_POSE)):
        if keys[0] not in values:
            continue
        x, y, z, *q = pose = [values[key] for key in keys]
        with np.errstate(all="ignore"):
            bad = ~(np.abs(sum(part * part for part in q) - 1.0) < 1e-3) | ~np.isfinite(x + y + z)
        if bad.any():  # all unknown is possible
            bad &= ~np.logical_and.reduce([np.isnan(part) for part in pose])
        if bad.any():
            return f"sample {np.argmax(bad) + 1} has a pose{which} that is none"
    for column, number in rig.stored:
        if column.unit == "degC":
            value = values[_key(column, number)]
            bad = (value < 0.0) | np.isinf(value)
            if bad.any():
                return f"sample {np.argmax(bad) + 1} has {_key(column, number)} below absolute zero, or infinite"
    return None


def _shown(column, values):
    """As in traces.csv."""
    if column.unit == "degC":
        return _without_rest(values - 273.15)
    if column.key == "reading_valid":
        return values == 1.0
    if column.key == "limited":
        return np.where((values >= 0.0) & (values < 4096.0), values, 0.0).astype(int)
    return values


def _angles(values):
    """theta_x, theta_y, theta_z of R = Rz Ry Rx, by the steps of Bask in their order: equal to the last bit."""
    out = np.empty((3, len(values["qw"])))
    for first in range(0, out.shape[1], _CHUNK):
        x, y, z, w = (values[key][first:first + _CHUNK] for key in ("qx", "qy", "qz", "qw"))
        square = (x * x + z * z) + (y * y + w * w)
        x, y, z, w = np.array([x, y, z, w]) / np.sqrt(np.where(square > 0.0, square, 1.0))
        tx, ty, tz = 2.0 * x, 2.0 * y, 2.0 * z
        r00, r10, r20 = 1.0 - (ty * y + tz * z), ty * x + tz * w, tz * x - ty * w
        r21, r22 = tz * y + tx * w, 1.0 - (tx * x + ty * y)
        for row, a, b in zip(out, (r21, -r20, r10), (r22, np.hypot(r00, r10), r00)):
            # NumPy's own arctan2 may differ in the last bit
            row[first:first + _CHUNK] = list(map(math.atan2, a.tolist(), b.tolist()))
    return out


def _module(name):
    try:
        return importlib.import_module(name)
    except ImportError:
        raise ImportError(f"this needs the package {name}: apt install python3-{name}, or pip install {name}") from None


def _foreign(path):
    if os.path.getsize(path) == 0:
        return FileError(f"{path}: the file is empty. Nothing was recorded into it, or its copy was cut short.")
    return FileError(f"{path}: this is neither a session file of Bask (*.bask) nor a NeXus file that Bask exported"
                     " (*.nxs). Open one of these.")


def _damaged(path, why):
    why = f"{why} is missing" if isinstance(why, KeyError) else why
    return FileError(f"{path}: the file is damaged ({why}). Take another copy of it; of a session file the command"
                     " `sqlite3 FILE .recover` may save a part.")


def _refused(path, error):
    if "locked" in str(error):
        return FileError(f"{path}: another program keeps the file locked. Try again in a moment.")
    if "unable to open" in str(error) or "readonly" in str(error):
        return FileError(f"{path}: its log, {path}-wal, can only be read in a folder that you may write to. Copy both"
                         " files to one, and open the copy.")
    return _damaged(path, error)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python3 bask.py SESSION")
    try:
        print(Session(sys.argv[1]))
    except (FileError, ImportError, OSError) as problem:
        sys.exit(f"bask.py: {problem}")
