#pragma once
// The Review page: a recorded run opened again, with its facts, traces, final values, events and notes.

#include "engine/base/units.h"
#include "engine/session/session_file.h"

#include <QWidget>

#include <memory>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace bask {

class EventList;
class FinalValuesTable;
class TracePlot;

/// Reading and exporting are the receiver's work. Object names for tests: "openSession", "openSessionEmpty",
/// "exportSession", "sessionTag", "sessionFile", "factCreated", "factDuration", "factController",
/// "factOutcome", "factSoftware", "reviewTemperature", "reviewError", "finalValues", "reviewEvents".
class ReviewPage : public QWidget {
    Q_OBJECT

public:
    explicit ReviewPage(QWidget* parent = nullptr);
    ~ReviewPage() override;

    /// Shows a run; `eventSentences` are its events translated, in their order.
    void setSession(const SessionRecord& session, const QStringList& eventSentences);
    void clear();
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    void openRequested();
    void exportRequested();

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
    EventList* m_events;
};

} // namespace bask
