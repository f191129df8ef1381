#include "widgets/common/marker_words.h"

#include "engine/base/message_code.h"

#include <QCoreApplication>

namespace bask {
namespace {

struct MarkerWords {
    Q_DECLARE_TR_FUNCTIONS(bask::RunPage) // whose words they are
};

} // namespace

QString markerWord(MessageCode code) {
    switch (code) {
    case MessageCode::EventHeld:
    case MessageCode::EventHeldFor:
        return MarkerWords::tr("Hold");
    case MessageCode::EventResumed:
        return MarkerWords::tr("Resume");
    case MessageCode::EventStopped:
    case MessageCode::EventStoppedFor:
        return MarkerWords::tr("Stop");
    case MessageCode::EventEmergencyStop:
        return MarkerWords::tr("STOP");
    case MessageCode::EventSettled:
        return MarkerWords::tr("Settled");
    case MessageCode::EventTargetsChanged:
        return MarkerWords::tr("New targets");
    case MessageCode::EventGainsChanged:
        return MarkerWords::tr("New gains");
    case MessageCode::EventCompromise:
        return MarkerWords::tr("Compromise");
    case MessageCode::ReasonSensorInvalid:
        return MarkerWords::tr("Sensor lost");
    case MessageCode::EventSensorBack:
        return MarkerWords::tr("Sensor back");
    case MessageCode::ReasonSourcePoseLost:
        return MarkerWords::tr("Source lost");
    case MessageCode::EventSourcePoseBack:
        return MarkerWords::tr("Source back");
    default:
        return alarmPriority(code) == 1 ? MarkerWords::tr("Fault") : QString();
    }
}

} // namespace bask
