"""Is what the package installs whole, valid and of one mind with the program?

Usage: package_test.py CMAKE BUILD_FOLDER BASK. Installs the build into a new folder; validators that are not there are skipped, in words.
"""

import configparser
import fnmatch
import gzip
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

CMAKE, BUILD, BASK = sys.argv[1:4]
ROOT = Path(__file__).resolve().parents[2]
MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"


def output(*command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    return done.returncode, done.stdout + done.stderr


def needs(tool):
    return unittest.skipUnless(shutil.which(tool), f"{tool} is not installed")


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        code, said = output(CMAKE, "--install", BUILD, "--prefix", folder.name)
        assert code == 0, said
        cls.installed = Path(folder.name)
        cls.share = cls.installed / "share"
        cls.desktop_file = cls.share / "applications/bask.desktop"
        desktop = configparser.ConfigParser(interpolation=None)
        desktop.optionxform = str
        desktop.read(cls.desktop_file, encoding="utf-8")
        cls.desktop = desktop["Desktop Entry"]
        cls.mime_file = cls.share / "mime/packages/bask.xml"
        cls.mime = ElementTree.parse(cls.mime_file).getroot()
        cls.metainfo_file = cls.share / "metainfo/org.bask.Bask.metainfo.xml"
        cls.metainfo = ElementTree.parse(cls.metainfo_file).getroot()
        with gzip.open(cls.share / "man/man1/bask.1.gz", "rt", encoding="utf-8") as page:
            cls.man = page.read().replace("\\-", "-")

    def test_all_of_it_is_there_and_nothing_else(self):
        found = sorted(str(path.relative_to(self.installed)) for path in self.installed.rglob("*") if path.is_file())
        docs = [f"share/doc/bask/{path.relative_to(ROOT / 'docs')}" for path in (ROOT / "docs").rglob("*.md")]
        docs += [f"share/doc/bask/program_drivers/{path.name}" for path in (ROOT / "resources/program_drivers").glob("*.*")]
        docs += [f"share/bask/python/{path.name}" for path in (ROOT / "resources/python").glob("*.py")]
        docs += [f"share/doc/bask/clusters/{path.name}" for path in (ROOT / "resources/clusters").glob("*")]
        examples = ROOT / "resources/examples"
        docs += [f"share/doc/bask/examples/{path.relative_to(examples)}" for path in examples.rglob("*") if path.is_file()]
        self.assertEqual(found, sorted(docs + [
            "bin/bask", "libexec/bask/bask-draw", "libexec/bask/bask-guard", "libexec/bask/bask-mqtt.so", "libexec/bask/bask-painting.so",
            "libexec/bask/bask-pictures.so", "libexec/bask/bask-sleep.so",
            "libexec/bask/bask-video.so", "libexec/bask/bask-window", "lib/udev/rules.d/60-bask.rules", "share/applications/bask.desktop",
            "share/doc/bask/changelog.gz", "share/doc/bask/copyright", "share/icons/hicolor/scalable/apps/bask.svg",
            "share/icons/hicolor/scalable/mimetypes/application-x-bask-experiment.svg",
            "share/icons/hicolor/scalable/mimetypes/application-x-bask-recipe.svg",
            "share/icons/hicolor/scalable/mimetypes/application-x-bask-rig.svg",
            "share/icons/hicolor/scalable/mimetypes/application-x-bask-session.svg", "share/man/man1/bask.1.gz",
            "share/metainfo/org.bask.Bask.metainfo.xml", "share/mime/packages/bask.xml"]))

    @needs("desktop-file-validate")
    def test_the_desktop_file_is_valid(self):
        self.assertEqual(output("desktop-file-validate", self.desktop_file), (0, ""))

    @needs("appstreamcli")
    def test_the_metainfo_is_valid(self):
        code, said = output("appstreamcli", "validate", "--no-net", self.metainfo_file)
        self.assertEqual(code, 0, said)

    @needs("update-mime-database")
    def test_the_mime_types_are_valid(self):
        code, said = output("update-mime-database", self.share / "mime", env={"XDG_DATA_DIRS": str(self.share)})
        self.assertEqual((code, said), (0, ""))
        self.assertTrue((self.share / "mime/application/x-bask-session.xml").is_file())

    # Catches: every .json of the system opened by Bask, or none of its own.
    @needs("update-mime-database")
    @needs("gio")
    def test_a_json_file_is_what_it_says(self):
        system = Path("/usr/share/mime/packages/freedesktop.org.xml")
        if not system.exists():
            self.skipTest("shared-mime-info is not installed")
        with tempfile.TemporaryDirectory() as folder:
            data = Path(folder)
            (data / "mime/packages").mkdir(parents=True)
            for source in (system, self.mime_file):
                shutil.copy(source, data / "mime/packages")
            seen = {"XDG_DATA_DIRS": folder, "XDG_DATA_HOME": str(data / "home"), "PATH": "/usr/bin"}
            subprocess.run(["update-mime-database", data / "mime"], env=seen, check=True, capture_output=True)
            for text, wanted in [((ROOT / "resources/examples/two-circles.json").read_text(encoding="utf-8"),
                                  "application/x-bask-experiment+json"),
                                 ('{"format":"bask-experiment"}', "application/x-bask-experiment+json"),
                                 ('{\n  "format": "bask-rig",', "application/x-bask-rig+json"),
                                 ('{"format": "bask-recipe", "version": 1}', "application/x-bask-recipe+json"),
                                 ('{"format": "geometry"}', "application/json"), ("[]", "application/json")]:
                (data / "some.json").write_text(text, encoding="utf-8")
                said = output("gio", "info", "-a", "standard::content-type", data / "some.json", env=seen)[1]
                self.assertIn(f"standard::content-type: {wanted}\n", said)

    def test_the_desktop_file_starts_what_is_installed(self):
        self.assertTrue((self.installed / "bin" / self.desktop["TryExec"]).is_file())
        self.assertEqual(self.desktop["Exec"], self.desktop["TryExec"] + " %f", "one file: the program refuses a second")
        icons = self.share / "icons/hicolor/scalable"
        self.assertTrue((icons / "apps" / (self.desktop["Icon"] + ".svg")).is_file())

    def test_types_agree_and_have_icons(self):
        types = {each.get("type"): each for each in self.mime}
        self.assertEqual(sorted(types), sorted(self.desktop["MimeType"].strip(";").split(";")))
        self.assertEqual(sorted(types), sorted(each.text for each in self.metainfo.iter("mediatype")))
        for each in types.values():
            name = each.find(MIME + "icon").get("name")
            self.assertTrue((self.share / f"icons/hicolor/scalable/mimetypes/{name}.svg").is_file(), name)
        self.assertEqual(self.metainfo.findtext("launchable"), self.desktop_file.name)

    # Catches: a command that came or went and the man page that nobody told.
    def test_the_man_page_has_the_commands_of_help(self):
        code, text = output(BASK, "--help")
        self.assertEqual(code, 0, text)
        commands = re.findall(r"^  ([a-z][a-z-]*) ", text, re.MULTILINE)
        self.assertGreater(len(commands), 10)
        section = self.man.split(".SH SUBCOMMANDS")[1].split(".SH")[0]
        self.assertEqual(sorted(re.findall(r"^\.TP\n\.B (\S+)$", section, re.MULTILINE)), sorted(commands))

    @needs("groff")
    def test_the_man_page_is_set_without_a_warning(self):
        self.assertEqual(output("groff", "-man", "-Tutf8", "-ww", "-z", input=self.man), (0, ""))

    def test_one_version(self):
        version = re.search(r"BASK_VERSION \"([0-9.]+)\"", (ROOT / "engine/base/version.h").read_text(encoding="utf-8"))[1]
        self.assertIn(f'"Bask {version}"', self.man.splitlines()[0])
        self.assertEqual(self.metainfo.find("releases/release").get("version"), version)
        with gzip.open(self.share / "doc/bask/changelog.gz", "rt", encoding="utf-8") as changelog:
            self.assertTrue(changelog.readline().startswith(f"bask ({version})"))

    # Catches: an outline of somebody else that goes out under Bask's own licence.
    def test_every_outline_has_its_licence(self):
        text = (self.share / "doc/bask/copyright").read_text(encoding="utf-8")
        patterns = [word for line in re.findall(r"^Files: (.*)$", text, re.MULTILINE) for word in line.split() if word != "*"]
        for path in (ROOT / "resources/examples/contours").iterdir():
            name = str(path.relative_to(ROOT))
            if path.name != "README.md":
                self.assertTrue(any(fnmatch.fnmatch(name, pattern) for pattern in patterns), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
