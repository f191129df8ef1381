#include "app/fault_words.h"

#include "widgets/common/display.h"

#include <QCoreApplication>

namespace bask {
namespace {

struct FaultWords {
    Q_DECLARE_TR_FUNCTIONS(bask::FaultWords)
};

} // namespace

QStringList activeFaultWords(const Snapshot& snapshot) {
    QStringList words;
    for (const ActiveFault& active : snapshot.faults) {
        QString word = simulatedFaultWord(active.fault);
        if (isOfObject(active.fault) && active.object < snapshot.objects.size())
            //: a fault, and the object that it is about
            word =
                FaultWords::tr("%1: %2").arg(word, QString::fromStdString(snapshot.objects[active.object]));
        words << word;
    }
    return words;
}

QString faultEffectWords(FaultEffect effect) {
    switch (effect) {
    case FaultEffect::AtOnce:
        break;
    case FaultEffect::WhenWarm:
        return FaultWords::tr("Shows once the object is warmer than the room.");
    case FaultEffect::WhenApart:
        return FaultWords::tr("Shows once the two objects have different temperatures.");
    case FaultEffect::WhenOff:
        return FaultWords::tr("Shows when the heat is switched off.");
    case FaultEffect::InPictures:
        return FaultWords::tr(
            "Shows in the picture of the Calibrate page only: nothing else here uses the camera.");
    case FaultEffect::NoneByCamera:
        return FaultWords::tr(
            "Would show nothing here: the thermal camera reads the object, no sensor does.");
    case FaultEffect::NoneAlone:
        return FaultWords::tr("Would show nothing here: there is no other sensor to swap with.");
    case FaultEffect::NoneUnmarked:
        return FaultWords::tr("Would show nothing here: the source has no markers, and nothing follows it.");
    case FaultEffect::NoneUnused:
        return FaultWords::tr(
            "Would change no run here: no camera follows the source, and there is no thermal camera.");
    case FaultEffect::NoneHeatOff:
        return FaultWords::tr("Would show nothing now: the heat is off. Start a run or heat by hand first.");
    case FaultEffect::NoneHeatOn:
        return FaultWords::tr("Would show nothing now: the heat is on. Stop the run or switch it off first.");
    }
    return {};
}

} // namespace bask
