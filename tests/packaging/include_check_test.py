"""Does the include check see each kind of violation, with file and line, and let what is allowed pass?"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).resolve().parents[2] / "packaging" / "check_includes.py"

# A tree in which every include is allowed.
CLEAN = {
    "engine/base/units.h": "#pragma once\n#include <numbers>\n",
    "engine/shape/contour.h": '#pragma once\n#include "engine/base/units.h"\n#include <Eigen/Core>\n',
    "engine/shape/contour_image.cpp": '#include "engine/shape/contour.h"\n#include <opencv2/imgproc.hpp>\n',
    "engine/shape/dxf_drawing.cpp": "#include <dl_dxf.h>\n",
    "engine/radiation/field.h": '#pragma once\n#include "engine/shape/contour.h"\n',
    "engine/exchange/field_file.cpp": '#include "engine/radiation/field.h"\n#include <vtkImageData.h>\n',
    "engine/model/experiment.h": '#pragma once\n#include "engine/shape/contour.h"\n',
    "engine/recording/session.cpp":
        '#include "engine/model/experiment.h"\n#include <QFile>\n#include <nlohmann/json.hpp>\n',
    "engine/recording/session_store.cpp": "#include <sqlite3.h>\n",
    "engine/recording/sha256.cpp": "#include <openssl/sha.h>\n",
    "engine/runtime/snapshot.h": '#pragma once\n#include "engine/model/experiment.h"\n',
    "engine/runtime/engine_worker.h":
        '#pragma once\n#include "engine/runtime/snapshot.h"\n#include <QThread>\nclass W { QThread* m_thread; };\n',
    "widgets/common/chip.h": '#pragma once\n#include "engine/runtime/snapshot.h"\n#include <QWidget>\n',
    "widgets/plots/plot.cpp": '#include "widgets/common/chip.h"\n#include <qcustomplot.h>\n',
    "widgets/scene/view.h": '#pragma once\n#include <vtkNew.h>\n',
    "widgets/run/run_page.cpp": '#include "widgets/plots/plot.h"\n#include "widgets/scene/view.h"\n',
    "widgets/plots/plot.h": "#pragma once\n",
    "widgets/plots/figure_png.h": "#pragma once\n",
    "app/drawing/study_command.cpp": '#include "widgets/plots/figure_png.h"\n',
    "app/main_window.cpp": '#include "engine/runtime/engine_worker.h"\n#include "widgets/common/chip.h"\n',
    "app/commands/run_command.cpp": '#include "engine/shape/contour.h"\n#include <QString>\n',
}


def check(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, "-B", str(CHECK), "--root", folder], capture_output=True, text=True,
                              check=False)
        return done.returncode, done.stdout


class IncludeCheck(unittest.TestCase):
    def assert_violation(self, name, text, line, rule):
        """The clean tree with one more file: exactly one violation, in that line, of that rule."""
        code, output = check({**CLEAN, name: text})
        self.assertEqual(code, 1, output)
        self.assertEqual(len(output.splitlines()), 1, output)
        self.assertTrue(output.startswith(f"{name}:{line}: {rule}: "), output)

    def test_clean_tree_passes(self):
        self.assertEqual(check(CLEAN), (0, ""))

    def test_tree_without_engine_is_an_error_of_its_own(self):
        self.assertEqual(check({"README.md": ""})[0], 2)

    def test_command_includes_widgets(self):
        self.assert_violation("app/commands/bad.cpp", '#include "widgets/common/chip.h"\n', 1, "folder")
        self.assert_violation("app/studies/bad.cpp", '#include "widgets/common/chip.h"\n', 1, "folder")
        self.assert_violation("app/drawing/bad.cpp", '#include "widgets/common/chip.h"\n', 1, "folder")

    def test_command_needs_a_display(self):
        self.assert_violation("app/commands/bad.cpp", "#include <QApplication>\n", 1, "qt")

    def test_sqlite_and_openssl_stay_in_one_file_each(self):
        self.assert_violation("engine/recording/bad.cpp", "#include <sqlite3.h>\n", 1, "sqlite")
        self.assert_violation("engine/recording/bad.cpp", "#include <openssl/evp.h>\n", 1, "openssl")

    def test_engine_does_not_use_qt_sql(self):
        self.assert_violation("engine/recording/bad.cpp", "#include <QSqlQuery>\n", 1, "qt")

    def test_tests_are_included_by_nobody(self):
        self.assert_violation("engine/base/bad.cpp", '#include "tests/support/rig.h"\n', 1, "tests")

    def test_relative_include(self):
        self.assert_violation("engine/base/bad.cpp", '#include "units.h"\n', 1, "root")
        self.assert_violation("engine/base/bad.cpp", '#include "engine/base/../base/units.h"\n', 1, "root")
        self.assert_violation("engine/base/bad.cpp", "#include <engine/base/units.h>\n", 1, "root")

    def test_include_of_a_missing_file(self):
        self.assert_violation("engine/base/bad.cpp", '#include "engine/base/unit.h"\n', 1, "missing")

    def test_libraries_out_of_their_folder(self):
        for name, include, rule in [
            ("engine/shape/bad.h", "<opencv2/core.hpp>", "opencv"),
            ("engine/control/bad.cpp", "<opencv2/core.hpp>", "opencv"),
            ("engine/calibration/bad.h", "<ceres/ceres.h>", "ceres"),
            ("engine/control/bad.cpp", "<ceres/ceres.h>", "ceres"),
            ("engine/shape/bad.h", "<dl_dxf.h>", "dxflib"),
            ("engine/recording/bad.cpp", "<dl_dxf.h>", "dxflib"),
            ("widgets/run/bad.cpp", "<vtkActor.h>", "vtk"),
            ("engine/shape/bad.cpp", "<vtkActor.h>", "vtk"),
            ("engine/exchange/bad.h", "<vtkImageData.h>", "vtk"),
            ("engine/recording/bad.cpp", "<hdf5.h>", "hdf5"),
            ("engine/recording/bad.cpp", "<zlib.h>", "zlib"),
            ("engine/shape/bad.cpp", "<png.h>", "png"),
            ("widgets/run/bad.cpp", "<qcustomplot.h>", "qcustomplot"),
            ("engine/recording/bad.h", "<nlohmann/json.hpp>", "json"),
            ("engine/base/bad.cpp", "<boost/optional.hpp>", "library"),
        ]:
            with self.subTest(file=name, include=include):
                self.assert_violation(name, f"// {include}\n#include {include}\n", 2, rule)

    def test_qt_in_the_engine(self):
        for name, include in [
            ("engine/control/bad.cpp", "<QString>"),
            ("engine/recording/bad.h", "<QString>"),
            ("engine/recording/bad.cpp", "<QImage>"),
            ("engine/recording/bad.cpp", "<QtGui/QImage>"),
            ("engine/runtime/servo_loop.cpp", "<QObject>"),
            ("engine/runtime/engine_worker.cpp", "<QWidget>"),
        ]:
            with self.subTest(file=name, include=include):
                self.assert_violation(name, f"#include {include}\n", 1, "qt")

    def test_types_in_engine_headers(self):
        for text in ["cv::Mat picture();", "class vtkActor;", "class QImage;", "nlohmann::json j();"]:
            with self.subTest(text=text):
                self.assert_violation("engine/shape/bad.h", f"#pragma once\n{text}\n", 2, "type")

    def test_comments_and_strings_do_not_count(self):
        text = ('#pragma once\n// cv::Mat stays in the .cpp\n/* #include "engine/model/experiment.h"\n QString */\n'
                'inline const char* kName = "QString // cv::";\n')
        self.assertEqual(check({**CLEAN, "engine/shape/good.h": text}), (0, ""))


if __name__ == "__main__":
    unittest.main()
