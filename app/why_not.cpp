#include "app/why_not.h"

#include "engine/base/message_code.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"

#include <QCoreApplication>

#include <algorithm>

namespace bask {
namespace {

struct WhyNotWords {
    Q_DECLARE_TR_FUNCTIONS(bask::WhyNot)
};

/// Without a sign, and rounded: it changes while it is read.
QString differenceWords(double d_K, TemperatureUnit unit) {
    return formatDifference(d_K, unit, 0).remove(u'+');
}

QString withFirstReason(const QString& text, const Snapshot& snapshot) {
    if (snapshot.reasons.empty())
        return text;
    return text + u' ' + sentenceText(snapshot.reasons.front());
}

QString whyNotArm(const Snapshot& snapshot) {
    switch (snapshot.state) {
    case RunState::Idle:
        return WhyNotWords::tr("Arm is not possible: no experiment is loaded. Open one first.");
    case RunState::Armed:
        return WhyNotWords::tr("The rig is armed already. Press Start.");
    case RunState::Fault:
        return withFirstReason(
            WhyNotWords::tr(
                "Arm is not possible: a stop or a fault is latched. Remove its cause, then press Reset."),
            snapshot);
    case RunState::Stopping:
        return WhyNotWords::tr("Arm is not possible yet: the run is stopping.");
    case RunState::NotReady:
    case RunState::Stopped:
        return withFirstReason(WhyNotWords::tr("Arm is not possible: the rig is not ready."), snapshot);
    default:
        return WhyNotWords::tr("Arm is not possible: a run is on. Stop it first.");
    }
}

QString whyNotStart(RunState state) {
    if (state == RunState::Fault)
        return WhyNotWords::tr("Start is not possible: a stop or a fault is latched. Press Reset, then Arm.");
    if (isRunOn(state))
        return WhyNotWords::tr("Start is not possible: a run is on.");
    return WhyNotWords::tr("Start is not possible: the rig is not armed. Press Arm first.");
}

QString whyNotHold(RunState state) {
    if (state == RunState::Holding)
        return WhyNotWords::tr("The run is held already. Resume goes on, Stop ends it.");
    if (state == RunState::Stopping)
        return WhyNotWords::tr("Hold is not possible: the run is stopping. STOP ends all motion.");
    return WhyNotWords::tr("There is nothing to hold: the robot does not move.");
}

QString whyNotStop(RunState state) {
    if (state == RunState::Stopping)
        return WhyNotWords::tr("The run is stopping already.");
    if (state == RunState::Fault)
        return WhyNotWords::tr("There is no run to stop: a stop or a fault has ended it.");
    return WhyNotWords::tr("There is no run to stop.");
}

QString whyNotRetreat(const Snapshot& snapshot) {
    if (snapshot.state == RunState::Stopping)
        return WhyNotWords::tr("The robot is retreating already.");
    if (snapshot.place == PlaceState::Unknown)
        return WhyNotWords::tr(
            "Retreat is not possible: the robot does not answer. Take the objects away by hand, "
            "mind the heat.");
    if (snapshot.robotAlarm.code != MessageCode::None)
        return WhyNotWords::tr("Retreat is not possible:") + u' ' + sentenceText(snapshot.robotAlarm);
    if (snapshot.place == PlaceState::Unsure)
        return WhyNotWords::tr(
            "Retreat is not possible: the robot is not sure of its place. Look where it is, then "
            "home it or clear its alarm on the Rig page.");
    return WhyNotWords::tr(
        "Retreat is not possible now: there is no robot that can move, or the objects are away "
        "already.");
}

} // namespace

QString whyNot(const Snapshot& snapshot, Verb verb) {
    if (allows(snapshot, verb))
        return {};
    switch (verb) {
    case Verb::Arm:
        return whyNotArm(snapshot);
    case Verb::Start:
        return whyNotStart(snapshot.state);
    case Verb::Hold:
        return whyNotHold(snapshot.state);
    case Verb::Resume:
        return WhyNotWords::tr("There is nothing to resume: no run is held.");
    case Verb::Stop:
        return whyNotStop(snapshot.state);
    case Verb::Retreat:
        return whyNotRetreat(snapshot);
    case Verb::Reset:
        if (snapshot.state == RunState::Stopping && !snapshot.reasons.empty())
            return WhyNotWords::tr("Reset is possible when the robot has come to rest.");
        return WhyNotWords::tr("There is nothing to reset: no stop and no fault is latched.");
    case Verb::EmergencyStop:
        break;
    }
    return {};
}

QString unaskedWait(const Snapshot& snapshot, TemperatureUnit unit) {
    if (!snapshot.unaskedFall || snapshot.state != RunState::Fault)
        return {};
    const UnaskedFall& fall = *snapshot.unaskedFall;
    const QString needed = differenceWords(fall.needed_K, unit);
    if (fall.fallen_K < UnaskedFall::kCools_K)
        return WhyNotWords::tr(
                   "Reset waits for the source to cool by %1: it does not cool yet. Switch it off at "
                   "its mains.")
            .arg(needed);
    return WhyNotWords::tr("The source cools: Reset is possible when it has fallen by %1; now %2.")
        .arg(needed, differenceWords(fall.fallen_K, unit));
}

QString placeSteps(const Snapshot& snapshot) {
    const QString home = WhyNotWords::tr("Home the robot: here, or on the page Rig, By hand, where its place "
                                         "can be confirmed instead.");
    if (snapshot.state != RunState::Fault)
        return home;
    const QString steps = home + u' ' + WhyNotWords::tr("Then Reset, then Arm.");
    const std::optional<Message> other = messageWithin(snapshot.remedy);
    return !other || isAboutPlace(other->code) ? steps : steps + u' ' + messageText(snapshot.remedy);
}

std::optional<Verb> remedyVerb(MessageCode remedy) {
    switch (remedy) {
    case MessageCode::RemedyReset:
        return Verb::Reset;
    case MessageCode::RemedyRetreat:
        return Verb::Retreat;
    case MessageCode::RemedyResume:
        return Verb::Resume;
    case MessageCode::RemedyStop:
        return Verb::Stop;
    default:
        return std::nullopt;
    }
}

QString whyNoForecast(RunForecast::Missing missing) {
    using enum RunForecast::Missing;
    switch (missing) {
    case NotSeen:
        return WhyNotWords::tr("This run has no prediction: it is computed while the Run page is shown, and "
                               "was not ready at Start.");
    case NotFinished:
        return WhyNotWords::tr("This run has no prediction: it was not finished at Start.");
    case NotKnown:
        return WhyNotWords::tr(
            "This run has no prediction: the robot's place or a reading was not known before Start.");
    case NotPossible:
        return WhyNotWords::tr("This run has no prediction: it could not be computed.");
    case Nothing:
        break;
    }
    return {};
}

QString whyNotAnother(const Snapshot& snapshot) {
    if (allowsEdits(snapshot.state))
        return {};
    return WhyNotWords::tr("A run is armed or on. Stop it first; then another experiment can be begun.");
}

QString whyNotHome(const Snapshot& snapshot) {
    if (allowsHome(snapshot))
        return {};
    if (snapshot.state == RunState::Idle)
        return WhyNotWords::tr("Home is not possible: no experiment is loaded.");
    if (!allowsEdits(snapshot.state))
        return WhyNotWords::tr("Home is not possible: a run is armed or on. Stop it first.");
    return WhyNotWords::tr("Home is not possible: the robot does not answer.");
}

QString whyNotEndRecording(const Snapshot& snapshot) {
    if (snapshot.recordingPath.empty())
        return WhyNotWords::tr("There is no recording to end.");
    if (allowsEdits(snapshot.state))
        return {};
    return WhyNotWords::tr("The recording is that of the run, which is armed or on. It ends with the run.");
}

QString whyNotAcknowledge(const Snapshot& snapshot) {
    if (!std::ranges::all_of(snapshot.alarms, &Alarm::isAcknowledged))
        return {};
    return snapshot.alarms.empty() ? WhyNotWords::tr("There is no alarm to acknowledge.")
                                   : WhyNotWords::tr("All alarms are acknowledged already.");
}

QString whyNotSaveSession() {
    return WhyNotWords::tr("There is no recording to save yet. Arm begins one.");
}

} // namespace bask
