// Files and addresses that are opened by the desktop, with an xdg-open of this test's own.

#include "tests/support/fake_opener.h"
#include "tests/support/wait_for.h"
#include "widgets/common/desktop_opener.h"

#include <gtest/gtest.h>

namespace bask::test {

// Catches: a window that waits for a desktop which hangs, and another file than the one that was meant.
TEST(DesktopOpener, StartsTheDesktopsProgramAndDoesNotWaitForIt) {
    const FakeOpener opener(
        "for i in 1 2 3 4 5 6 7 8 9 10; do test -e \"${0%xdg-open}go\" && break; sleep 1; done\n"
        "> \"${0%xdg-open}ended\"");
    const QUrl file = QUrl::fromLocalFile(QStringLiteral("/tmp/a report \u00e9 #1 100%.pdf"));
    EXPECT_TRUE(openBy(opener.program(), file));
    EXPECT_FALSE(QFile::exists(opener.pathOf(QStringLiteral("ended"))));
    ASSERT_TRUE(waitFor([&] { return !opener.asked().isEmpty(); }, 10000));
    EXPECT_EQ(opener.asked(), file);
    EXPECT_EQ(opener.asked().toLocalFile(), file.toLocalFile());
    QFile go(opener.pathOf(QStringLiteral("go")));
    ASSERT_TRUE(go.open(QIODevice::WriteOnly));
    EXPECT_TRUE(waitFor([&] { return QFile::exists(opener.pathOf(QStringLiteral("ended"))); }, 20000));
}

// Catches: a program that does not start, without a word.
TEST(DesktopOpener, TellsThatNothingWasStarted) {
    const FakeOpener opener({}, "/nowhere/sh");
    const QUrl address(QStringLiteral("https://example.org/"));
    EXPECT_FALSE(openBy(opener.program(), address));
    EXPECT_TRUE(opener.asked().isEmpty());
    EXPECT_FALSE(openBy(QStringLiteral("no-such-program-of-a-desktop"), address));
}

} // namespace bask::test
