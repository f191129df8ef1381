"""bask.py against the CSV and NeXus files that Bask makes of the same sessions, of all versions; its errors and its
speed; the page about it and the tutorial.

    python3 bask_py_test.py BASK
"""

import contextlib
import csv
import io
import os
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MODULE = os.path.join(ROOT, "resources/python/bask.py")
BASK = sys.argv.pop(1)
SAMPLES_OF_A_DAY = 864_000

try:
    import numpy as np
except ImportError:
    print(f"not checked: bask.py, since {sys.executable} has no NumPy")
    sys.exit(77)

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(MODULE))
import bask  # noqa: E402


def has(module):
    try:
        __import__(module)
        return True
    except ImportError:
        print(f"not checked: what bask.py does with {module}, since {sys.executable} does not have it")
        return False


HAS_PANDAS, HAS_XARRAY, HAS_H5PY = has("pandas"), has("xarray"), has("h5py")
VIEWS = ("sample", "object_state", "truth", "pose", "motion", "source", "source_pose")
FIRST_VERSION = (  # as tests/support/first_version.h
    *(f"CREATE TABLE old_{view} AS SELECT * FROM {view}" for view in VIEWS),
    *(f"DROP VIEW {view}" for view in VIEWS),
    *(f"DROP TABLE {table}" for table in ("step", "object", "target_step", "overview")),
    *(f"ALTER TABLE old_{view} RENAME TO {view}" for view in VIEWS),
    "PRAGMA user_version = 1", "VACUUM")
WITHOUT_LATER = ("DROP VIEW sample", *(f"ALTER TABLE step DROP COLUMN {key}_{number}" for number in (1, 2, 3)
                                       for key in ("view_factor_unshaded", "camera_K", "camera_uncertainty_K",
                                                   "camera_spread_K", "camera_pixels")))
REAL_RIG = ("UPDATE meta SET value = 'false' WHERE key = 'simulated'",)
NOTED = ("INSERT INTO note VALUES(1.5, 'a draught, \"door\"', 'A. Hu')", "INSERT INTO note VALUES(2.5, '灯', '')",
         "INSERT INTO meta VALUES('tags', '[\"first\", \"wärme\"]')",
         "UPDATE step SET measured_K_2 = NULL, rate_K_s_2 = NULL, reading_valid_2 = 0 WHERE number % 7 = 3",
         "UPDATE step SET limited = 4100 WHERE number = 5",
         "UPDATE step SET x_m = NULL, y_m = NULL, z_m = NULL, qw = NULL, qx = NULL, qy = NULL, qz = NULL"
         " WHERE number = 22",
         "UPDATE step SET target_K_1 = 300.0 WHERE number > 30",
         "UPDATE step SET target_K_1 = 5e9 WHERE number = 9", "UPDATE step SET target_K_1 = 70000 WHERE number = 10",
         "UPDATE step SET rate_K_s_1 = -70000 WHERE number = 10",
         "UPDATE step SET rate_K_s_1 = -1e12 WHERE number = 11")

folder = tempfile.mkdtemp(prefix="bask-py-")
os.chmod(folder, 0o755)


def setUpModule():
    for name, example, seconds in (("run", "three-objects", 90), ("warm", "thermal-camera", 20)):
        subprocess.run([BASK, "run", os.path.join(ROOT, f"resources/examples/{example}.json"), "--seed", "7",
                        "--duration", str(seconds), "-o", path(name)], check=False, capture_output=True, timeout=300)
    alter(path("run"), *NOTED)
    with contextlib.closing(sqlite3.connect(path("run"))) as con:  # every angle
        for number in range(30, 80):
            turn = np.random.default_rng(number).normal(size=4)
            con.execute("UPDATE step SET qw = ?, qx = ?, qy = ?, qz = ? WHERE number = ?",
                        (*(turn / np.linalg.norm(turn)).tolist(), number))
        con.commit()


def tearDownModule():
    shutil.rmtree(folder)


def path(name):
    return os.path.join(folder, name if "." in name else f"{name}.bask")


def alter(file, *statements):
    """SQL on a session, behind Bask's back; returns the file."""
    with contextlib.closing(sqlite3.connect(file, isolation_level=None)) as con:
        for statement in ("PRAGMA journal_mode = DELETE", *statements):
            con.execute(statement)
    return file


def altered(*statements, name="altered", of="run"):
    return alter(shutil.copy(path(of), path(name)), *statements)


def exported(file, form="csv"):
    out = os.path.join(folder, f"{os.path.basename(file)}-{form}")
    digits = ["--all-digits"] if form == "csv" else []
    subprocess.run([BASK, "export", file, f"--{form}", out, *digits], check=True, capture_output=True, timeout=300)
    return out


def figures(value):
    """A number as std::to_chars writes it, in the fewest digits: with an exponent where that is shorter."""
    if isinstance(value, (bool, np.bool_, np.integer)):
        return str(int(value))
    if np.isnan(value):
        return ""
    digits, exponent = re.fullmatch(r"(-?\d(?:\.\d+)?)e([+-]\d+)", f"{float(value):.16e}").groups()
    for places in range(17):
        text = f"{float(value):.{places}e}"
        if float(text) == value:
            digits, exponent = text.split("e")
            break
    fixed = f"{float(value):.{max(0, len(digits.lstrip('-').replace('.', '')) - 1 - int(exponent))}f}"
    scientific = f"{digits}e{int(exponent):+03d}"
    return fixed if len(fixed) <= len(scientific) else scientific


def traces(session):
    """The file traces.csv by what bask.py reads."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerow(session.columns)
    for row in zip(*(session[column] for column in session.columns)):
        out.write(",".join(map(figures, row)) + "\n")
    return out.getvalue()


class Values(unittest.TestCase):
    maxDiff = 2000

    def as_exported(self, file):
        """The session, after all of its columns were compared with the CSV to the last digit."""
        session = bask.open(file)
        out = exported(file)
        with open(os.path.join(out, "traces.csv"), encoding="utf-8", newline="") as text:
            wanted = text.read()
        got = traces(session)
        if got != wanted:
            for ours, theirs in zip(got.splitlines(), wanted.splitlines()):
                self.assertEqual(ours, theirs)
        self.assertEqual(len(got), len(wanted))
        return session, out

    def test_to_the_last_digit_of_the_csv(self):
        for name in ("run", "warm"):
            with self.subTest(name):
                session, _ = self.as_exported(path(name))
                self.assertGreater(len(session.time_s), 15)
                self.assertFalse(np.isnan(session[f"{list(session.objects)[0]} view factor (1)"]).any())
        self.assertIn("camera spread (K)", next(iter(session.objects.values())))

    def test_sessions_of_all_versions(self):
        for statements in (FIRST_VERSION, WITHOUT_LATER, REAL_RIG, (*FIRST_VERSION, *REAL_RIG)):
            with self.subTest(statements[0]):
                session, _ = self.as_exported(altered(*statements))
                is_whole = statements == REAL_RIG
                self.assertEqual(np.isnan(session["bunny view factor without shade (1)"]).all(), not is_whole)
                self.assertEqual("bunny true (degC)" in session.columns, REAL_RIG[0] not in statements)
                self.assertEqual(session.header["version"], 1 if statements[0] == FIRST_VERSION[0] else 2)
        session, _ = self.as_exported(altered("DELETE FROM step", "DELETE FROM overview"))
        self.assertEqual(len(session["bunny measured (degC)"]), 0)
        self.assertIn("0 samples", str(session))

    def test_what_the_traces_leave_out(self):
        session, out = self.as_exported(path("run"))
        with open(os.path.join(out, "motion.csv"), encoding="utf-8") as text:
            motion = list(csv.DictReader(text))
        with open(os.path.join(out, "object_state.csv"), encoding="utf-8") as text:
            states = [row for row in csv.DictReader(text) if row["object"] == "bunny"]
        for column, key in (("vx (m/s)", "vx_m_s"), ("wz (rad/s)", "wz_rad_s"),
                            ("smallest singular value (1)", "smallest_singular_value")):
            self.assertEqual(list(map(figures, session[column])), [row[key] for row in motion])
        limited = [int(row["limited"]) for row in motion]
        self.assertEqual(limited[4], 4100)
        self.assertEqual(session["limited (1)"].tolist(), limited[:4] + [0] + limited[5:])
        self.assertEqual(list(map(figures, session.objects["bunny"]["lambda1 (K/s)"])),
                         [row["lambda1_K_s"] for row in states])
        self.assertEqual(list(map(figures, session["bunny lambda2 (1/(K^3 s))"])),
                         [row["lambda2_1_K3s"] for row in states])
        self.assertEqual(len(session.other_columns), 8 + 2 * 3)

    def test_objects_share_the_columns(self):
        session = bask.open(path("run"))
        self.assertEqual(list(session.objects), ["circle", "bunny", "hand"])
        for name, columns in session.objects.items():
            for column, values in columns.items():
                self.assertIs(values, session[f"{name} {column}"])
        valid = session.objects["bunny"]["reading valid (1)"]
        self.assertEqual(valid.dtype, bool)
        self.assertTrue(np.isnan(session["bunny measured (degC)"][~valid]).all())
        self.assertEqual(list(session), session.columns)
        self.assertEqual(list(dict.fromkeys(session)), session.columns)
        self.assertIs(session.time_s, session["time (s)"])
        with self.assertRaisesRegex(KeyError, "no column 'bunny'; session.columns"):
            session["bunny"]

    def test_pages_and_sqlite_give_the_same(self):
        pages, looks = bask._from_pages, []
        fast = bask.open(path("run"))
        with mock.patch.object(bask, "_from_pages", lambda *of: looks.append(pages(*of))):
            slow = bask.open(path("run"))
        self.assertIsNotNone(looks[0], "the pages are not read")
        for column in fast.columns + fast.other_columns:
            np.testing.assert_array_equal(fast[column].view(np.uint8), slow[column].view(np.uint8), column)
        alter(altered(), "ALTER TABLE step ADD COLUMN more REAL")
        with mock.patch.object(bask, "_from_pages", lambda *of: looks.append(pages(*of)) or looks[-1]):
            session = bask.open(path("altered"))
        self.assertIsNone(looks[1], "rows of another width are read")
        np.testing.assert_array_equal(session["x (m)"], fast["x (m)"])

    def test_events_and_the_rest(self):
        session, out = self.as_exported(path("run"))
        for table, found in (("event", session.events), ("command", session.commands), ("note", session.notes)):
            with open(os.path.join(out, f"{table}.csv"), encoding="utf-8", newline="") as text:
                rows = list(csv.DictReader(text))
            self.assertEqual(len(rows), len(found))
            for row, one in zip(rows, found):
                for key, value in one._asdict().items():
                    if key == "args":
                        value = bask.json.dumps(value, separators=(",", ":"), ensure_ascii=False)
                    self.assertEqual(row[key].lstrip("'"), figures(value) if key == "time_s" else value)
        self.assertEqual(session.notes, [bask.Note(1.5, 'a draught, "door"', "A. Hu"), bask.Note(2.5, "灯")])
        self.assertIn("EventStarted", [event.code for event in session.events])
        self.assertEqual(session.experiment["title"], "Three objects on a triangle")
        header = session.header
        self.assertEqual((header["version"], header["seed"], header["simulated"], header["tags"], header["title"]),
                         (2, 7, True, ["first", "wärme"], "Three objects on a triangle"))
        self.assertRegex(header["created"], r"^20\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertRegex(header["finished"], r"^20\d\d-")
        self.assertRegex(header["software"], r"^Bask \d")
        self.assertIn(header["outcome"], ("settled", "not-settled"))

    @unittest.skipUnless(HAS_H5PY, "h5py")
    def test_nexus_as_the_session(self):
        for name in ("run", "warm"):
            session = bask.open(path(name))
            nexus = bask.open(os.path.join(exported(path(name), "nexus"), f"{name}.nxs"))
            self.assertEqual(nexus.columns, session.columns)
            self.assertEqual(nexus.other_columns, session.other_columns)
            for column in session.columns + session.other_columns:
                if column.startswith("theta"):  # by way of a quaternion
                    np.testing.assert_allclose(nexus[column], session[column], rtol=0, atol=1e-14)
                else:
                    np.testing.assert_array_equal(nexus[column], session[column], column)
                self.assertEqual(nexus[column].dtype, session[column].dtype)
            self.assertEqual([event[:3] for event in nexus.events], [event[:3] for event in session.events])
            self.assertEqual(nexus.events[0].args, None)
            self.assertEqual(nexus.commands, session.commands)
            self.assertEqual(nexus.notes, session.notes)
            self.assertEqual(nexus.experiment, session.experiment)
            self.assertEqual(nexus.header, {**session.header, "version": None, "tags": None})
            self.assertEqual(str(nexus).splitlines()[1:], str(session).splitlines()[1:])

    @unittest.skipUnless(HAS_H5PY, "h5py")
    def test_nexus_of_earlier_places(self):
        import h5py
        file = shutil.copy(os.path.join(exported(path("run"), "nexus"), "run.nxs"), path("earlier.nxs"))
        now = bask.open(file)
        with h5py.File(file, "a") as root:
            entry = root["entry"]
            entry["program_name"].attrs["recorded_by"] = entry["run/recorded_by"][()]
            for new, old in bask._EARLIER.items():
                if new.startswith("properties/"):
                    for note in (name for name in entry if name.startswith("note_")):
                        entry[note].move(new, old)
                elif new.endswith("/value"):
                    entry.move(os.path.dirname(os.path.dirname(new)), os.path.dirname(os.path.dirname(old)))
                else:
                    entry.move(new, old)
            del entry["run"]
        earlier = bask.open(file)
        self.assertEqual(earlier.header, now.header)
        self.assertEqual(earlier.notes, now.notes)
        np.testing.assert_array_equal(earlier["source (degC)"], now["source (degC)"])

    @unittest.skipUnless(HAS_PANDAS, "pandas")
    def test_pandas(self):
        import pandas
        session, out = self.as_exported(path("run"))
        frame = session.to_pandas()
        read = pandas.read_csv(os.path.join(out, "traces.csv"), index_col=0, float_precision="round_trip")
        read.index = read.index.astype(float)
        pandas.testing.assert_frame_equal(frame, read.astype(frame.dtypes), check_exact=True)

    @unittest.skipUnless(HAS_XARRAY, "xarray")
    def test_xarray(self):
        session = bask.open(path("run"))
        data = session.to_xarray()
        self.assertEqual(dict(data.sizes), {"time": len(session.time_s), "object": 3})
        self.assertEqual(data["measured"].attrs["units"], "degC")
        self.assertEqual(data["lambda2"].attrs["units"], "1/(K^3 s)")
        np.testing.assert_array_equal(data["measured"].sel(object="hand"), session["hand measured (degC)"])
        np.testing.assert_array_equal(data["theta_x"], session["theta_x (rad)"])
        np.testing.assert_array_equal(data["time"], session.time_s)
        self.assertEqual(data.attrs["title"], "Three objects on a triangle")

    def test_says_what_is_not_installed(self):
        session = bask.open(path("run"))
        for module, use in (("pandas", session.to_pandas), ("xarray", session.to_xarray),
                            ("h5py", lambda: bask._read_nexus("any"))):
            with mock.patch.dict(sys.modules, {module: None}):
                with self.assertRaisesRegex(ImportError, f"apt install python3-{module}"):
                    use()


class Opening(unittest.TestCase):
    def test_while_it_is_recorded_and_after_the_recorder_was_killed(self):
        own = os.path.join(folder, "live")
        os.mkdir(own)
        file = os.path.join(own, "live.bask")
        recorder = subprocess.Popen([BASK, "run", os.path.join(ROOT, "resources/examples/two-circles.json"),
                                     "--duration", "1000000", "-o", file], stdout=subprocess.DEVNULL,
                                    stderr=subprocess.DEVNULL)
        try:
            counts = [0]
            until = time.monotonic() + 60
            while len(counts) < 5 and time.monotonic() < until:
                time.sleep(0.3)
                if os.path.exists(f"{file}-wal"):
                    session = bask.open(file)
                    if len(session.time_s) > counts[-1]:
                        counts.append(len(session.time_s))
            self.assertEqual(len(counts), 5, "nothing comes while it is recorded")
            self.assertEqual(session.header["outcome"], None)
            self.assertIn("still being recorded", str(session))
            self.assertIsNone(recorder.poll())
        finally:
            recorder.send_signal(signal.SIGKILL)
            recorder.wait()
        self.assertTrue(os.path.exists(f"{file}-wal"))
        Values.as_exported(self, file)
        # A log has to be replayed, which a folder that cannot be written does not allow; see below.
        for left in os.listdir(own):
            if left.endswith("-shm"):
                os.remove(os.path.join(own, left))
        with read_only(own) as is_so:
            if is_so:
                with self.assertRaisesRegex(bask.FileError, "live.bask: its log, .*Copy both files"):
                    bask.open(file)

    def test_changes_nothing_and_works_in_a_folder_that_cannot_be_written(self):
        own = os.path.join(folder, "own 100%?#&'ü")
        os.mkdir(own)
        file = shutil.copy(path("run"), os.path.join(own, "a run; mode=rw.bask"))
        os.symlink(file, path("link"))
        before = os.stat(file)
        with read_only(own):
            for where in (file, file.encode(), bask.pathlib.Path(file), path("link")):
                self.assertEqual(bask.Session(where).events, bask.open(path("run")).events)
        self.assertEqual(os.listdir(own), [os.path.basename(file)])
        self.assertEqual((os.stat(file).st_mtime_ns, os.stat(file).st_size), (before.st_mtime_ns, before.st_size))

    def test_command_line(self):
        done = subprocess.run([sys.executable, "-B", MODULE, path("run")], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.stdout, done.stderr, done.returncode), (f"{bask.open(path('run'))}\n", "", 0))
        self.assertRegex(done.stdout, r"bunny: at the end measured \d+\.\d\d degC, target 40.00 degC")
        for wrong in (["none.bask"], [BASK], [], ["a", "b"]):
            done = subprocess.run([sys.executable, "-B", MODULE, *wrong], capture_output=True, text=True, timeout=60)
            self.assertEqual(done.stdout, "")
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_no_control_characters_reach_the_terminal(self):
        file = altered(r"UPDATE experiment SET json = replace(json, 'Three objects', '\u001b[2JThree objects')")
        self.assertIn("\x1b", bask.open(file).header["title"])
        self.assertNotIn("\x1b", str(bask.open(file)))

    @staticmethod
    def seconds_of_a_select(file):
        """What a tenth of the samples takes, times ten."""
        busy = time.process_time()
        with contextlib.closing(sqlite3.connect(file)) as con:
            rows = con.execute("SELECT * FROM step WHERE number % 10 = 0")
            np.fromiter((value for row in rows for value in row), float)
        return 10 * (time.process_time() - busy)

    def test_a_day_in_less_than_three_seconds(self):
        file = altered(name="day")
        with contextlib.closing(sqlite3.connect(file)) as con:
            columns = [row[1] for row in con.execute("PRAGMA table_info(step)")][2:]
            con.execute("PRAGMA synchronous = OFF")
            count, = con.execute("SELECT count(*) FROM step").fetchone()
            while count < SAMPLES_OF_A_DAY:  # twice as many each time
                con.execute(f"INSERT INTO step SELECT number + {count}, 0.0, {', '.join(columns)} FROM step"
                            f" WHERE number <= {SAMPLES_OF_A_DAY - count}")
                count, = con.execute("SELECT count(*) FROM step").fetchone()
            con.execute("UPDATE step SET time_s = (number - 1) * 0.1")
            con.commit()
        tries = []
        while not tries or (min(tries) > 3.0 and len(tries) < 4):  # others may keep this machine from it
            began, busy = time.monotonic(), time.process_time()
            session = bask.open(file)
            for column in session.columns:
                self.assertEqual(len(session[column]), SAMPLES_OF_A_DAY)
            tries.append(time.process_time() - busy)
            print(f"a day, {os.path.getsize(file) / 1e6:.0f} MB: {time.monotonic() - began:.2f} s,"
                  f" {tries[-1]:.2f} s busy")
        select = min(self.seconds_of_a_select(file) for _ in tries)
        print(f"all of it by SELECT: {select:.2f} s busy")
        os.remove(file)
        np.testing.assert_array_equal(session.time_s, np.arange(SAMPLES_OF_A_DAY) * 0.1)
        short = bask.open(path("run"))
        for column in short.columns[1:]:
            np.testing.assert_array_equal(session[column][:1000], np.resize(short[column], 1000), column)
            np.testing.assert_array_equal(session[column], np.resize(short[column], SAMPLES_OF_A_DAY), column)
        # Promised are 3 s. A slower machine is allowed what that is of the SELECT that this replaces: 7.5 s where both
        # were measured.
        self.assertLess(min(tries), max(3.0, 0.4 * select))


@contextlib.contextmanager
def read_only(place):
    """Whether the folder cannot be written meanwhile."""
    os.chmod(place, 0o555)
    is_root = os.geteuid() == 0
    if is_root:
        os.seteuid(65534)
    try:
        yield not os.access(place, os.W_OK, effective_ids=True)
    finally:
        if is_root:
            os.seteuid(0)
        os.chmod(place, 0o755)


class Errors(unittest.TestCase):
    def refused(self, file, words):
        with self.assertRaises(bask.FileError) as caught:
            bask.open(file)
        self.assertIsInstance(caught.exception, ValueError)
        self.assertTrue(str(caught.exception).startswith(f"{file}: "), caught.exception)
        self.assertRegex(str(caught.exception), words)
        self.assertIsNone(caught.exception.__cause__)
        self.assertTrue(caught.exception.__suppress_context__ or caught.exception.__context__ is None)

    def written(self, content, name="wrong.bask"):
        with open(path(name), "wb") as file:
            file.write(content)
        return path(name)

    def content(self, file=None):
        with open(file or path("run"), "rb") as opened:
            return opened.read()

    def test_no_such_file(self):
        with self.assertRaisesRegex(FileNotFoundError, "none.bask"):
            bask.open(path("none"))
        with self.assertRaises(IsADirectoryError):
            bask.open(folder)

    def test_other_files(self):
        self.refused(self.written(b""), r"the file is empty\. Nothing was recorded into it")
        foreign = r"neither a session file of Bask \(\*\.bask\) nor a NeXus file .*Open one of these"
        for content in (b"hello", b"x" * 100_000, self.content()[:10]):
            self.refused(self.written(content), foreign)
        self.refused(altered("PRAGMA application_id = 7"), foreign)

    def test_a_newer_version(self):
        self.refused(altered("PRAGMA user_version = 9"), r"version 9, .* up to 2\. Take the bask\.py of the Bask that")

    def test_cut_short(self):
        whole = self.content()
        for size in (16, 60, 100, 4096, 10_000, len(whole) // 2, len(whole) - 1):
            with self.subTest(size):
                self.refused(self.written(whole[:size]), r"the file is damaged \(.+\)\. Take another copy")

    def test_tables_that_do_not_fit(self):
        damaged = r"the file is damaged \(.+\)\. Take another copy of it; .*\.recover"
        for statement in ("DROP TABLE step", "DROP TABLE meta", "DROP TABLE event", "DELETE FROM step WHERE number = 7",
                          "UPDATE step SET number = 1000 WHERE number = 50",
                          "UPDATE step SET time_s = 0 WHERE number = 50",
                          "ALTER TABLE step RENAME COLUMN view_factor_1 TO other", "UPDATE experiment SET json = '{'",
                          "UPDATE experiment SET json = '[]'", "DELETE FROM experiment",
                          "DELETE FROM meta WHERE key = 'simulated'", "UPDATE step SET x_m = 'far' WHERE number = 7",
                          "ALTER TABLE note ADD COLUMN long TEXT AS (hex(zeroblob(9)))"):
            with self.subTest(statement):
                self.refused(altered(statement), damaged)
        endless = "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS time_s, 'x' AS text FROM n"
        self.refused(altered("DROP TABLE note", f"CREATE VIEW note AS {endless}"), damaged)
        for statement in ("DROP TABLE pose", "DROP TABLE truth", "DELETE FROM pose WHERE rowid = 7",
                          "DELETE FROM sample WHERE rowid = 7", "DELETE FROM motion WHERE rowid = 50",
                          "UPDATE sample SET object = 'x' WHERE rowid = 3",
                          "UPDATE source SET time_s = 0.5 WHERE rowid = 3",
                          "ALTER TABLE sample DROP COLUMN view_factor"):
            with self.subTest(statement):
                self.refused(altered(*FIRST_VERSION, statement), damaged)

    def test_what_no_run_records(self):
        """Catches: values that the program refuses, read as if they were."""
        of_step = ("measured_K_1 = -400", "source_K = -1", "measured_K_2 = 9e999", "x_m = NULL", "x_m = 9e999",
                   "qw = 0, qx = 0, qy = 0, qz = 0", "qw = NULL", "time_s = 0.0", "measured_K_1 = 'hot'", "source_qw = 1",
                   "source_x_m = 0, source_y_m = 0, source_z_m = 0, source_qw = 0, source_qx = 0, source_qy = 0, source_qz = 2")
        later = {"time_s = 0.0": ""}
        cases = [(f"UPDATE step SET {each}{later.get(each, ' WHERE number = 40')}",) for each in of_step]
        cases += [("UPDATE object SET name = 'other' WHERE number = 2",), ("DELETE FROM object WHERE number = 3",),
                  ("UPDATE event SET time_s = 'now' WHERE rowid = 2",), ("UPDATE note SET time_s = 9e999",),
                  ("UPDATE command SET time_s = x'00' WHERE rowid = 2",)]
        cases += [(*FIRST_VERSION, statement) for statement in (
            "UPDATE sample SET measured_K = -400 WHERE rowid = 40", "UPDATE sample SET estimated_K = 9e999 WHERE rowid = 40",
            "UPDATE sample SET measured_K = 'hot' WHERE rowid = 40", "UPDATE source SET temperature_K = -1 WHERE rowid = 40",
            "UPDATE pose SET qw = 0, qx = 0, qy = 0, qz = 0 WHERE rowid = 40", "UPDATE pose SET x_m = NULL WHERE rowid = 40",
            "UPDATE source_pose SET qx = 2 WHERE rowid = 40")]
        cases.append((*FIRST_VERSION, *(f"UPDATE {table} SET time_s = 0.0" for table in VIEWS)))
        for statements in cases:
            with self.subTest(statements[-1]):
                file = altered(*statements)
                self.refused(file, r"the file is damaged \(.+\)\. Take another copy")
                done = subprocess.run([BASK, "export", file, "--csv", path("no.csv")], capture_output=True, text=True,
                                      check=False)
                self.assertNotEqual(done.returncode, 0, "the program opens it")
                self.assertIn("damaged", done.stderr)

    def test_random_damage(self):
        files = [path("run"), altered(*FIRST_VERSION, name="first")]
        if HAS_H5PY:
            files.append(os.path.join(exported(path("run"), "nexus"), "run.nxs"))
        dice = random.Random(11)
        for file in files:
            whole, refused = self.content(file), 0
            for _ in range(60):
                content = bytearray(whole)
                at = dice.randrange(len(content))
                length = min(1 + dice.randrange(3000), len(content) - at)
                content[at:at + length] = dice.randbytes(length)
                try:
                    bask.open(self.written(content))
                except bask.FileError:
                    refused += 1
            print(f"{os.path.basename(file)}: {refused} of 60 damaged files are refused")
            self.assertGreater(refused, 10)

    @unittest.skipUnless(HAS_H5PY, "h5py")
    def test_other_hdf5_files(self):
        import h5py
        with h5py.File(path("other.h5"), "w") as file:
            file["entry"] = 1
        self.refused(path("other.h5"), "neither a session file of Bask")
        with h5py.File(path("other.h5"), "w") as file:
            file.attrs["creator"] = "Bask 0.2.0"
        self.refused(path("other.h5"), "the file is damaged .* is missing")
        whole = self.content(os.path.join(exported(path("run"), "nexus"), "run.nxs"))
        for size in (8, 100, len(whole) // 2):
            self.refused(self.written(whole[:size], "cut.nxs"), "the file is damaged")

    def test_locked(self):
        with mock.patch.object(bask.sqlite3, "connect", side_effect=sqlite3.OperationalError("database is locked")):
            self.refused(path("run"), "another program keeps the file locked. Try again")


@unittest.skipUnless(HAS_H5PY, "h5py is not installed")
class Fields(unittest.TestCase):
    AXES = "x=-0.1:0.1:0.05,z=0.05:0.2:0.05,theta_x=0:0.4:0.2"

    def field(self, *more):
        place = os.path.join(tempfile.mkdtemp(dir=folder), "field.h5")
        done = subprocess.run([BASK, "field", os.path.join(ROOT, "resources/examples/two-circles.json"), "--object", "left", "--shade", "none", "--axes", self.AXES,
                               "--hold", "y=0.01", "-o", place, *more], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return place

    def test_every_sample_in_its_place(self):
        with bask.open_field(self.field("--gradient")) as field:
            self.assertEqual(list(field.axes), ["x", "z", "theta_x"])
            self.assertEqual(field.values.shape, (3, 4, 5))
            self.assertEqual(field.gradient.shape, (3, 4, 5, 6))
            self.assertEqual(field.held, {"y": 0.01, "theta_y": 0.0, "theta_z": 0.0})
            self.assertEqual((field.units["x"], field.units["theta_x"]), ("m", "rad"))
            # The slope along x between neighbours is that of the gradient halfway.
            F, dF = field.values[0, 3, :], field.gradient[0, 3, :, 0]
            np.testing.assert_allclose(np.diff(F) / 0.05, (dF[1:] + dF[:-1]) / 2, rtol=0.2, atol=0.05)
            if HAS_XARRAY:
                array = field.to_xarray()
                self.assertEqual(array.sel(x=0.1, z=0.2, theta_x=0.4, method="nearest").item(), field.values[2, 3, 4])
        with bask.open_field(self.field()) as field:
            self.assertIsNone(field.gradient)

    def test_other_files(self):
        for bad in (path("run"), self.field() + ".gone"):
            with self.assertRaises((bask.FileError, FileNotFoundError)):
                bask.open_field(bad)


class Words(unittest.TestCase):
    def run_in(self, place, code, *arguments):
        environment = {**os.environ, "PYTHONPATH": os.path.dirname(MODULE), "MPLBACKEND": "Agg",
                       "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run([sys.executable, *code, *arguments], cwd=place, env=environment, capture_output=True,
                              text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def place(self):
        place = tempfile.mkdtemp(dir=folder)
        shutil.copy(path("run"), place)
        shutil.copy(path("run"), os.path.join(place, "other.bask"))
        return place

    def test_the_programs_of_the_page(self):
        with open(os.path.join(ROOT, "docs/python.md"), encoding="utf-8") as page:
            text = page.read()
        parts = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreater(len(parts), 2)
        for part in parts:
            if (HAS_PANDAS or "to_pandas" not in part) and (HAS_XARRAY or "to_xarray" not in part):
                self.run_in(self.place(), ["-c", part])
        session = bask.open(path("run"))
        names = re.findall(r"^\| `session\.(\w+)", text, re.M)
        self.assertEqual([name for name in vars(session) if not name.startswith("_") and name not in names], [])
        for name in names:
            getattr(session, name)
        header = re.findall(r"`(\w+)`", re.search(r"^\| `session\.header` \|(.*)\|$", text, re.M).group(1))
        self.assertEqual([key for key in session.header if key not in header], [])
        for column in re.findall(r"`\w+ [\w ]*\([^`]*\)`", text):
            self.assertIn(column.strip("`"), [*session.columns, *session.other_columns, *session.objects["bunny"]])

    def test_the_tutorial(self):
        tutorial = os.path.join(ROOT, "resources/python/tutorial.py")
        said = self.run_in(self.place(), [tutorial], "run.bask", "other.bask")
        for word in ("bunny", "settled", "J/m2", "view factor", "Started"):
            self.assertIn(word, said)
        self.run_in(self.place(), [tutorial], "run.bask")


unittest.main(verbosity=2)
