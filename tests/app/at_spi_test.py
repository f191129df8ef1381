#!/usr/bin/python3
"""Bask as a screen reader has it: another program that asks over AT-SPI, the protocol of Orca. A run is made by what is said alone.

at_spi_test.py PATH_OF_BASK: on an X server; takes a D-Bus session of its own. Skipped (77) where python3-pyatspi or the bus of
at-spi2-core is missing.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

if "BASK_AT_SPI_TEST" not in os.environ:  # another session's desktop is none of this test's
    if shutil.which("dbus-run-session") is None:
        print("dbus-run-session is not installed")
        sys.exit(77)
    os.environ["BASK_AT_SPI_TEST"] = "inside"
    os.execvp("dbus-run-session", ["dbus-run-session", "--", sys.executable, "-B", *sys.argv])
try:
    import pyatspi
    from gi.repository import GLib
except ImportError:
    print("python3-pyatspi is not installed")
    sys.exit(77)
try:
    pyatspi.Registry.getDesktop(0).childCount
except (GLib.Error, RuntimeError):
    print("the bus of at-spi2-core is not there")
    sys.exit(77)

PROGRAM = sys.argv.pop(1)
PAGES = ["Rig", "Objects", "Calibrate", "Targets", "Run", "Review"]
OBJECTS = ["circle", "bunny", "hand"]
PATIENCE_S = 120


def wait_for(found, what):
    """Returns what found() returns once it is true; while the window changes, a node may go before it is asked."""
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        try:
            result = found()
        except GLib.Error:
            result = None
        if result:
            return result
        time.sleep(0.1)
    raise AssertionError(f"not within {PATIENCE_S} s: {what}")


def has(node, *states):
    """Whether a node has all these states; one that has gone has none."""
    try:
        return all(node.getState().contains(state) for state in states)
    except GLib.Error:
        return False


def children(node):
    """Those that are there still."""
    try:
        return [child for child in node if child is not None]
    except GLib.Error:
        return []


def shown(node):
    """A node that is shown and all that is shown within it, in the order of the tree."""
    if not has(node, pyatspi.STATE_SHOWING):
        return
    yield node
    for child in children(node):
        yield from shown(child)


def said(node):
    """What a screen reader says of a node: name, description, and the label that belongs to it."""
    labels = [
        relation.getTarget(i).name
        for relation in node.getRelationSet()
        if relation.getRelationType() == pyatspi.RELATION_LABELLED_BY
        for i in range(relation.getNTargets())
    ]
    return " ".join([*labels, node.name, node.description]).replace("\N{NO-BREAK SPACE}", " ").strip()


class AtSpi(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        home = pathlib.Path(folder.name)
        (home / "bask.ini").write_text("[General]\ncoachAnswered=true\nlanguage=en\n")
        own = {"HOME": str(home), "XDG_DATA_HOME": str(home / "data"), "BASK_SETTINGS_DIR": str(home)}
        cls.bask = subprocess.Popen([PROGRAM], env={**os.environ, **own, "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1"})
        cls.addClassCleanup(cls.end)
        desktop = pyatspi.Registry.getDesktop(0)
        # Of its own process: `bask` becomes the window's program and keeps its number.
        is_ours = lambda p: p.name == "bask" and p.get_process_id() == cls.bask.pid and p.childCount > 0
        programs = wait_for(lambda: [p for p in children(desktop) if is_ours(p)], "Bask")
        cls.window = programs[0].getChildAtIndex(0)
        cls.known = {}

    @classmethod
    def end(cls):
        cls.bask.terminate()
        try:
            cls.bask.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            cls.bask.kill()
            cls.bask.wait()
            raise

    def node(self, role, beginning):
        """The shown node of a role whose name begins so; it is kept, since a walk through the window is slow."""
        key = role, beginning
        if key not in self.known or not has(self.known[key], pyatspi.STATE_SHOWING):
            roles = [role, pyatspi.ROLE_PANEL] if role == pyatspi.ROLE_FRAME else [role]  # a frame is a panel in Qt 6.8
            fits = lambda n: n.getRole() in roles and n.name.startswith(beginning)
            self.known[key] = wait_for(lambda: next(filter(fits, shown(self.window)), None), f"{beginning} is shown")
        return self.known[key]

    def press(self, role, name):
        button = self.node(role, name)
        wait_for(lambda: has(button, pyatspi.STATE_SENSITIVE), f"{name} can be pressed")
        button.queryAction().doAction(0)

    def state(self):
        return said(self.node(pyatspi.ROLE_PUSH_BUTTON, "State of the run"))

    def show(self, page):
        self.press(pyatspi.ROLE_CHECK_BOX, page)
        wait_for(lambda: has(self.node(pyatspi.ROLE_CHECK_BOX, page), pyatspi.STATE_CHECKED), page)

    def temperature(self, name):
        return float(said(self.node(pyatspi.ROLE_LABEL, f"Measured temperature of {name}")).split(", ")[1].split(" ")[0])

    def test_1_every_stop_of_every_page_is_named(self):
        """Catches: what the keyboard reaches and nobody can tell, as a choice that says only what is chosen."""
        looked = 0
        for page in PAGES:
            self.show(page)
            for node in shown(self.window):
                if not has(node, pyatspi.STATE_FOCUSABLE, pyatspi.STATE_SENSITIVE):
                    continue
                if node.getRole() == pyatspi.ROLE_FILLER and node.childCount > 0 and not node.name:
                    continue  # it only scrolls
                looked += 1
                words = said(node)
                if node.getRole() == pyatspi.ROLE_COMBO_BOX:  # its name is what is chosen
                    words = words.replace(node.name.replace("\N{NO-BREAK SPACE}", " "), "", 1)
                with self.subTest(page=page, role=node.getRoleName(), name=node.name, within=node.parent.name):
                    self.assertTrue(words.strip())
        self.assertGreater(looked, 100)

    def test_2_tiles_say_their_numbers(self):
        """Catches: a tile whose name is all that is said of it."""
        self.show("Run")
        self.node(pyatspi.ROLE_FRAME, "SIMULATED")
        for name in OBJECTS:
            wait_for(lambda: "°C" in said(self.node(pyatspi.ROLE_FRAME, f"Object {name}")), f"a temperature of {name}")
            tile = self.node(pyatspi.ROLE_FRAME, f"Object {name}")
            labels = [said(n) for n in shown(tile) if n.getRole() == pyatspi.ROLE_LABEL]
            for value in ("Target, 40.0 °C", "Error, ", "Rate, "):
                self.assertTrue(any(label.startswith(value) for label in labels), labels)
        self.assertIn("200.0 °C", said(self.node(pyatspi.ROLE_FRAME, "Source")))

    def test_3_a_run_by_what_is_said(self):
        """Catches: a state, a temperature or an event that is shown and does not reach another program while a run goes on."""
        self.show("Run")
        wait_for(lambda: "Ready" in self.state(), "the rig is ready")
        self.press(pyatspi.ROLE_PUSH_BUTTON, "Arm")
        wait_for(lambda: "Armed" in self.state(), "armed")
        self.press(pyatspi.ROLE_PUSH_BUTTON, "Start")
        wait_for(lambda: "Running" in self.state(), "running")
        wait_for(lambda: self.temperature("circle") > 26.0, "the circle is warmer")
        self.press(pyatspi.ROLE_PUSH_BUTTON, "STOP")
        wait_for(lambda: "Fault" in self.state(), "a latched stop")
        self.press(pyatspi.ROLE_PAGE_TAB, "Events")
        events = self.node(pyatspi.ROLE_TREE, "Events and notes")
        wait_for(lambda: any("STOP" in said(n) for n in shown(events)), "the event of STOP")

    def test_4_tables_say_their_columns_and_cells(self):
        """Catches: a table whose cells or columns another program can't read."""
        self.show("Review")
        tables = [n for n in shown(self.window) if n.getRole() in (pyatspi.ROLE_TABLE, pyatspi.ROLE_TREE, pyatspi.ROLE_TREE_TABLE)]
        self.assertTrue(tables)
        columns = 0
        for table in tables:
            with self.subTest(table=table.name):
                self.assertTrue(table.name)
                cells = [n for n in shown(table) if n.getRole() == pyatspi.ROLE_TABLE_CELL]
                headers = [n for n in shown(table) if n.getRole() == pyatspi.ROLE_TABLE_COLUMN_HEADER]
                columns += len(headers)
                self.assertTrue(all(said(n) for n in headers))
                self.assertTrue(not cells or any(said(n) for n in cells))
        self.assertGreater(columns, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
