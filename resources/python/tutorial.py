"""Reading a recorded run of Bask in Python, in small steps.

    python3 tutorial.py SESSION [OTHER_SESSION]

bask.py must lie beside this file, or in a folder of PYTHONPATH. Each section begins with "# %%": editors such as Spyder
and VS Code run it as a cell, and a notebook takes it as it is.
"""

import json
import sys

import numpy as np

import bask

PATH = sys.argv[1] if len(sys.argv) > 1 else "run.bask"
OTHER = sys.argv[2] if len(sys.argv) > 2 else PATH

# %% 1. Open a session. Printing it gives an overview.
session = bask.open(PATH)
print(session)

# %% 2. Columns. Each is a NumPy array with one value a sample. Its name says what it is, and its unit.
for column in session.columns:
    print(f"{column:45} {session[column].dtype}")

# The columns of one object, without its name in front. Both are the same array.
name = list(session.objects)[0]
disk = session.objects[name]
print(name, "measured", disk["measured (degC)"][:5], "degC")
assert disk["measured (degC)"] is session[f"{name} measured (degC)"]

# %% 3. What is not known is NaN. "reading valid" tells which readings count; it is an array of bool, to select with.
for name, columns in session.objects.items():
    valid = columns["reading valid (1)"]
    if valid.any():
        measured = columns["measured (degC)"][valid]
        print(f"{name}: {valid.sum()} of {valid.size} readings are valid, from {measured.min():.1f} to"
              f" {measured.max():.1f} degC")

# %% 4. Plot the temperatures with their targets.
try:
    import matplotlib.pyplot as plt
except ImportError:
    print("matplotlib is not installed: no plot")
else:
    figure, axes = plt.subplots()
    for name, columns in session.objects.items():
        line, = axes.plot(session.time_s, columns["measured (degC)"], label=name)
        axes.plot(session.time_s, columns["target (degC)"], "--", color=line.get_color())
    axes.set(xlabel="time since Start (s)", ylabel="temperature (°C)", title=session.header["title"])
    axes.legend()
    figure.savefig("tutorial.png")
    print("the plot is in tutorial.png")

# %% 5. The part of the run that was controlled: until Stop. What follows is the retreat.
STOPS = ("EventStopped", "EventStoppedFor", "EventEmergencyStop")
stop_s = min((event.time_s for event in session.events if event.code in STOPS), default=np.inf)
controlled = session.time_s <= stop_s
print(f"controlled for {session.time_s[controlled].max(initial=0.0):.1f} s")

# %% 6. Settling time: from which time on does the error stay within a band, until Stop?
BAND_K = 0.5


def settled_from(columns, of):
    """The time in s, or None. A value that is not known counts as outside."""
    outside = np.flatnonzero(~(np.abs(columns["error (K)"][of]) <= BAND_K))
    first = outside[-1] + 1 if outside.size else 0
    return session.time_s[of][first] if first < of.sum() else None


for name, columns in session.objects.items():
    time_s = settled_from(columns, controlled)
    print(f"{name}: " + ("not settled" if time_s is None else f"settled from {time_s:.1f} s on, within {BAND_K} K"))

# %% 7. View factor against the heat balance of docs/model.md, with T in kelvin:
#
#     dT/dt = lambda1 s F - lambda2 (T^4 - T3^4)
#
# F is the recorded view factor, T3 the room's temperature, and s = (T1^4 - T3^4) / (T1_0^4 - T3^4) the strength of the
# source, of which T1_0 is its first temperature here. Integrated over time, the balance is linear in lambda1 and
# lambda2, so that least squares give both. `bask identify` does this with more care, and gives standard errors.
ZERO_K = 273.15
start = [json.loads(command.value) for command in session.commands if command.name == "start"]
T3 = start[0]["environment_K"] if start and "environment_K" in start[0] else 298.15


def integral(values, time_s):
    steps = 0.5 * (values[1:] + values[:-1]) * np.diff(time_s)
    return np.concatenate([[0.0], np.cumsum(steps)])


fits = {}
for name, columns in session.objects.items():
    use = controlled & columns["reading valid (1)"] & np.isfinite(columns["view factor (1)"])
    use &= np.isfinite(session["source (degC)"])
    if use.sum() < 20:
        continue
    time_s, T = session.time_s[use], columns["measured (degC)"][use] + ZERO_K
    T1 = session["source (degC)"][use] + ZERO_K
    strength = (T1**4 - T3**4) / (T1[0]**4 - T3**4)
    heating = integral(strength * columns["view factor (1)"][use], time_s)
    cooling = integral(T**4 - T3**4, time_s)
    terms = np.column_stack([np.ones_like(T), heating, -cooling])
    (T0, lambda1, lambda2), *_ = np.linalg.lstsq(terms / [1.0, 1.0, 1e9], T, rcond=None)
    lambda2 /= 1e9
    model = terms @ [T0, lambda1, lambda2]
    fits[name] = lambda1, heating[-1], lambda2, cooling[-1]
    print(f"{name}: lambda1 = {lambda1:.4g} K/s, lambda2 = {lambda2:.3g} 1/(K3 s); view factor"
          f" {columns['view factor (1)'][use][-1]:.4f} at the end; measured minus model at most"
          f" {np.abs(T - model).max():.2f} K")

# %% 8. Energy. The heat capacity of an object's face, c rho d in J/(m2 K), makes energies of these temperatures.
for each in session.experiment["objects"]:
    material = each["material"]
    keys = ("specific_heat_J_kgK", "density_kg_m3", "thickness_mm")
    if each["name"] not in fits or not all(key in material for key in keys):
        continue
    specific_heat, density, thickness_mm = (material[key] for key in keys)
    capacity = specific_heat * density * thickness_mm / 1e3 * material.get("infill", 1.0)
    lambda1, heating, lambda2, cooling = fits[each["name"]]
    print(f"{each['name']}: took {capacity * lambda1 * heating:.0f} J/m2 from the source and gave"
          f" {capacity * lambda2 * cooling:.0f} J/m2 to the room")

# %% 9. Events: what happened, with a stable code and a sentence in English.
for event in session.events:
    print(f"{event.time_s:8.1f} s  {event.code:28} {event.text}")
for note in session.notes:
    print(f"{note.time_s:8.1f} s  noted: {note.text}")

# %% 10. pandas: the same columns as a DataFrame over the time.
try:
    frame = session.to_pandas()
except ImportError as error:
    print(error)
else:
    print(frame.filter(like="error (K)").describe())

# %% 11. Compare two runs, which need not have the same times: the second is interpolated at the times of the first.
other = bask.open(OTHER)
for name in session.objects.keys() & other.objects.keys():
    own, theirs = (run.objects[name]["estimate (degC)"] for run in (session, other))
    both = session.time_s <= other.time_s.max(initial=0.0)
    known = np.isfinite(theirs)
    if not both.any() or not known.any():
        continue
    at_same_times = np.interp(session.time_s[both], other.time_s[known], theirs[known])
    print(f"{name}: the runs differ by at most {np.nanmax(np.abs(own[both] - at_same_times)):.2f} K")
