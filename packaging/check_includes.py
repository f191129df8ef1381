#!/usr/bin/env python3
"""Checks how engine/, widgets/ and app/ include the project's headers, and which libraries they include where.

Which folder may include which is held by the build: a target sees the headers of what it links, and no others (CMakeLists.txt, bask_library).

Prints `file:line: rule: what is wrong` for each violation and exits 1 if there is one, 2 if it cannot run.
`--root DIR` checks another tree of the same layout.
"""

import argparse
import re
import sys
from pathlib import Path

SOURCE_SUFFIXES = {".h", ".hpp", ".cpp", ".cc", ".cxx"}
HEADER_SUFFIXES = {".h", ".hpp"}

# Figures of `bask study` and `bask reproduce`: QCustomPlot is at home in widgets/plots; sheets of `bask make-board`, which the
# Calibrate page draws, too; the language of reports. These headers have no widget.
UNDRAWN = {("app", "commands"), ("app", "studies")}
COMMAND_FOLDERS = UNDRAWN | {("app", "drawing")}
DRAWING_HEADERS = {"widgets/common/language.h", "widgets/calibrate/board_sheet.h", "widgets/plots/figure_format.h", "widgets/plots/figure_paths.h", "widgets/plots/figure_png.h", "widgets/plots/figure_surfaces.h"}
# Names of messages, from their tables.
MADE_BY_THE_BUILD = {"engine/base/message_names.inc", "engine/base/condition_names.inc"}

# QtCore, which the engine may use where QT_IN_ENGINE allows it. Everything else of Qt is refused there.
QT_CORE = set("""
QAbstractEventDispatcher QAtomicInt QAtomicInteger QByteArray QChar QCoreApplication QCryptographicHash QDate QDateTime
QDeadlineTimer QDebug QDir QElapsedTimer QEvent QEventLoop QFile QFileDevice QFileInfo QFlags QGlobalStatic QHash
QIODevice QList QLocale QLockFile QMap QMetaObject QMetaType QMutex QMutexLocker QObject QPair QPointer QRegularExpression
QSaveFile QScopeGuard QScopedPointer QSemaphore QSet QSharedPointer QStandardPaths QString QStringBuilder QStringList
QStringView QSysInfo QTemporaryDir QTemporaryFile QTextStream QThread QThreadPool QTime QTimeZone QTimer QUrl QUuid QVariant QVariantList
QVariantMap QVector QWaitCondition QWeakPointer QtGlobal QtNumeric
""".split())
QT_MODULES_IN_ENGINE = {"QtCore"}
# What the SVG reader of engine/shape uses besides.
QT_SVG = set("QStringConverter QXmlStreamReader QXmlStreamWriter".split())
# And the module that paints: QtSvg paints into a paint engine of its own.
QT_PAINTING = set("QBuffer QImage QPaintDevice QPaintEngine QPainter QPainterPath QSvgRenderer".split())
PAINTING_MODULE = "engine/media/painting_module.cpp"

# The links of engine/drivers.
QT_LINKS = set("""
QHostAddress QIODevice QModbusDataUnit QModbusDevice QModbusReply QModbusRequest QModbusResponse QModbusRtuSerialClient QModbusTcpClient
QProcess QSerialPort QSerialPortInfo QTcpSocket QAbstractSocket QDBusConnection QDBusMessage QDBusReply QDBusUnixFileDescriptor
""".split())


def is_link_source(path):
    return path.parts[:2] == ("engine", "drivers") and path.suffix == ".cpp"


# Headers of the SVG reader between its own sources; nobody else includes them.
SVG_INSIDE = {"engine/shape/svg_elements.h", "engine/shape/svg_grammar.h", "engine/shape/svg_survey.h"}


def is_svg_source(path):
    source = path.parts[:2] == ("engine", "shape") and path.name.startswith("svg_") and path.suffix == ".cpp"
    return source or path.as_posix() in SVG_INSIDE


def is_json_inside(path):
    """Headers between the readers and writers of JSON."""
    return path.as_posix() in {"engine/base/json_fields.h", "engine/experiment/json_quantities.h", "engine/base/json_text.h",
                               "engine/experiment/rig_json.h", "engine/experiment/faults_json.h", "engine/experiment/material_json.h", "engine/experiment/parameter_json.h", "engine/experiment/vision_json.h"}


# Shared by exchange's own writers of VTK files; nobody else includes it.
VTK_INSIDE = {"engine/exchange/vtk_inside.h"}
# Hands pictures of OpenCV over to the folders that may use it.
OPENCV_INSIDE = {"engine/media/media.h"}


def qt_in_engine(path):
    """The recordings' sources, runtime's worker, the real rig, shape's SVG reader and what paints are the engine's Qt users."""
    name = path.name
    if is_svg_source(path) or path.as_posix() == PAINTING_MODULE or path.as_posix() == "engine/base/translated.h":  # a macro's name, without Qt
        return True
    if path.parts[:2] in {("engine", "recording"), ("engine", "experiment")}:
        return path.suffix not in HEADER_SUFFIXES
    if path.parts[:2] == ("engine", "recipe"):
        return name == "recipe_file.cpp"
    if path.parts[:2] == ("engine", "drivers"):  # serial ports, sockets
        return path.suffix not in HEADER_SUFFIXES
    if path.parts[:2] == ("engine", "runtime"):
        return name.startswith("engine_worker")
    if path.parts[:2] == ("engine", "rig"):
        return name == "real_rig.cpp"
    return False


OPENCV_FOLDERS = {("engine", "shape"), ("engine", "calibration"), ("engine", "devices"), ("engine", "media"), ("engine", "simulation"),
                  ("engine", "thermography")}
VTK_FOLDERS = {("widgets", "scene"), ("engine", "exchange")}
QCUSTOMPLOT_FOLDERS = {("widgets", "plots")}
SYSTEM_HEADER = re.compile(r"(unistd|dirent|netdb|elf|link|dlfcn|fcntl|signal|pthread|immintrin|sched|errno|termios|poll|spawn|syslog)\.h|(sys|netinet|asm)/[a-z_]+\.h")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
QT_NAME = re.compile(r"\b(?!QT_TRANSLATE_NOOP\b)Q(?:t(?=::)|[A-Z]\w*)")  # that one macro is of engine/base/translated.h
ENGINE_HEADER_TYPES = [
    (re.compile(r"\bcv::"), "an OpenCV type"),
    (re.compile(r"\bceres::"), "a Ceres type"),
    (re.compile(r"\bvtk[A-Z]\w*"), "a VTK type"),
    (re.compile(r"\bnlohmann::"), "a JSON library's type"),
    (re.compile(r"\bsqlite3\w*"), "an SQLite type"),
]


def without_comments_and_strings(text):
    """The text with comments and string literals blanked, line numbers kept; #include lines stay whole."""
    pattern = re.compile(
        r'(?P<keep>^[ \t]*#[ \t]*include[^\n]*)|(?P<drop>//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*")',
        re.DOTALL | re.MULTILINE)

    def replace(match):
        if match.group("keep") is not None:
            return match.group("keep").split("//")[0]
        return "\n" * match.group("drop").count("\n")

    return pattern.sub(replace, text)


class Checker:
    def __init__(self, root):
        self.root = root
        self.problems = []
        self.files = 0

    def report(self, path, line, rule, words):
        self.problems.append((path.as_posix(), line, rule, words))

    def check_tree(self):
        for top in ("engine", "widgets", "app"):
            for file in sorted((self.root / top).rglob("*")):
                if file.suffix in SOURCE_SUFFIXES and file.is_file():
                    self.check_file(file)
        self.problems.sort()

    def check_file(self, file):
        path = file.relative_to(self.root)
        self.files += 1
        text = file.read_text(encoding="utf-8", errors="replace")
        code = without_comments_and_strings(text)
        for number, line in enumerate(code.splitlines(), 1):
            match = INCLUDE.match(line)
            if match and match.group(1) == '"':
                self.check_project_include(path, number, match.group(2))
            elif match:
                self.check_library_include(path, number, match.group(2))
            elif path.parts[0] == "engine":
                self.check_engine_line(path, number, line)

    # -- the project's own headers -------------------------------------------------------------------------------

    def check_project_include(self, path, line, target):
        if target.endswith(".moc") or Path(target).name.startswith(("ui_", "moc_")):
            return
        parts = Path(target).parts
        if parts[0] == "tests":
            self.report(path, line, "tests", f'"{target}": nothing but tests includes tests')
            return
        if parts[0] not in ("engine", "widgets", "app") or ".." in parts or len(parts) < 2:
            self.report(path, line, "root", f'"{target}": write project includes from the repository\'s root, '
                                            "libraries in <>")
            return
        if target not in MADE_BY_THE_BUILD and not (self.root / target).is_file():
            self.report(path, line, "missing", f'"{target}" does not exist')
            return
        reason = self.refusal(path, target, parts)
        if reason:
            self.report(path, line, "folder", f'"{target}": {reason}')

    def refusal(self, path, target, parts):
        """Why `path` may not include `target`, or None."""
        if target in SVG_INSIDE and not is_svg_source(path):
            return "only the SVG reader's own sources include it"
        if target in VTK_INSIDE and path.parts[:2] != ("engine", "exchange"):
            return "only the writers of VTK files in engine/exchange include it"
        if path.parts[:2] in UNDRAWN and (parts[0] == "widgets" or parts[:2] == ("app", "drawing")):
            return "/".join(path.parts[:2]) + " includes neither widgets nor app/drawing: its program does not load their libraries"
        if path.parts[:2] == ("app", "drawing") and parts[0] == "widgets" and target not in DRAWING_HEADERS:
            return "app/drawing includes only widgets that draw without a display"
        return None

    # -- libraries -----------------------------------------------------------------------------------------------

    def check_library_include(self, path, line, target):
        home = tuple(path.parts[:2])
        header = path.suffix in HEADER_SUFFIXES
        name = f"<{target}>"
        if target.startswith(("engine/", "widgets/", "app/", "tests/")):
            self.report(path, line, "root", f"{name}: project includes are written in quotes")
        elif target.startswith("opencv2/") or target == "opencv.hpp":
            if home not in OPENCV_FOLDERS or header:
                self.report(path, line, "opencv", f"{name}: OpenCV only in the .cpp files of "
                                                  "engine/shape, engine/calibration, engine/devices, engine/media, engine/simulation and engine/thermography")
        elif re.match(r"vtk[A-Z]", target) or target.startswith("QVTK"):
            if home not in VTK_FOLDERS or (header and home[0] == "engine"):
                self.report(path, line, "vtk", f"{name}: VTK only in widgets/scene and the .cpp files of "
                                               "engine/exchange")
        elif target.startswith("ceres/"):
            if home != ("engine", "calibration") or header:
                self.report(path, line, "ceres", f"{name}: Ceres only in the .cpp files of engine/calibration")
        elif re.match(r"dl_[a-z]", target):
            if home != ("engine", "shape") or header:
                self.report(path, line, "dxflib", f"{name}: dxflib only in the .cpp files of engine/shape")
        elif target == "hdf5.h":
            if home != ("engine", "exchange") or header:
                self.report(path, line, "hdf5", f"{name}: HDF5 only in the .cpp files of engine/exchange")
        elif target == "zlib.h":
            if home != ("engine", "studies") or header:
                self.report(path, line, "zlib", f"{name}: zlib only in the .cpp files of engine/studies")
        elif target == "png.h":
            if path.as_posix() != "engine/media/plain_png.cpp":
                self.report(path, line, "png", f"{name}: libpng only in engine/media/plain_png.cpp")
        elif target == "sqlite3.h":
            if path.as_posix() != "engine/recording/session_store.cpp":
                self.report(path, line, "sqlite", f"{name}: SQLite only in engine/recording/session_store.cpp")
        elif target.startswith("openssl/"):
            if path.as_posix() != "engine/recording/sha256.cpp":
                self.report(path, line, "openssl", f"{name}: OpenSSL only in engine/recording/sha256.cpp")
        elif target == "mosquitto.h":
            if path.as_posix() != "engine/monitor/mqtt_module.cpp":
                self.report(path, line, "mosquitto", f"{name}: libmosquitto only in bask-mqtt.so")
        elif target == "qcustomplot.h":
            if home not in QCUSTOMPLOT_FOLDERS:
                self.report(path, line, "qcustomplot", f"{name}: QCustomPlot only in widgets/plots")
        elif target.startswith("nlohmann/"):
            forward = target == "nlohmann/json_fwd.hpp" and (home in COMMAND_FOLDERS or is_json_inside(path))
            if header and not forward:
                self.report(path, line, "json", f"{name}: the JSON library only in .cpp files")
        elif re.match(r"Q([A-Z]|t)", target):
            self.check_qt_include(path, line, target)
        elif not self.always_allowed(target):
            self.report(path, line, "library", f"{name}: not a library of ARCHITECTURE.md")

    @staticmethod
    def always_allowed(target):
        standard = re.fullmatch(r"[a-z_0-9]+", target)
        eigen = target.startswith("Eigen/")
        return bool(standard or eigen or SYSTEM_HEADER.fullmatch(target))

    def check_qt_include(self, path, line, target):
        if tuple(path.parts[:2]) in COMMAND_FOLDERS:
            module, _, name = target.rpartition("/")
            if name.startswith(("QApplication", "QGuiApplication", "QWidget")) or module in ("QtGui", "QtWidgets"):
                self.report(path, line, "qt", f"<{target}>: subcommands run without a display")
            return
        if path.parts[0] != "engine":
            return
        if not qt_in_engine(path):
            self.report(path, line, "qt", f"<{target}>: Qt in the engine only in the .cpp files of experiment, recording and drivers, "
                                          "shape's svg_*.cpp and runtime's worker")
            return
        module, _, name = target.rpartition("/")
        known = QT_CORE | QT_MODULES_IN_ENGINE | (QT_SVG if is_svg_source(path) else set())
        known |= QT_LINKS if is_link_source(path) else set()
        known |= QT_PAINTING if path.as_posix() == PAINTING_MODULE else set()
        if (module and module not in QT_MODULES_IN_ENGINE) or name not in known:
            self.report(path, line, "qt", f"<{target}>: the engine uses QtCore only")

    def check_engine_line(self, path, line, text):
        if path.suffix not in HEADER_SUFFIXES:
            return
        for pattern, what in ENGINE_HEADER_TYPES:
            match = pattern.search(text)
            known = is_json_inside(path) if what.startswith("a JSON") else path.as_posix() in VTK_INSIDE | OPENCV_INSIDE
            if match and not known:
                self.report(path, line, "type", f"{match.group(0)}: {what} in an engine header")
        if not qt_in_engine(path):
            match = QT_NAME.search(text)
            if match:
                self.report(path, line, "type", f"{match.group(0)}: a Qt type in an engine header")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parent.parent)
    arguments = parser.parse_args()
    if not (arguments.root / "engine").is_dir():
        print(f"{arguments.root}: no engine/ folder here", file=sys.stderr)
        return 2
    checker = Checker(arguments.root.resolve())
    checker.check_tree()
    for path, line, rule, words in checker.problems:
        print(f"{path}:{line}: {rule}: {words}")
    count = len(checker.problems)
    print(f"include check: {checker.files} files, {count} violation{'' if count == 1 else 's'}", file=sys.stderr)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
