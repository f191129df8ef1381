#pragma once
// The Review page: a list of recorded runs, one of them opened: its facts, replay, metrics, final values,
// events and notes.

#include "engine/base/units.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/run_metrics.h"
#include "engine/recording/session_verify.h"
#include "widgets/review/session_form.h"

#include <QWidget>

#include <limits>
#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;
class QStackedWidget;

namespace bask {

class EventList;
class FinalValuesTable;
class IdentifiedLosses;
class IdentifiedTable;
class MessageBar;
class MetricsPanel;
class ReplayView;
class SessionList;
struct IdentifiedRow;

/// Reading and exporting are the receiver's work. Object names for tests: "openSession", "openSessionEmpty",
/// "exportSession", "sessionTag", "sessionFile", "factCreated", "factDuration", "factController",
/// "factOutcome", "factVerification", "factShade", "factSoftware", "sessionAltered", "finalValues",
/// "identifiedRates", "identifiedLosses", "identifiedNote", "useIdentified", "useExperiment", "reviewEvents",
/// "reviewDetails" (which of these is shown), "reviewCounting", and those of SessionList, ReplayView and
/// MetricsPanel.
class ReviewPage : public QWidget {
    Q_OBJECT

public:
    explicit ReviewPage(QWidget* parent = nullptr);
    ~ReviewPage() override;

    /// Shows a run; `eventSentences` are its translated events, in their order. If the run is already shown,
    /// only its sentences are updated. Metrics, final values and heat rates need all samples of the run: the
    /// receiver computes them and sets them later.
    void setSession(std::shared_ptr<RecordedSession> session, const QStringList& eventSentences);
    /// Shows the progress of that work.
    void setCounting(int percent);
    void setMetrics(const RunMetrics& metrics);
    /// Sets the largest share of its view factor that an object lost to the others; 0: no object shades
    /// another; NaN: not known.
    void setShade(double share);
    /// Sets the heat rates, computed from the record by the receiver after setSession; until then the page
    /// shows that they are being computed.
    void setIdentified(const std::vector<IdentifiedRow>& rows);
    void setIdentificationFailed(const QString& sentence);
    /// None of the three is available: the recording cannot be read to its end.
    void setCountFailed();
    /// The file of the run is damaged: its header says so, as the list does.
    void setDamaged();
    /// Tells whether a run is as it was recorded; until then the page says that it is being looked at.
    void setVerdict(const SessionVerdict& verdict);
    void setVerificationFailed(const QString& sentence);
    void clear();
    void setTemperatureUnit(TemperatureUnit unit);

    SessionList* sessions() const { return m_sessions; }
    ReplayView* replay() const { return m_replay; }

signals:
    void openRequested();
    void exportRequested(bask::SessionForm form);
    /// The identified rates are requested as start values of the open experiment.
    void useIdentifiedRequested();
    /// The experiment of the open run is requested as a new one.
    void experimentRequested();
    /// The metrics' definitions were requested.
    void definitionsRequested();
    /// A sentence for the person, who pressed a key that does nothing now.
    void told(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Fact {
        QLabel* caption;
        QLabel* value;
    };
    QWidget* buildEmpty();
    QWidget* buildDetails();
    QWidget* buildRun();
    QWidget* buildHeader(QWidget* parent);
    QWidget* buildFacts(QWidget* parent);
    QWidget* buildIdentified(QWidget* parent);
    void showCounting();
    void showRun(bool isOpen);
    void showEvents();
    void refreshTexts();
    /// A fact that only some runs have.
    void showFact(const Fact& fact, const QString& text);
    void showOutcome();
    void showVerification();
    void showShade();
    bool isAlteredNow() const;
    QString durationText() const;
    QString outcomeText() const;

    std::shared_ptr<RecordedSession> m_session; ///< null if none is open
    bool m_wasRecording = false; ///< it was still being recorded when it was opened: its rest is missing
    bool m_isDamaged = false;    ///< found since it was opened
    std::optional<SessionVerdict> m_verdict;
    bool m_isAlteredSeen = false; ///< a person has closed what says so
    QString m_unverified;         ///< why there is no verdict
    double m_shadeShare = std::numeric_limits<double>::quiet_NaN();
    QStringList m_sentences;

    QSplitter* m_splitter;
    SessionList* m_sessions;
    QWidget* m_details;
    QComboBox* m_detail;
    QLabel* m_counting;
    QStackedWidget* m_stack;
    QLabel* m_emptyTitle;
    QLabel* m_emptyText;
    QPushButton* m_openEmpty;
    QLabel* m_file;
    QLabel* m_tag;
    QPushButton* m_open;
    QPushButton* m_export;
    Fact m_created, m_duration, m_controller, m_belief, m_pace, m_outcome, m_verification, m_shade,
        m_software;
    QLabel *m_outcomeIcon, *m_outcomeWord;
    MessageBar* m_altered;
    ReplayView* m_replay;
    MetricsPanel* m_metrics;
    FinalValuesTable* m_final;
    IdentifiedTable* m_identified;
    IdentifiedLosses* m_losses;
    QLabel* m_lossesTitle;
    QLabel* m_identifiedTitle;
    QLabel* m_identifiedNote;
    QPushButton *m_useIdentified, *m_useExperiment;
    bool m_identifying = false;
    std::optional<int> m_counted_percent; ///< progress while counting
    bool m_isCountFailed = false;
    EventList* m_events;
};

} // namespace bask
