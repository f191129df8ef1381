#pragma once
// The six pages with the message bar over them, wired to the document and the engine.

#include "app/document.h"
#include "app/page.h"
#include "app/session_actions.h"
#include "app/session_count.h"
#include "app/session_library.h"
#include "app/target_judge.h"
#include "engine/base/units.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <memory>
#include <optional>

class QStackedWidget;

namespace bask {

class CalibratePage;
class CountdownBar;
class MessageBar;
class ObjectsPage;
class ReviewPage;
class RigPage;
class RunPage;
class TargetsPage;

/// Edits go to the document, which refuses or takes them; what the engine must know goes out as
/// commandIssued. Object names: "pages", "messageBar", "cutOffBar", "questionBar",
/// "coachBar".
class PageHost : public QWidget {
    Q_OBJECT

public:
    PageHost(Document& document, SessionActions& files, QWidget* parent = nullptr);

    /// The pages', which are scrolled: bars take their room from them, not from the screen.
    QSize minimumSizeHint() const override;

    void show(Page page);
    Page page() const;
    void apply(const Snapshot& snapshot);
    void show(const VisionView& view);
    void setTemperatureUnit(TemperatureUnit unit);
    void showMoment(double time_s);
    /// Where an edit was undone or redone: its page, unless a run is on, which is not taken from view.
    void showUndone(const EditStep& step);
    void showRedone(const EditStep& step);
    /// Opens any file that Bask reads, as after a drop, or says why not.
    void takeFile(const QString& path);

    /// A sentence over the pages, until it is closed.
    void showProblem(const QString& sentence);
    void showRefusal(const QString& sentence); ///< gone with the next edit
    /// The engine's: gone with the next edit or command, and with the state or the reason that it is about.
    void showRefusal(const QString& sentence, const Snapshot& snapshot, const Message& refusal);
    void dropRefusal(); ///< of the engine or of a verb: something else was asked for
    /// Gone as soon as `keepWhile` says something else, or nothing.
    void showWhile(const QString& sentence);
    /// Changes or clears what `showWhile` has said. False: it is shown no more.
    bool keepWhile(const QString& sentence);
    void showNote(const QString& sentence);

    /// Over all, for what waits for an answer.
    MessageBar& cutOffBar() { return *m_cutOff; }
    MessageBar& recipeBar() { return *m_recipe; }
    MessageBar& questionBar() { return *m_question; }
    MessageBar& coachBar() { return *m_coach; }
    const TargetJudge& judge() const { return m_judge; }
    ObjectsPage* objects() const { return m_objects; }
    RunPage* run() const { return m_run; }
    ReviewPage* review() const { return m_review; }

signals:
    void commandIssued(const bask::Command& command);
    void pageChanged(bask::Page page);
    /// "manual.md#review"
    void manualRequested(const QString& page);

protected:
    void changeEvent(QEvent* event) override;

private:
    void connectRig();
    void connectObjects();
    void connectCalibrate();
    void connectDocument();
    void connectJudge();
    void connectReview();
    void reportInfeasible();
    void showDocument();
    void showSession();
    void connectCount();
    void showIdentified();
    void useIdentified();
    void showEditable();
    void askConfirm(std::size_t object);
    void showStep(const EditStep& step, const QString& words);

    Document& m_document;
    TargetJudge m_judge;
    SessionActions& m_files;
    CountdownBar* m_countdown;
    MessageBar *m_cutOff, *m_recipe, *m_question, *m_coach, *m_bar;
    QStackedWidget* m_pages;
    RigPage* m_rig;
    ObjectsPage* m_objects;
    CalibratePage* m_calibrate;
    TargetsPage* m_targets;
    RunPage* m_run;
    ReviewPage* m_review;
    SessionLibrary m_library;
    void keepRefusal(const Snapshot& snapshot);

    QString m_ofEdit;      ///< said last of the newest edit
    QString m_ofMoment;    ///< said for as long as it is so
    QString m_refusalSaid; ///< the engine's last one
    Message m_refusal;
    bool m_isOfReason = false; ///< it is one of the reasons for the state
    RunState m_refusedIn = RunState::Idle;
    std::vector<double> m_told_K; ///< newest reading of each sensor, believed or not
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QString m_recording; ///< the file that is being recorded into
    std::shared_ptr<RecordedSession> m_session;
    std::shared_ptr<const SessionNumbers> m_numbers; ///< of m_session; null: on their way, or not to be had
    bool m_isDamageTold = false;                     ///< of m_session
    bool m_editable = true;
    bool m_targetsEditable = true;
    bool m_verdictUntold = false; ///< the engine has targets whose verdict it was not told
    SessionCount m_count;
};

} // namespace bask
