#pragma once
// The six pages with the bars that float over them, connected to the document and the engine.

#include "app/desktop_files.h"
#include "app/document.h"
#include "app/page.h"
#include "app/page_messages.h"
#include "app/review_desk.h"
#include "app/run_forecast.h"
#include "app/target_judge.h"
#include "engine/base/units.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"
#include "engine/thermography/thermal_view.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

class QStackedWidget;

namespace bask {

class CalibratePage;
class CountdownBar;
class FloatingPlace;
class MessageBar;
class ObjectsPage;
class ReviewPage;
class RigPage;
class RunPage;
class TargetsPage;

/// Edits go to the document, which accepts or refuses them; changes for the engine are sent as commandIssued.
/// Object names: "pages", "messageBar", "cutOffBar", "recipeBar", "questionBar", "coachBar", "countdownBar".
class PageHost : public QWidget {
    Q_OBJECT

public:
    PageHost(Document& document, SessionActions& files, QWidget* parent = nullptr);

    /// The minimum of the pages, which scroll: bars lie over them and need no space of the screen.
    QSize minimumSizeHint() const override;

    void show(Page page);
    /// The Review page with the alarms of its runs.
    void showAllAlarms();
    Page page() const;
    void apply(const Snapshot& snapshot);
    void show(const VisionView& view);
    void show(const ThermalView& view);
    void setTemperatureUnit(TemperatureUnit unit);
    void showMoment(double time_s);
    /// Shows the page of an undone or redone edit, unless a run is on: then the page does not change.
    void showUndone(const EditStep& step);
    void showRedone(const EditStep& step);
    /// Opens any file that Bask reads, as after a drop, or says why it cannot.
    void takeFile(const QString& path);

    PageMessages& messages() { return m_messages; }
    void showProblem(const QString& sentence) { m_messages.showProblem(sentence); }
    void showNote(const QString& sentence) { m_messages.showBriefly(sentence); }
    /// With buttons that open what was written, or its folder.
    void showExported(const QString& sentence, const QStringList& files);

    /// Bars that float over the pages, for what waits for an answer.
    MessageBar& cutOffBar() { return *m_cutOff; }
    MessageBar& recipeBar() { return *m_recipe; }
    MessageBar& questionBar() { return *m_question; }
    MessageBar& coachBar() { return *m_coach; }
    /// What opens exported files.
    DesktopFiles& desktop() { return m_desktop; }
    const TargetJudge& judge() const { return m_judge; }
    RunForecast& forecast() { return m_forecast; }
    ObjectsPage* objects() const { return m_objects; }
    RunPage* run() const { return m_run; }
    ReviewPage* review() const { return m_review; }

signals:
    void commandIssued(const bask::Command& command);
    void homeRequested(); ///< the window asks first
    void pageChanged(bask::Page page);
    /// A short word for the foot of the window.
    void toldAside(const QString& sentence);
    /// Opens a page of the manual, such as "manual.md#review".
    void manualRequested(const QString& page);

protected:
    void changeEvent(QEvent* event) override;

private:
    void connectRig();
    void connectObjects();
    void connectCalibrate();
    void connectDocument();
    void connectJudge();
    void connectForecast();
    void connectReview();
    void connectExports();
    void reportInfeasible();
    void keepPrediction(const Snapshot& snapshot);
    void showDocument();
    void showEditable();
    void watchThermal();
    void askConfirm(std::size_t object);
    void showStep(const EditStep& step, const QString& words);

    Document& m_document;
    TargetJudge m_judge;
    RunForecast m_forecast;
    SessionActions& m_files;
    CountdownBar* m_countdown;
    MessageBar *m_cutOff, *m_recipe, *m_question, *m_coach, *m_bar;
    FloatingPlace* m_place; ///< of the bars
    QStackedWidget* m_pages;
    RigPage* m_rig;
    ObjectsPage* m_objects;
    CalibratePage* m_calibrate;
    TargetsPage* m_targets;
    RunPage* m_run;
    ReviewPage* m_review;
    ReviewDesk m_reviewDesk;
    PageMessages m_messages;

    DesktopFiles m_desktop;
    QStringList m_exported;       ///< files of the message that offers to open them
    std::vector<double> m_told_K; ///< newest reading of each sensor, trusted or not
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isThermalOnRun = false; ///< that page shows its pictures
    WatchThermalCamera m_thermalOnCalibrate;
    bool m_editable = true;
    bool m_targetsEditable = true;
    /// The run whose prediction was sent to the engine last, and whether with its band.
    std::pair<std::uint64_t, bool> m_keptPrediction{};
    bool m_verdictUntold = false; ///< the engine has targets whose verdict it has not been sent
};

} // namespace bask
