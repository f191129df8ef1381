#include "engine/model/material_library.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

Material labMaterial(const std::string& name, double emittance = 0.8) {
    Material out;
    out.name = name;
    out.emittance = out.absorptance = emittance;
    return out;
}

MessageCode libraryRefusal(const Material& material) {
    const auto valid = validate(MaterialLibrary{material});
    return valid ? MessageCode::None : valid.error().code();
}

} // namespace

// Catches a material without a name, two of one name, and values that no experiment takes.
TEST(MaterialLibraryCheck, RefusesWhatCannotBeChosen) {
    EXPECT_TRUE(validate(MaterialLibrary{labMaterial("a"), labMaterial("b")}));
    EXPECT_EQ(libraryRefusal(labMaterial("")), MessageCode::ValueOutOfRange);
    EXPECT_EQ(libraryRefusal(labMaterial(std::string(65, 'x'))), MessageCode::ValueOutOfRange);
    EXPECT_EQ(libraryRefusal(labMaterial("a\nb")), MessageCode::NameNotPlain);
    EXPECT_EQ(libraryRefusal(labMaterial("a", 1.5)), MessageCode::ValueOutOfRange);
    const auto twice = validate(MaterialLibrary{labMaterial("a"), labMaterial("a", 0.5)});
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().code(), MessageCode::MaterialNameTwice);
    EXPECT_EQ(twice.error().where, "materials[1].name");
    Material material = labMaterial("a");
    material.uncertainties["emittance"] = -0.1;
    EXPECT_EQ(libraryRefusal(material), MessageCode::ValueOutOfRange);
    material.uncertainties["emittance"] = 0.0;
    EXPECT_EQ(libraryRefusal(material), MessageCode::None);
    material.source = std::string(kMaxSourceLength + 1, 'x');
    EXPECT_EQ(libraryRefusal(material), MessageCode::ValueOutOfRange);
}

TEST(MaterialLibraryCheck, DatesAreDaysThatThereAre) {
    for (const char* date : {"2026-11-23", "2024-02-29", ""}) {
        Material material = labMaterial("a");
        material.date = date;
        EXPECT_EQ(libraryRefusal(material), MessageCode::None) << date;
    }
    for (const char* date :
         {"2026-02-29", "2026-13-01", "2026-1-1", "23.11.2026", "2026-11-23 ", "2026-+1-01"}) {
        Material material = labMaterial("a");
        material.date = date;
        EXPECT_EQ(libraryRefusal(material), MessageCode::DateWrong) << date;
    }
}

// Catches a colleague's file that replaces one's own values, and one that multiplies when it is read again.
TEST(MaterialLibraryMerge, KeepsOnesOwnAndAddsEachOnce) {
    const MaterialLibrary own{labMaterial("paint", 0.9), labMaterial("foil", 0.05)};
    const MaterialLibrary other{labMaterial("paint", 0.95), labMaterial("foil", 0.05),
                                labMaterial("soot", 0.96)};
    const MergedMaterials once = merged(own, other);
    EXPECT_EQ(once.added, 2);
    EXPECT_EQ(once.known, 1);
    EXPECT_EQ(once.renamed, 1);
    ASSERT_EQ(once.library.size(), 4U);
    EXPECT_EQ(once.library[0], own[0]);
    EXPECT_EQ(once.library[1], own[1]);
    EXPECT_EQ(once.library[2], labMaterial("paint (2)", 0.95));
    EXPECT_EQ(once.library[3], other[2]);
    EXPECT_TRUE(validate(once.library));
    const MergedMaterials again = merged(once.library, other);
    EXPECT_EQ(again.library, once.library);
    EXPECT_EQ(again.added, 0);
    EXPECT_EQ(again.known, 3);
}

// Catches a number at the end of a long name that makes the library invalid, or cuts a character in two.
TEST(MaterialLibraryMerge, ALongNameIsShortenedForItsNumber) {
    std::string name;
    for (int k = 0; k < 64; ++k)
        name += "\u00e9";
    const MergedMaterials both = merged({labMaterial(name, 0.9)}, {labMaterial(name, 0.5)});
    ASSERT_EQ(both.library.size(), 2U);
    EXPECT_TRUE(validate(both.library));
    const std::string& shortened = both.library[1].name;
    EXPECT_EQ(characterCount(shortened), 64U);
    EXPECT_TRUE(shortened.ends_with("\u00e9 (2)"));
}

TEST(MaterialLibraryValues, AreComparedWithoutNameAndForOneMaterialWithoutThickness) {
    Material a = labMaterial("a"), b = a;
    b.name = "b";
    b.source = "measured";
    EXPECT_TRUE(haveSameValues(a, b));
    b.thickness_m = 0.5 * a.thickness_m;
    EXPECT_FALSE(haveSameValues(a, b));
    EXPECT_TRUE(areOneMaterial(a, b));
    b.infill = 0.5;
    EXPECT_FALSE(areOneMaterial(a, b));
}

TEST(MaterialLibraryValues, OneOfTheSameNameIsReplaced) {
    MaterialLibrary library{labMaterial("a"), labMaterial("b")};
    putMaterial(library, labMaterial("a", 0.3));
    putMaterial(library, labMaterial("c"));
    ASSERT_EQ(library.size(), 3U);
    EXPECT_EQ(library[0], labMaterial("a", 0.3));
    EXPECT_EQ(materialNamed(library, "c"), &library[2]);
    EXPECT_EQ(materialNamed(library, "d"), nullptr);
}

} // namespace bask
