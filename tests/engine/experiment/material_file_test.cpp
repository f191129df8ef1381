#include "engine/experiment/material_file.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/experiment_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace bask {
namespace {

struct MaterialFile : testing::Test {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("material-file-" + std::to_string(::getpid()));
    const std::string path = folder / "materials.json";

    MaterialFile() { std::filesystem::create_directories(folder); }
    ~MaterialFile() override { std::filesystem::remove_all(folder); }

    Result<MaterialLibrary> read(const std::string& text) const {
        std::ofstream(path, std::ios::binary) << text;
        return readMaterialLibrary(path);
    }
    /// With one material that has these fields.
    Result<MaterialLibrary> readOne(const std::string& fields) const {
        return read(R"({"format":"bask-materials","version":1,"materials":[{)" + fields + "}]}");
    }
    std::string refusal(const std::string& fields) const {
        const auto got = readOne(fields);
        return got ? "" : describe(got.error());
    }
};

const std::string kPaint =
    R"("name":"paint","emittance":0.95,"absorptance":0.94,"specific_heat_J_kgK":900,"density_kg_m3":2700,"thickness_mm":1)";

MaterialLibrary twoMaterials() {
    MaterialLibrary out(2);
    out[0] = {"paint \u00ab7\u00bb", 0.95, 0.94, 911.0, 2755.0, 0.0015, 0.3, "DSC, sample 12", "2026-11-23"};
    out[0].uncertainties = {
        {"emittance", 0.02}, {"specific_heat", 12.5}, {"thickness", 1e-5}, {"infill", 0.0}};
    out[1] = {"foil", 0.05, 0.05, 900.0, 2700.0, 1e-5, 1.0};
    return out;
}

} // namespace

TEST_F(MaterialFile, ComesBackAsItWasWritten) {
    ASSERT_TRUE(writeMaterialLibrary(twoMaterials(), path));
    const auto back = readMaterialLibrary(path);
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(*back, twoMaterials());
    ASSERT_TRUE(writeMaterialLibrary({}, path));
    EXPECT_EQ(readMaterialLibrary(path).value(), MaterialLibrary());
}

// Catches a file that only Bask can read: its keys are those of experiments, one a line.
TEST_F(MaterialFile, IsReadable) {
    ASSERT_TRUE(writeMaterialLibrary(twoMaterials(), path));
    const std::string text = readTextFile(path, 1U << 20).value();
    for (const char* line :
         {"\"format\": \"bask-materials\"", "\"specific_heat_J_kgK\": 911.0", "\"thickness_mm\": 1.5",
          "\"source\": \"DSC, sample 12\"", "\"date\": \"2026-11-23\"", "\"uncertainty\": {"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

TEST_F(MaterialFile, TheLeastIsNameAndValues) {
    const auto least = readOne(kPaint);
    ASSERT_TRUE(least) << describe(least.error());
    ASSERT_EQ(least->size(), 1U);
    EXPECT_EQ(least->front().name, "paint");
    EXPECT_DOUBLE_EQ(least->front().infill, 1.0);
    EXPECT_TRUE(least->front().uncertainties.empty());
}

// Catches a refusal that does not say which file, which material and which value.
TEST_F(MaterialFile, RefusalsNameFileAndPlace) {
    const std::string wrong = refusal(kPaint + R"(,"uncertainty":{"density_kg_m3":-1})");
    for (const char* part : {"materials.json", "materials[0].uncertainty.density_kg_m3", "out of range"})
        EXPECT_NE(wrong.find(part), std::string::npos) << part << wrong;
    EXPECT_NE(refusal(kPaint + R"(,"colour":"red")").find("colour"), std::string::npos);
    EXPECT_NE(refusal(kPaint + R"(,"uncertainty":{"emissivity":1})").find("emissivity"), std::string::npos);
    EXPECT_NE(refusal(kPaint + R"(,"date":"yesterday")").find("yesterday"), std::string::npos);
    EXPECT_NE(refusal(kPaint + R"(,"source":5)").find("materials[0].source"), std::string::npos);
    EXPECT_NE(refusal(R"("name":"paint")").find("emittance"), std::string::npos);
    EXPECT_NE(
        refusal(
            R"("emittance":0.9,"absorptance":0.9,"specific_heat_J_kgK":1,"density_kg_m3":1,"thickness_mm":1)")
            .find("name"),
        std::string::npos);
    EXPECT_NE(refusal(kPaint + R"(},{)" + kPaint).find("two materials are named"), std::string::npos);
}

TEST_F(MaterialFile, DamagedHugeAndHostileFilesAreRefused) {
    ASSERT_TRUE(writeMaterialLibrary(twoMaterials(), path));
    const std::string whole = readTextFile(path, 1U << 20).value();
    for (std::size_t size = 0; size + 2 < whole.size(); size += 7)
        EXPECT_FALSE(read(whole.substr(0, size))) << size;
    const auto code = [this](const std::string& text) {
        const auto got = read(text);
        return got ? MessageCode::None : got.error().code();
    };
    EXPECT_EQ(code(""), MessageCode::FileEmpty);
    EXPECT_EQ(code(std::string(100, '\0')), MessageCode::JsonSyntax);
    EXPECT_EQ(code(std::string(100000, '[')), MessageCode::JsonTooDeep);
    EXPECT_EQ(code(std::string((std::size_t{4} << 20) + 1, ' ')), MessageCode::FileTooLarge);
    EXPECT_EQ(code(R"({"format":"bask-materials","version":2,"materials":7})"), MessageCode::VersionTooNew);
    EXPECT_EQ(code(R"({"format":"bask-experiment","version":1})"), MessageCode::ValueUnknown);
    EXPECT_EQ(code(R"({"format":"bask-materials","version":1,"materials":{}})"), MessageCode::JsonWrongType);
    EXPECT_FALSE(read("[]"));
    EXPECT_EQ(readMaterialLibrary(folder).error().code(), MessageCode::FileUnreadable);
    EXPECT_EQ(readMaterialLibrary(path + "-none").error().code(), MessageCode::FileNotFound);
    EXPECT_FALSE(readOne(kPaint + ",\"source\":\"\\u202egnp.exe\""));
    std::string many = kPaint;
    for (int k = 0; k < 2001; ++k)
        many += "},{" + kPaint;
    EXPECT_FALSE(readOne(many));
}

// Catches a library that is written but not read again, in place of one that is.
TEST_F(MaterialFile, WhatCouldNotBeReadIsNotWritten) {
    ASSERT_TRUE(writeMaterialLibrary(twoMaterials(), path));
    MaterialLibrary wrong = twoMaterials();
    wrong[1].name = wrong[0].name;
    EXPECT_FALSE(writeMaterialLibrary(wrong, path));
    EXPECT_EQ(readMaterialLibrary(path).value(), twoMaterials());
    const auto nowhere = writeMaterialLibrary(twoMaterials(), folder / "none" / "materials.json");
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().code(), MessageCode::FileUnwritable);
}

// Catches source, date and uncertainties that are lost with the experiment, and files without them that
// change.
TEST(MaterialOfAnExperiment, KeepsItsSourceDateAndUncertaintiesAndOthersStayAsTheyWere) {
    const Experiment plain = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    EXPECT_EQ(experimentToJson(plain).find("\"date\""), std::string::npos);
    EXPECT_EQ(experimentToJson(plain).find("\"uncertainty\""), std::string::npos);
    Experiment experiment = plain;
    experiment.objects[1].material.source = "DSC, sample 12";
    experiment.objects[1].material.date = "2026-11-23";
    experiment.objects[1].material.uncertainties = {{"emittance", 0.0174}, {"thickness", 2e-5}};
    const auto back = experimentFromJson(experimentToJson(experiment), "test", ".");
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(*back, experiment);
    experiment.objects[1].material.date = "2026-11-31";
    const auto valid = validate(experiment);
    ASSERT_FALSE(valid);
    EXPECT_EQ(valid.error().where, "objects[1].material.date");
    experiment.objects[1].material.date.clear();
    experiment.objects[1].material.uncertainties["emittance"] = -0.1;
    const auto negative = validate(experiment);
    ASSERT_FALSE(negative);
    EXPECT_EQ(negative.error().where, "objects[1].material.uncertainty.emittance");
}

} // namespace bask
