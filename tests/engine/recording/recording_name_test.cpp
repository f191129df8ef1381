#include "engine/recording/recording_name.h"

#include <gtest/gtest.h>

namespace bask {

// Catches a name that is not of its moment, or is taken for one that a person chose.
TEST(RecordingName, IsThatOfItsSecond) {
    EXPECT_EQ(recordingStem(1'773'480'413), "20260314T092653Z");
    EXPECT_EQ(recordingStem(1'773'480'413, 2), "20260314T092653Z-2");
    EXPECT_TRUE(isRecordingStem(recordingStem(1'773'480'413)));
    EXPECT_TRUE(isRecordingStem(recordingStem(1'773'480'413, 12)));
    EXPECT_TRUE(isRecordingStem(recordingStem(0)));
}

// Catches names that people choose and that are taken for Bask's.
TEST(RecordingName, AnyOtherIsAPersons) {
    for (const char* name : {"", "evening", "20260314T092653Z copy", "20260314T092653Z-",
                             "20260314T092653Z-b", "20260314T092653", "2026-03-14T09:26:53Z",
                             "x20260314T092653Z", "20260314T092653Z_2", "20260314 092653Z"})
        EXPECT_FALSE(isRecordingStem(name)) << name;
}

} // namespace bask
