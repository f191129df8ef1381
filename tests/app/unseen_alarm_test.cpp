// No alarm of priority 1 is out of sight and hearing: from the simulated rig to the list, the state bar and
// the horn; and by what the log of alarms makes of any sequence.

#include "app/horn.h"
#include "engine/base/message_code.h"
#include "engine/runtime/alarm_log.h"
#include "engine/runtime/fault_script.h"
#include "tests/engine/runtime/loop_on_rig.h"
#include "widgets/common/alarm_button.h"
#include "widgets/common/alarm_list.h"

#include <QTreeWidget>

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace bask::test {
namespace {

bool isListedAlone(const std::vector<Alarm>& alarms, const std::string& key) {
    const AlarmGroups groups = groupAlarms(alarms);
    return std::ranges::any_of(groups.present, [&](const AlarmGroup& g) { return g.alarm.key == key; });
}

bool isHeard(const std::vector<Alarm>& alarms) {
    Horn horn;
    horn.setSound([] {});
    horn.setMode(HornMode::Always);
    Snapshot snapshot;
    snapshot.alarms = alarms;
    horn.apply(snapshot);
    return horn.isSounding();
}

/// Whether a present group that calls has it, and the horn sounds as for priority 1.
bool isSeenAndHeard(const std::vector<Alarm>& alarms, const Alarm& alarm) {
    const AlarmGroups groups = groupAlarms(alarms);
    const auto holds = [&](const AlarmGroup& group) {
        return group.alarm.id == alarm.id ||
               std::ranges::find(group.consequences, alarm.id, &Alarm::id) != group.consequences.end();
    };
    return std::ranges::any_of(groups.present,
                               [&](const AlarmGroup& group) {
                                   return holds(group) && group.isCalling() && group.alarm.priority == 1;
                               }) &&
           isHeard(alarms);
}

/// A source on its own, whose heat goes on while Bask has it off.
struct StuckSource : LoopOnRig {
    StuckSource() : LoopOnRig(hotSource()) {
        periods(40);
        setFault(rig, SimulatedFault::SourceHeatsAlone, 0, true);
    }
    static Experiment hotSource() {
        Experiment experiment = twoDisks(40.0);
        experiment.sampling = {0.1, 30, 2};
        return experiment;
    }
    const Alarm* find(MessageCode code) const {
        const auto found = std::ranges::find_if(
            log.alarms(), [&](const Alarm& alarm) { return alarm.message.code == code && alarm.isActive; });
        return found == log.alarms().end() ? nullptr : &*found;
    }
    void pass(double for_s) {
        for (const double until_s = rig.clock().now_s() + for_s; rig.clock().now_s() < until_s;) {
            periods(1);
            log.update(1.7e9 + rig.clock().now_s(), loop.alarmConditions());
        }
    }
    const Alarm* await(MessageCode code, double max_s) {
        for (const double until_s = rig.clock().now_s() + max_s;
             find(code) == nullptr && rig.clock().now_s() < until_s;)
            pass(0.1);
        return find(code);
    }
    double utc_s() const { return 1.7e9 + rig.clock().now_s(); }

    AlarmLog log;
};

} // namespace

// Catches: a source over its trip limit that nobody sees or hears, since an earlier alarm of it was shelved
// or acknowledged.
TEST(UnseenAlarm, ASourceOverItsLimitCallsBesideItsShelvedCause) {
    for (const bool isShelved : {true, false}) {
        StuckSource rig;
        const Alarm* const unasked = rig.await(MessageCode::SafetySourceHeatsUnasked, 60.0);
        ASSERT_NE(unasked, nullptr);
        const std::uint64_t cause = unasked->id;
        ASSERT_TRUE(isShelved ? rig.log.shelve(cause, rig.utc_s(), 1800.0, "the relay is known").ok()
                              : rig.log.acknowledge(cause));
        EXPECT_FALSE(isHeard(rig.log.alarms()));
        if (!isShelved)
            rig.pass(31.0);
        ASSERT_EQ(rig.find(MessageCode::SafetySourceHot), nullptr);
        const Alarm* const hot = rig.await(MessageCode::SafetySourceHot, 900.0);
        ASSERT_NE(hot, nullptr) << "the rig stays below its limit";
        EXPECT_FALSE(hot->isAcknowledged);
        EXPECT_TRUE(isListedAlone(rig.log.alarms(), hot->key));
        EXPECT_TRUE(isSeenAndHeard(rig.log.alarms(), *hot));
        EXPECT_TRUE(rig.reasonGiven(MessageCode::SafetySourceHot));
        EXPECT_TRUE(rig.reasonGiven(MessageCode::SafetySourceHeatsUnasked));

        AlarmList list;
        list.setAlarms(rig.log.alarms());
        const auto* tree = list.findChild<QTreeWidget*>(QStringLiteral("alarmListTree"));
        bool isRow = false;
        for (int row = 0; row < tree->topLevelItemCount(); ++row)
            isRow = isRow || tree->topLevelItem(row)->text(4).contains(QStringLiteral("trip limit"));
        EXPECT_TRUE(isRow);
        AlarmButton button;
        button.setAlarms(rig.log.alarms());
        EXPECT_TRUE(button.text().contains(QStringLiteral("trip limit"))) << button.text().toStdString();

        ASSERT_TRUE(rig.log.acknowledge(hot->id));
        rig.pass(1.0);
        EXPECT_TRUE(!isShelved || isListedAlone(rig.log.alarms(), "SafetySourceHot"))
            << "seen by its own row";
        EXPECT_FALSE(isHeard(rig.log.alarms()));
    }
}

// Catches: any other sequence of conditions and of what a person does that leaves a grave alarm unseen; and
// one fault that is many rows.
TEST(UnseenAlarm, NoSequenceHidesOneOfPriorityOne) {
    struct Kind {
        const char* key;
        const char* cause;
        int priority;
    };
    constexpr std::array kKinds{
        Kind{"root", "", 1}, Kind{"grave", "root", 1}, Kind{"slight", "root", 3}, Kind{"deep", "grave", 1},
        Kind{"mild", "", 2}, Kind{"under", "mild", 1}, Kind{"other", "under", 2}, Kind{"alone", "", 1}};
    std::mt19937 random(20261130);
    const auto draw = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    int seen = 0, together = 0;
    for (int sequence = 0; sequence < 300; ++sequence) {
        AlarmLog log;
        std::set<std::size_t> now;
        double utc_s = 1.7e9;
        for (int step = 0; step < 60; ++step) {
            utc_s += draw(4) == 0 ? 1.0 + draw(600) : 0.1 * (1 + draw(40));
            for (int flips = draw(3); flips > 0; --flips)
                if (const auto kind = static_cast<std::size_t>(draw(kKinds.size())); !now.erase(kind))
                    now.insert(kind);
            std::vector<AlarmCondition> conditions;
            for (const std::size_t kind : now) {
                AlarmCondition condition{kKinds[kind].key, {MessageCode::SafetySourceHot, {"1", "0"}}};
                condition.priority = kKinds[kind].priority;
                condition.cause = kKinds[kind].cause;
                conditions.push_back(std::move(condition));
            }
            log.update(utc_s, conditions);
            std::vector<std::uint64_t> called; // by a row of their own
            for (const AlarmGroup& group : groupAlarms(log.alarms()).present)
                called.push_back(group.alarm.id);
            if (!log.alarms().empty()) {
                const std::uint64_t id =
                    log.alarms()[static_cast<std::size_t>(draw(static_cast<int>(log.alarms().size())))].id;
                const bool isRow = std::ranges::find(called, id) != called.end();
                std::set<std::uint64_t> others; // that call by rows of their own
                for (const Alarm& alarm : log.alarms())
                    if (alarm.isActive && !alarm.isAcknowledged && alarm.id != id &&
                        std::ranges::find(called, alarm.id) != called.end())
                        others.insert(alarm.id);
                switch (draw(8)) {
                case 0:
                    (void)log.acknowledge(id);
                    break;
                case 1: {
                    const bool isRefused = !log.shelve(id, utc_s, 60.0 * (1 + draw(30)), "known");
                    EXPECT_TRUE(!isRefused || !isRow) << "a row that cannot be shelved";
                    break;
                }
                case 2:
                    (void)log.unshelve(id);
                    break;
                case 3:
                    (void)log.acknowledgeAll();
                    others.clear();
                    break;
                default:
                    break;
                }
                for (const Alarm& alarm : log.alarms())
                    EXPECT_FALSE(others.contains(alarm.id) && alarm.isAcknowledged)
                        << alarm.key << ": acknowledged by another one's row";
            }
            for (const Alarm& alarm : log.alarms()) {
                ASSERT_TRUE(alarm.shelvedUntil_s == 0.0 || alarm.isAcknowledged);
                if (!alarm.isActive || alarm.isAcknowledged || alarm.priority > 1)
                    continue;
                ++seen;
                ASSERT_TRUE(isSeenAndHeard(log.alarms(), alarm))
                    << alarm.key << ", sequence " << sequence << ", step " << step;
            }
            const auto root = std::ranges::find(log.alarms(), "root", &Alarm::key);
            if (root == log.alarms().end() || !root->isActive || root->shelvedUntil_s > 0.0)
                continue;
            for (const Alarm& alarm : log.alarms())
                if (alarm.cause == "root" && alarm.isActive && alarm.shelvedUntil_s == 0.0 &&
                    alarm.raised_s >= root->raised_s && alarm.raised_s - root->raised_s <= 30.0 &&
                    alarm.isAcknowledged == root->isAcknowledged) {
                    ++together;
                    EXPECT_FALSE(isListedAlone(log.alarms(), alarm.key)) << "one fault, two rows";
                }
        }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_GT(together, 300);
}

} // namespace bask::test
