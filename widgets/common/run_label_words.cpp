#include "widgets/common/run_label_words.h"

#include "engine/recording/simulation_pace.h"
#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QStringList>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::RunLabelWords)
};

} // namespace

QString runLabelWords(const RunLabels& labels) {
    QStringList words;
    const auto add = [&](const QString& sentence, const std::string& value) {
        if (!value.empty())
            words << sentence.arg(QString::fromStdString(value));
    };
    add(Words::tr("operator %1"), labels.operatorName);
    add(Words::tr("sample %1"), labels.sample);
    add(Words::tr("batch %1"), labels.batch);
    QString all = words.join(Words::tr(", ", "between operator, sample and batch"));
    if (!all.isEmpty())
        all[0] = all[0].toUpper();
    return all;
}

QString noteText(const TraceNote& note) {
    const QString text = QString::fromStdString(note.text);
    return note.operatorName.empty() ? text
                                     : Words::tr("%1 (%2)", "note, its operator")
                                           .arg(text, QString::fromStdString(note.operatorName));
}

QString cutAfterStopText() {
    return Words::tr("The run had been stopped; what followed is not recorded to its end.");
}

QString paceWords(const SimulationPace& pace) {
    return Words::tr("Faster than real time: %1 (min:s) of the simulated rig in %2 by the clock")
        .arg(formatDuration(pace.run_s), formatDuration(pace.clock_s));
}

} // namespace bask
