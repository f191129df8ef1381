#pragma once
// The Rig page with a document that takes what validates, and an engine that says what it is told to.

#include "tests/widgets/rig/rig_bench.h"
#include "widgets/common/message_bar.h"
#include "widgets/rig/rig_page.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QLabel>
#include <QTest>

#include <gtest/gtest.h>

#include <vector>

namespace bask::test {

struct RigPageFixture : testing::Test {
    Experiment experiment = twoDisks();
    RigPage page;
    std::vector<Command> sent;
    int edits = 0;
    QString refusal; ///< of every edit; empty: taken

    RigPageFixture() {
        QObject::connect(&page, &RigPage::commandIssued, &page,
                         [this](const Command& command) { sent.push_back(command); });
        QObject::connect(&page, &RigPage::experimentEdited, &page, [this](const Experiment& changed) {
            ++edits;
            const auto valid = validate(changed);
            if (!refusal.isEmpty() || !valid)
                return page.showError(refusal.isEmpty() ? QString::fromStdString(describe(valid.error()))
                                                        : refusal);
            experiment = changed;
            page.setExperiment(experiment);
            apply();
        });
        page.resize(1010, 480);
        page.setExperiment(experiment);
        page.show();
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
        apply();
    }
    void apply() { page.apply(quietSnapshot(experiment), true); }
    void useReal() {
        experiment.rig = realRig();
        page.setExperiment(experiment);
        apply();
    }
    template <class T> T* child(const char* name) {
        T* found = page.findChild<T*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QString text(const char* name) { return child<QLabel>(name)->text(); }
    QString message() { return child<MessageBar>("rigMessage")->sentence(); }
    void click(const char* name) {
        QCoreApplication::processEvents(); // what was shown or hidden has its place then
        QTest::mouseClick(child<QAbstractButton>(name), Qt::LeftButton);
    }
    template <class T> const T* last() { return sent.empty() ? nullptr : std::get_if<T>(&sent.back()); }
};

} // namespace bask::test
