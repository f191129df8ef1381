#include "widgets/common/marker_words.h"

#include "engine/base/message_code.h"

#include <QCoreApplication>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::RunPage) // whose words they are
};

} // namespace

QString markerWord(MessageCode code) {
    switch (code) {
    case MessageCode::EventHeld:
        return Words::tr("Hold");
    case MessageCode::EventResumed:
        return Words::tr("Resume");
    case MessageCode::EventStopped:
        return Words::tr("Stop");
    case MessageCode::EventEmergencyStop:
        return Words::tr("STOP");
    case MessageCode::EventSettled:
        return Words::tr("Settled");
    case MessageCode::EventTargetsChanged:
        return Words::tr("New targets");
    case MessageCode::EventGainsChanged:
        return Words::tr("New gains");
    case MessageCode::EventCompromise:
        return Words::tr("Compromise");
    case MessageCode::ReasonSensorInvalid:
        return Words::tr("Sensor lost");
    case MessageCode::EventSensorBack:
        return Words::tr("Sensor back");
    case MessageCode::ReasonSourcePoseLost:
        return Words::tr("Source lost");
    case MessageCode::EventSourcePoseBack:
        return Words::tr("Source back");
    default:
        return alarmPriority(code) == 1 ? Words::tr("Fault") : QString();
    }
}

} // namespace bask
