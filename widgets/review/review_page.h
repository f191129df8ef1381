#pragma once
// The Review page: a recorded run opened again, with its facts, traces, final values, events and notes.

#include "engine/base/units.h"
#include "engine/session/session_file.h"
#include "widgets/review/session_form.h"

#include <QWidget>

#include <memory>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace bask {

class EventList;
class FinalValuesTable;
class IdentifiedTable;
struct IdentifiedRow;
class TracePlot;

/// Reading and exporting are the receiver's work. Object names for tests: "openSession", "openSessionEmpty",
/// "exportSession", "sessionTag", "sessionFile", "factCreated", "factDuration", "factController",
/// "factOutcome", "factSoftware", "reviewTemperature", "reviewError", "finalValues", "identifiedRates",
/// "identifiedNote", "useIdentified", "reviewEvents".
class ReviewPage : public QWidget {
    Q_OBJECT

public:
    explicit ReviewPage(QWidget* parent = nullptr);
    ~ReviewPage() override;

    /// Shows a run; `eventSentences` are its events translated, in their order.
    void setSession(const SessionRecord& session, const QStringList& eventSentences);
    /// Heat rates from the record, found by the receiver after setSession; until then they are said to be on
    /// their way.
    void setIdentified(const std::vector<IdentifiedRow>& rows);
    void setIdentificationFailed(const QString& sentence);
    void clear();
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    void openRequested();
    void exportRequested(bask::SessionForm form);
    /// The identified rates shall be start values of the open experiment.
    void useIdentifiedRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Fact {
        QLabel* caption;
        QLabel* value;
    };
    QWidget* buildEmpty();
    QWidget* buildRun();
    QWidget* buildHeader(QWidget* parent);
    Fact addFact(QWidget* parent, const char* name);
    QWidget* buildIdentified(QWidget* parent);
    void showTraces();
    void showEvents();
    void refreshTexts();
    QString outcomeText() const;

    std::unique_ptr<SessionRecord> m_session; ///< null: none open
    QStringList m_sentences;

    QStackedWidget* m_stack;
    QLabel* m_emptyTitle;
    QLabel* m_emptyText;
    QPushButton* m_openEmpty;
    QLabel* m_file;
    QLabel* m_tag;
    QPushButton* m_open;
    QPushButton* m_export;
    Fact m_created, m_duration, m_controller, m_outcome, m_software;
    QLabel* m_temperatureTitle;
    QLabel* m_errorTitle;
    QLabel* m_finalTitle;
    QLabel* m_eventsTitle;
    TracePlot* m_temperature;
    TracePlot* m_error;
    FinalValuesTable* m_final;
    QLabel* m_identifiedTitle;
    IdentifiedTable* m_identified;
    QLabel* m_identifiedNote;
    QPushButton* m_useIdentified;
    bool m_identifying = false;
    EventList* m_events;
};

} // namespace bask
