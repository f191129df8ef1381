#include "app/review_desk.h"

#include "app/data_folder.h"
#include "app/error_text.h"
#include "engine/base/message_code.h"
#include "engine/experiment/unrecorded_alarms.h"
#include "engine/radiation/mounted_objects.h"
#include "widgets/review/comparison_view.h"
#include "widgets/review/identified_table.h"
#include "widgets/review/replay_view.h"
#include "widgets/review/review_page.h"
#include "widgets/review/session_list.h"
#include "widgets/review/verification_words.h"

#include <QFileInfo>
#include <QShortcut>

#include <utility>

namespace bask {

ReviewDesk::ReviewDesk(ReviewPage& page, Document& document, SessionActions& files, QObject* parent)
    : QObject(parent), m_page(page), m_document(document), m_files(files), m_library(*page.sessions()),
      m_overlayCount(*page.replay()),
      m_alarms(*page.sessions(), unrecordedAlarmFile(alarmFile().toStdString())) {
    connectList();
    connectCount();
    connectVerification();
    connect(&m_page, &ReviewPage::openRequested, &m_files, &SessionActions::askAndOpenSession);
    connect(&m_page, &ReviewPage::exportRequested, &m_files, &SessionActions::exportSession);
    connect(m_page.replay()->comparison(), &ComparisonView::exportRequested, &m_files,
            &SessionActions::exportComparison);
    connect(&m_page, &ReviewPage::useIdentifiedRequested, this, &ReviewDesk::useIdentified);
    connect(&m_page, &ReviewPage::experimentRequested, this, [this] {
        if (m_session)
            m_files.openAsNew(m_session->facts());
    });
    connect(&m_page, &ReviewPage::told, this, &ReviewDesk::told);
    auto* refresh = new QShortcut(Qt::Key_F5, &m_page); // Arm's on the other pages
    refresh->setObjectName(QStringLiteral("refreshRuns"));
    refresh->setAutoRepeat(false);
    connect(refresh, &QShortcut::activated, this, &ReviewDesk::refreshList);
    connect(&m_files, &SessionActions::sessionOpened, this, &ReviewDesk::open);
}

void ReviewDesk::open(std::shared_ptr<RecordedSession> session, std::optional<double> at_s) {
    m_session = std::move(session);
    m_numbers.reset();
    m_isDamageTold = false;
    emit opening();
    showSession();
    if (at_s)
        m_page.replay()->seek(*at_s);
    m_count.start(*m_session);
    m_verification.start(QString::fromStdString(m_session->facts().path));
    emit opened();
    const QStringList over = std::exchange(m_comparedOver, {});
    if (isOpen(m_comparedPath))
        for (const QString& path : over)
            m_library.readOverlay(path);
}

bool ReviewDesk::isOpen(const QString& path) const {
    return m_session && QString::fromStdString(m_session->facts().path) == path;
}

void ReviewDesk::showList() {
    m_library.setFolder(m_files.sessionFolder());
}

void ReviewDesk::refreshList() {
    disconnect(m_onceRefreshed);
    m_onceRefreshed = connect(
        m_page.sessions(), &SessionList::sessionsChanged, this,
        [this] { emit toldAside(tr("List of runs is up to date")); }, Qt::SingleShotConnection);
    showList();
}

void ReviewDesk::showAlarmsOnceListed() {
    forgetAlarms();
    m_onceListed = connect(m_page.sessions(), &SessionList::sessionsChanged, &m_alarms,
                           &AlarmHistoryControl::open, Qt::SingleShotConnection);
}

void ReviewDesk::forgetAlarms() {
    disconnect(m_onceListed);
}

void ReviewDesk::setRecording(const QString& path) {
    if (path == m_recording)
        return;
    m_recording = path;
    m_page.sessions()->setRecording(path);
    pauseLibrary();
    if (m_page.isVisible())
        m_library.refresh();
}

/// A run, and the open recording, come before those that are only listed.
void ReviewDesk::pauseLibrary() {
    m_library.setPaused(!m_recording.isEmpty() || m_verification.isBusy());
}

void ReviewDesk::retranslate() {
    showSession();
    m_alarms.retranslate(); // its sentences have temperatures, too
}

/// The list of runs; reading them is the library's work.
void ReviewDesk::connectList() {
    SessionList* list = m_page.sessions();
    connect(list, &SessionList::sessionChosen, &m_files, &SessionActions::open);
    connect(list, &SessionList::comparisonRequested, this,
            [this](const QString& path, const QStringList& over) {
                m_comparedPath = path;
                m_comparedOver = over;
                m_files.open(path);
            });
    connect(&m_alarms, &AlarmHistoryControl::runChosen, this,
            [this](const QString& path, double raised_s) { m_files.openSession(path, raised_s); });
    connect(&m_alarms, &AlarmHistoryControl::readFailed, &m_library, &SessionLibrary::takeDamage);
    connect(list, &SessionList::experimentRequested, &m_files,
            qOverload<const QString&>(&SessionActions::openAsNew));
    list->setSorting(m_files.sessionSorting());
    connect(list, &SessionList::sortingChanged, &m_files, &SessionActions::setSessionSorting);
    connect(list, &SessionList::folderRequested, this, [this] {
        if (const QString folder = m_files.askSessionFolder(); !folder.isEmpty())
            m_library.setFolder(folder);
    });
    connect(&m_library, &SessionLibrary::problem, this, &ReviewDesk::problem);
    connect(&m_library, &SessionLibrary::closing, this, [this](const QString& path) {
        m_overlayCount.release(path);
        m_verification.release(path);
        if (!isOpen(path))
            return;
        m_count.stop();
        m_page.replay()->pause();
    });
    connect(&m_library, &SessionLibrary::closed, this, [this](const QString& path, bool isDone) {
        m_overlayCount.resume();
        if (isDone)
            emit told(tr("%1 was closed properly: its outcome is \"interrupted\" now.")
                          .arg(QFileInfo(path).fileName()));
        if (m_page.replay()->isOver(path))
            m_verification.add(path);
        if (!isOpen(path))
            return;
        if (isDone)
            m_files.open(path);
        else {
            m_verification.add(path);
            if (!m_numbers)
                m_count.start(*m_session);
        }
    });
    connect(&m_library, &SessionLibrary::overlayRead, this,
            [this](const std::shared_ptr<RecordedSession>& session) {
                if (m_page.replay()->addOverlay(session))
                    m_verification.add(QString::fromStdString(session->facts().path));
                else
                    emit told(tr(
                        "It is shown already, or there are %n runs over the open one: take one away first.",
                        nullptr, ReplayView::kMaxOverlays));
            });
    connect(&m_page, &ReviewPage::definitionsRequested, this,
            [this] { emit manualRequested(QStringLiteral("manual.md#metrics")); });
}

/// Metrics and heat rates of the open run; damage of its file is told once, whoever finds it.
void ReviewDesk::connectCount() {
    const auto tellDamage = [this](const Error& error) {
        if (error.code() == MessageCode::SessionDamaged)
            m_page.setDamaged();
        if (std::exchange(m_isDamageTold, true))
            return;
        m_library.takeDamage(error);
        emit problem(sentence(error));
    };
    connect(&m_count, &SessionCount::progressed, &m_page, &ReviewPage::setCounting);
    connect(&m_count, &SessionCount::failed, this, [this, tellDamage](const Error& error) {
        m_page.setCountFailed();
        tellDamage(error);
    });
    connect(&m_count, &SessionCount::counted, this,
            [this](const std::shared_ptr<const SessionNumbers>& numbers) {
                m_numbers = numbers;
                m_page.setMetrics(numbers->metrics);
                m_page.setShade(numbers->shade < kMinToldShare ? 0.0 : numbers->shade);
                m_page.replay()->setWay(numbers->way);
                showIdentified();
            });
    connect(m_page.replay(), &ReplayView::readFailed, this, tellDamage);
    connect(&m_overlayCount, &OverlayCount::failed, this, [this](const Error& error) {
        m_library.takeDamage(error);
        emit problem(sentence(error));
    });
}

/// Whether the open run, and what is laid over it, is as it was recorded.
void ReviewDesk::connectVerification() {
    connect(&m_verification, &SessionVerification::verified, this,
            [this](const QString& path, const SessionVerdict& verdict) {
                m_library.takeVerdict(path, verdict);
                if (!isOpen(path)) {
                    if (isAltered(verdict))
                        emit problem(QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(),
                                                                  verificationText(verdict)));
                    return;
                }
                if (verdict.isDamaged)
                    m_page.setDamaged();
                m_page.setVerdict(verdict);
            });
    connect(&m_verification, &SessionVerification::busyChanged, this, &ReviewDesk::pauseLibrary);
    connect(&m_verification, &SessionVerification::failed, this,
            [this](const QString& path, const Error& error) {
                if (isOpen(path))
                    m_page.setVerificationFailed(sentence(error));
            });
}

void ReviewDesk::showSession() {
    if (!m_session)
        return;
    QStringList sentences;
    for (const TraceEvent& event : m_session->facts().events)
        sentences << sentence(event.message);
    m_page.setSession(m_session, sentences);
    showIdentified();
}

void ReviewDesk::showIdentified() {
    if (!m_numbers)
        return;
    const Result<SessionRates>& rates = m_numbers->rates;
    if (!rates)
        return m_page.setIdentificationFailed(sentence(rates.error()));
    const std::vector<ObjectSample>& first = m_numbers->metrics.first.objects;
    const std::vector<ObjectSample>& last = m_numbers->metrics.last.objects;
    std::vector<IdentifiedRow> rows;
    for (std::size_t i = 0; i < rates->identified.size(); ++i) {
        const IdentifiedRates& fit = rates->identified[i];
        IdentifiedRow row;
        row.name = QString::fromStdString(m_session->facts().experiment.objects[i].name);
        row.lambda1 = {fit.lambda1.value, fit.lambda1.standardError};
        row.lambda2 = {fit.lambda2.value, fit.lambda2.standardError};
        row.lambda3 = {fit.lambda3.value, fit.lambda3.standardError};
        row.material = rates->material[i].lambda1;
        if (i < last.size()) {
            row.begun = first[i].lambda1;
            row.controller = last[i].lambda1;
        }
        if (!fit.usable())
            row.unusable = sentence(fit.reason);
        row.isAirApart = fit.caveat == Message{};
        const IdentifiedRates& withAir = rates->withAir[i];
        row.working_K = withAir.workingTemperature_K;
        row.loss = {withAir.loss.value, withAir.loss.standardError};
        row.lossSlope = {withAir.lossSlope.value, withAir.lossSlope.standardError};
        const Estimate h = convection_W_m2K(withAir, m_session->facts().experiment, i);
        row.convection = {h.value, h.standardError};
        if (!withAir.usable())
            row.hUntold = sentence(withAir.reason);
        rows.push_back(std::move(row));
    }
    m_page.setIdentified(rows);
}

void ReviewDesk::useIdentified() {
    if (!m_editable)
        return emit problem(tr("A run is armed or on. Objects can be changed once it has stopped."));
    if (!m_numbers || !m_numbers->rates)
        return;
    const StartValues start =
        withStartValues(m_document.experiment(), m_session->facts().experiment, *m_numbers->rates);
    if (start.objects.empty())
        return emit problem(
            tr("No object of the open experiment has the name and material of one of this run "
               "under the same source and environment."));
    if (const auto edited = m_document.edit(start.experiment); !edited)
        return emit problem(sentence(edited.error()));
    QStringList names;
    for (const std::string& name : start.objects)
        names << QString::fromStdString(name);
    emit told(tr("Start values taken from this run: %1").arg(names.join(QStringLiteral(", "))));
}

} // namespace bask
