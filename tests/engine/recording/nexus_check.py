"""Reads a NeXus file with h5py and prints what bask_export_test compares; exits 77 where h5py is not installed."""

import sys

try:
    import h5py
except ImportError:
    sys.exit(77)


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


with h5py.File(sys.argv[1], "r") as file:
    entry = file[text(file.attrs["default"])]
    plot = entry[text(entry.attrs["default"])]
    signal = plot[text(plot.attrs["signal"])]
    axis = plot[text(plot.attrs["axes"][0])]
    print(text(entry.attrs["NX_class"]), text(entry["start_time"][()]), len(axis), text(signal.attrs["units"]))
    print(repr(float(signal[-1])))
    print([text(name) for name in entry["events/text"][()]])

    problems = []

    def look(path, thing):
        if isinstance(thing, h5py.Group):
            if "NX_class" not in thing.attrs:
                problems.append(path + " has no NX_class")
            elif text(thing.attrs["NX_class"]) == "NXlog" and len(thing["time"]) != len(thing["value"]):
                problems.append(path + " has times for other values")
        elif thing.dtype.kind in "fi" and "units" not in thing.attrs:
            problems.append(path + " has no units")

    file.visititems(look)
    print(problems)
