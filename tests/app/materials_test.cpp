// A library of materials, as a person keeps it: saved from an object, shared as a file, found again.

#include "app/materials_dialog.h"
#include "app/save_material_dialog.h"
#include "engine/experiment/material_file.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/message_bar.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

namespace bask::test {
namespace {

class MaterialsTest : public WindowTest {
protected:
    const QString file = qEnvironmentVariable("BASK_SETTINGS_DIR") + "/materials.json";
    QTemporaryDir shared;

    void SetUp() override {
        WindowTest::SetUp();
        QFile::remove(file);
    }
    void TearDown() override {
        WindowTest::TearDown();
        QFile::remove(file);
    }
    void openObjects() {
        ASSERT_NO_FATAL_FAILURE(openWindow());
        QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
    }
    /// Presses a button of the form, which may have to be scrolled to.
    void press(const char* name) {
        auto* button = find<QPushButton>(name);
        ASSERT_TRUE(waitFor([button] { return button->isEnabled(); })) << name;
        button->click();
    }
    void save(const char* name, const char* source) {
        press("saveMaterial");
        ASSERT_NE(window->findChild<SaveMaterialDialog*>(), nullptr);
        find<QLineEdit>("materialName")->setText(name);
        find<QLineEdit>("materialSource")->setText(source);
        find<QDoubleSpinBox>("uncertainty_emittance")->setValue(0.02);
        keepPicture(QStringLiteral("save-material-dialog"));
        click("takeMaterial");
        EXPECT_TRUE(waitFor([this] { return window->findChild<SaveMaterialDialog*>() == nullptr; }));
    }
    MaterialLibrary kept() const {
        const auto read = readMaterialLibrary(file.toStdString());
        return read ? *read : MaterialLibrary();
    }
    QString message() { return find<MessageBar>("materialsMessage")->sentence(); }
};

} // namespace

// Catches a material that is saved and not found again, and an experiment that does not say what was used.
TEST_F(MaterialsTest, IsSavedFromAnObjectAndFoundAgain) {
    ASSERT_NO_FATAL_FAILURE(openObjects());
    ASSERT_NO_FATAL_FAILURE(save("our paint", "DSC, sample 12"));
    ASSERT_EQ(kept().size(), 1U);
    const Material saved = kept().front();
    EXPECT_EQ(saved.name, "our paint");
    EXPECT_EQ(saved.date.size(), 10U);
    EXPECT_NEAR(saved.uncertainties.at("emittance"), 0.02, 1e-12);
    EXPECT_EQ(saved.uncertainties.size(), 1U);
    EXPECT_EQ(window->document().experiment().objects[0].material, saved);
    EXPECT_EQ(find<QComboBox>("materialPreset")->currentText(), "our paint");
    closeWindow();
    ASSERT_NO_FATAL_FAILURE(openObjects());
    EXPECT_GE(find<QComboBox>("materialPreset")->findText("our paint"), 0);
}

// Catches a rename, removal, import or export that does something else, or that cannot be taken back.
TEST_F(MaterialsTest, IsRenamedRemovedAndShared) {
    ASSERT_NO_FATAL_FAILURE(openObjects());
    ASSERT_NO_FATAL_FAILURE(save("our paint", ""));
    const QString copy = shared.filePath("copy.json");
    window->files().setFileChooser([&](const FileQuestion&) { return QString(copy); });
    press("materials");
    auto* list = find<QListWidget>("materialList");
    ASSERT_EQ(list->count(), 1);
    keepPicture(QStringLiteral("materials-dialog"));
    press("exportMaterials");
    EXPECT_EQ(readMaterialLibrary(copy.toStdString()).value(), kept());
    const auto* told = find<MessageBar>("messageBar");
    EXPECT_TRUE(told->sentence().contains(QFileInfo(copy).fileName())) << told->sentence().toStdString();
    EXPECT_TRUE(told->findChild<QPushButton*>("messageOther")->isVisibleTo(told)) << "Show in folder";
    list->item(0)->setText("his paint"); // what the editor of the list does
    ASSERT_TRUE(waitFor([this] { return kept().front().name == "his paint"; }));
    press("importMaterials");
    ASSERT_EQ(kept().size(), 2U);
    EXPECT_EQ(kept()[1].name, "our paint");
    EXPECT_TRUE(message().contains("1 added")) << message().toStdString();
    list->setCurrentRow(0);
    press("removeMaterial");
    ASSERT_EQ(kept().size(), 1U);
    find<MessageBar>("materialsMessage")->findChild<QPushButton*>("messageAction")->click();
    ASSERT_EQ(kept().size(), 2U);
    EXPECT_EQ(kept()[0].name, "his paint");
}

// Catches a damaged library that is replaced by an empty one, and one that nobody is told of.
TEST_F(MaterialsTest, ADamagedLibraryIsLeftAsItIsAndTold) {
    const QByteArray damaged = R"({"format":"bask-materials","version":1,"materials":[{"name":"precious)";
    {
        QFile out(file);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(damaged);
    }
    ASSERT_NO_FATAL_FAILURE(openObjects());
    EXPECT_TRUE(
        waitFor([this] { return find<MessageBar>("messageBar")->sentence().contains("materials.json"); }));
    press("saveMaterial");
    EXPECT_EQ(window->findChild<SaveMaterialDialog*>(), nullptr);
    press("materials");
    EXPECT_EQ(window->findChild<MaterialsDialog*>(), nullptr);
    QFile in(file);
    ASSERT_TRUE(in.open(QIODevice::ReadOnly));
    EXPECT_EQ(in.readAll(), damaged);
}

// Catches "2 %" of a value taken as 0.02.
TEST_F(MaterialsTest, AnUncertaintyMayBeAShareOfItsValue) {
    ASSERT_NO_FATAL_FAILURE(openObjects());
    const double emittance = window->document().experiment().objects[0].material.emittance;
    press("saveMaterial");
    auto* field = find<QDoubleSpinBox>("uncertainty_emittance");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "2 %");
    field->interpretText();
    EXPECT_NEAR(field->value(), 0.02 * emittance, 1e-4);
    QTest::keyClick(window->findChild<SaveMaterialDialog*>(), Qt::Key_Escape);
}

} // namespace bask::test
