// Whether the recordings that are open are as they were recorded.

#include "app/session_verification.h"

#include "app/examples.h"
#include "app/resources.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_store.h"
#include "tests/support/wait_for.h"

#include <QStringList>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

class SessionVerificationTest : public testing::Test {
protected:
    SessionVerificationTest() {
        initResources();
        QObject::connect(&verification, &SessionVerification::verified,
                         [this](const QString& path, const SessionVerdict& verdict) {
                             told << path + u' ' + QLatin1String(verificationWord(verdict));
                         });
        QObject::connect(&verification, &SessionVerification::failed,
                         [this](const QString& path, const Error&) { told << path + " failed"; });
    }

    QString record(const char* name, int samples = 20) {
        const QString path = folder.filePath(QLatin1String(name));
        auto writer = SessionWriter::create(path.toStdString(), readExample("three-objects").value(), true,
                                            0.5, SessionWriter::Earlier::Replaced);
        EXPECT_TRUE(writer);
        for (int k = 0; k < samples; ++k) {
            TraceSample sample;
            sample.time_s = 0.1 * k;
            sample.objects.resize(3);
            EXPECT_TRUE((*writer)->add(sample));
        }
        EXPECT_TRUE((*writer)->finish("settled"));
        return path;
    }

    QTemporaryDir folder;
    SessionVerification verification;
    QStringList told;
};

} // namespace

// Catches: an overlaid run that is passed over, an altered one that is not told, and one that cannot be read
// that keeps the others waiting.
TEST_F(SessionVerificationTest, TheOpenRunAndThoseOverItAreVerified) {
    const QString open = record("open.bask"), over = record("over.bask"), last = record("last.bask");
    {
        const auto store = SessionStore::create(over.toStdString());
        ASSERT_TRUE((*store)->execute("UPDATE step SET measured_K_1 = 300 WHERE number = 7"));
    }
    verification.start(open);
    verification.add(over);
    verification.add(over); // once
    verification.add(folder.filePath("gone.bask"));
    verification.add(last);
    ASSERT_TRUE(waitFor([&] { return told.size() == 4; }));
    EXPECT_EQ(told, (QStringList{open + " intact", over + " altered",
                                 folder.filePath("gone.bask") + " failed", last + " intact"}));
}

// Catches: a verdict on the run before that is told of the one that is open now, or on a file that is let go
// of.
TEST_F(SessionVerificationTest, WhatIsNoLongerWantedIsForgotten) {
    const QString first = record("first.bask", 3000), second = record("second.bask"),
                  third = record("third.bask"), last = record("last.bask");
    verification.start(first);
    verification.add(second);
    verification.start(third);
    verification.add(second);
    verification.release(second);
    verification.add(last);
    ASSERT_TRUE(waitFor([&] { return told.contains(last + " intact"); }));
    EXPECT_EQ(told, (QStringList{third + " intact", last + " intact"}));
}

} // namespace bask::test
