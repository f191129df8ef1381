#include "widgets/review/review_page.h"

#include "engine/recording/session_header.h"
#include "engine/recording/simulation_pace.h"
#include "widgets/common/belief_words.h"
#include "widgets/common/display.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/event_list.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/labels.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/run_label_words.h"
#include "widgets/common/scrolling.h"
#include "widgets/common/theme.h"
#include "widgets/review/final_values.h"
#include "widgets/review/identified_table.h"
#include "widgets/review/metrics_panel.h"
#include "widgets/review/outcome_words.h"
#include "widgets/review/replay_view.h"
#include "widgets/review/session_list.h"
#include "widgets/review/verification_words.h"

#include <QComboBox>
#include <QDateTime>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {

namespace {

constexpr int kListWidth = 430; // px: names of runs and three objects' metrics can be read in it
constexpr int kUsualWidth = 1190;

// In the order of the export button's menu.
constexpr std::array kForms{SessionForm::ReportPdf, SessionForm::ReportHtml,   SessionForm::Figures,
                            SessionForm::Csv,       SessionForm::CsvAllDigits, SessionForm::Nexus,
                            SessionForm::Vtk};

} // namespace

ReviewPage::ReviewPage(QWidget* parent) : QWidget(parent), m_sessions(new SessionList(this)) {
    setFocusPolicy(Qt::ClickFocus);
    auto* left = new QSplitter(Qt::Vertical, this);
    left->setChildrenCollapsible(false);
    left->addWidget(m_sessions);
    left->addWidget(buildDetails());
    left->setSizes({300, 260});
    auto* right = new QWidget(this);
    m_stack = new QStackedWidget(right);
    m_stack->addWidget(buildEmpty());
    m_stack->addWidget(buildRun());
    auto* whole = new QVBoxLayout(right);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(m_stack);
    m_altered = new MessageBar(right);
    m_altered->setObjectName("sessionAltered");
    m_sessions->message()->setParent(right); // beside the list: the row it is about stays in sight
    new FloatingPlace({m_altered, m_sessions->message()}, *right);
    m_splitter = new QSplitter(Qt::Horizontal, this);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(12);
    m_splitter->addWidget(left);
    m_splitter->addWidget(right);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->addWidget(m_splitter);
    for (QPushButton* button : {m_open, m_openEmpty})
        connect(button, &QPushButton::clicked, this, &ReviewPage::openRequested);
    connect(m_altered, &MessageBar::closed, this, [this] { m_isAlteredSeen = true; });
    connect(m_useIdentified, &QPushButton::clicked, this, &ReviewPage::useIdentifiedRequested);
    connect(m_useExperiment, &QPushButton::clicked, this, &ReviewPage::experimentRequested);
    connect(m_metrics, &MetricsPanel::detailsRequested, this, &ReviewPage::definitionsRequested);
    connect(m_events, &EventList::timeChosen, m_replay, &ReplayView::seek);
    connect(m_sessions, &SessionList::sessionsChanged, this, [this] {
        if (m_session)
            showOutcome();
    });
    showRun(false);
    refreshTexts();
}

ReviewPage::~ReviewPage() = default;

QWidget* ReviewPage::buildEmpty() {
    auto* box = new QWidget(this);
    m_emptyTitle = boldLabel(box, 1.4);
    m_emptyTitle->setAlignment(Qt::AlignCenter);
    m_emptyText = new QLabel(box);
    m_emptyText->setAlignment(Qt::AlignCenter);
    m_emptyText->setWordWrap(true);
    m_openEmpty = new QPushButton(box);
    m_openEmpty->setObjectName("openSessionEmpty");
    auto* layout = new QVBoxLayout(box);
    layout->setSpacing(12);
    layout->addStretch(1);
    layout->addWidget(m_emptyTitle);
    layout->addWidget(m_emptyText);
    layout->addWidget(m_openEmpty, 0, Qt::AlignHCenter);
    layout->addStretch(2);
    return box;
}

QWidget* ReviewPage::buildHeader(QWidget* parent) {
    auto* header = new QWidget(parent);
    m_file = new ElidedLabel(header);
    makeBold(m_file, 1.25);
    m_file->setObjectName("sessionFile");
    m_tag = boldLabel(header);
    m_tag->setObjectName("sessionTag");
    m_tag->setFrameShape(QFrame::Box);
    m_tag->setContentsMargins(6, 1, 6, 1);
    m_outcomeIcon = new QLabel(header);
    m_outcomeWord = new QLabel(header);
    m_outcomeWord->setObjectName("outcomeWord");
    m_open = new QPushButton(header);
    m_open->setObjectName("openSession");
    m_export = new QPushButton(header);
    m_export->setObjectName("exportSession");
    auto* forms = new QMenu(m_export);
    for (const SessionForm form : kForms)
        forms->addAction(QString(), this, [this, form] { emit exportRequested(form); });
    m_export->setMenu(forms);
    auto* title = new QHBoxLayout;
    title->setSpacing(10);
    title->addWidget(m_file);
    title->addWidget(m_tag);
    title->addWidget(m_outcomeIcon);
    title->addWidget(m_outcomeWord);
    title->addStretch(1);
    title->addWidget(m_open);
    title->addWidget(m_export);

    auto* layout = new QVBoxLayout(header);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(title);
    return header;
}

QWidget* ReviewPage::buildFacts(QWidget* parent) {
    auto* facts = new QWidget(parent);
    auto* form = new QFormLayout(facts);
    form->setContentsMargins(4, 8, 4, 4);
    const auto add = [&](Fact& fact, const char* name) {
        fact = {new QLabel(facts), new QLabel(facts)};
        fact.value->setObjectName(QString::fromLatin1(name));
        fact.value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        fact.value->setWordWrap(true);
        fact.caption->setBuddy(fact.value);
        form->addRow(fact.caption, fact.value);
    };
    add(m_outcome, "factOutcome");
    add(m_verification, "factVerification");
    add(m_duration, "factDuration");
    add(m_controller, "factController");
    add(m_shade, "factShade");
    add(m_belief, "factBelief");
    add(m_created, "factCreated");
    add(m_pace, "factPace");
    add(m_software, "factSoftware");
    m_useExperiment = new QPushButton(facts);
    m_useExperiment->setObjectName("useExperiment");
    form->addRow(m_useExperiment);
    return scrolled(facts);
}

QWidget* ReviewPage::buildIdentified(QWidget* parent) {
    auto* box = new QWidget(parent);
    box->setContentsMargins(0, 0, 4, 0);
    m_identifiedTitle = boldLabel(box);
    m_identified = new IdentifiedTable(box);
    m_identified->setObjectName("identifiedRates");
    m_lossesTitle = boldLabel(box);
    m_losses = new IdentifiedLosses(box);
    m_losses->setObjectName("identifiedLosses");
    m_identifiedNote = new QLabel(box);
    m_identifiedNote->setObjectName("identifiedNote");
    m_identifiedNote->setWordWrap(true);
    m_useIdentified = new QPushButton(box);
    m_useIdentified->setObjectName("useIdentified");
    m_useIdentified->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_useIdentified);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->addWidget(m_identifiedTitle);
    layout->addWidget(m_identified);
    layout->addLayout(row);
    layout->addWidget(m_identifiedNote);
    layout->addWidget(m_lossesTitle);
    layout->addWidget(m_losses);
    layout->addStretch(1);
    return scrolled(box);
}

/// A list to choose from, not tabs: in a narrow column their names have no room in every language.
QWidget* ReviewPage::buildDetails() {
    m_details = new QWidget(this);
    m_detail = new QComboBox(m_details);
    m_detail->setObjectName("reviewDetails");
    m_counting = new QLabel(m_details);
    m_counting->setObjectName("reviewCounting");
    m_counting->setWordWrap(true);
    m_counting->hide();
    auto* pages = new QStackedWidget(m_details);
    m_events = new EventList(pages);
    m_events->setObjectName("reviewEvents");
    m_events->setChosenByClick();
    m_metrics = new MetricsPanel(pages);
    auto* finals = new QWidget(pages);
    m_final = new FinalValuesTable(finals);
    m_final->setObjectName("finalValues");
    auto* column = new QVBoxLayout(finals);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_final);
    column->addStretch(1);
    for (QWidget* page : std::initializer_list<QWidget*>{m_metrics, m_events, finals, buildIdentified(pages),
                                                         buildFacts(pages)}) {
        pages->addWidget(page);
        m_detail->addItem(QString());
    }
    connect(m_detail, &QComboBox::currentIndexChanged, pages, &QStackedWidget::setCurrentIndex);
    auto* layout = new QVBoxLayout(m_details);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_detail);
    layout->addWidget(m_counting);
    layout->addWidget(pages, 1);
    return m_details;
}

QWidget* ReviewPage::buildRun() {
    auto* box = new QWidget(this);
    auto* header = buildHeader(box);
    m_replay = new ReplayView(box);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(header);
    layout->addWidget(m_replay, 1);
    return box;
}

void ReviewPage::setSession(std::shared_ptr<RecordedSession> session, const QStringList& eventSentences) {
    m_sentences = eventSentences;
    if (session == m_session)
        return showEvents();
    m_session = std::move(session);
    m_wasRecording =
        m_session && m_session->facts().interrupted() && m_sessions->isRecording(m_session->facts().path);
    m_identified->setRows({});
    m_losses->setRows({});
    m_useIdentified->setEnabled(false);
    m_identifiedNote->clear();
    m_identifying = true;
    m_counted_percent.reset();
    m_isCountFailed = m_isDamaged = false;
    m_verdict.reset();
    m_unverified.clear();
    m_shadeShare = std::numeric_limits<double>::quiet_NaN();
    m_final->setRun({}, {});
    m_metrics->clear();
    m_replay->setRun(m_session);
    m_sessions->setOpened(QString::fromStdString(m_session->facts().path));
    showEvents();
    refreshTexts();
    if (m_stack->currentIndex() == 0)
        showRun(true);
    setFocus(); // so that Space plays
}

/// Without a run the list has the room.
void ReviewPage::showRun(bool isOpen) {
    m_details->setVisible(isOpen);
    m_stack->setCurrentIndex(isOpen ? 1 : 0);
    const int whole = isVisible() ? m_splitter->width() : kUsualWidth; // it has none before
    const int list = std::max(36 * whole / 100, std::min(kListWidth, whole / 2));
    m_splitter->setSizes(isOpen ? QList<int>{list, whole - list} : QList<int>{720, 470});
}

void ReviewPage::setCounting(int percent) {
    m_counted_percent = percent;
    showCounting();
}

void ReviewPage::showCounting() {
    if (m_counted_percent)
        m_counting->setText(
            tr("Metrics, final values and heat rates are being computed from all samples: %1 %")
                .arg(*m_counted_percent));
    else
        m_counting->setText(
            tr("No metrics, final values and heat rates: the recording cannot be read to its end."));
    m_counting->setVisible(m_counted_percent || m_isCountFailed);
}

void ReviewPage::setMetrics(const RunMetrics& metrics) {
    const QStringList names = objectNames(*m_session);
    m_counted_percent.reset();
    showCounting();
    m_final->setRun(names, metrics);
    m_metrics->setMetrics(names, metrics);
    m_replay->setMetrics(QString::fromStdString(m_session->facts().path), &metrics);
}

void ReviewPage::setIdentified(const std::vector<IdentifiedRow>& rows) {
    m_identifying = false;
    m_identified->setRows(rows);
    m_losses->setRows(rows);
    QStringList notes, untold;
    for (const IdentifiedRow& row : rows) {
        if (!row.unusable.isEmpty())
            notes << QStringLiteral("%1: %2").arg(row.name, row.unusable);
        else if (!row.isAirApart)
            untold << row.name;
    }
    m_useIdentified->setEnabled(notes.size() < static_cast<qsizetype>(rows.size()));
    if (!untold.isEmpty())
        notes << tr("The record tells the losses of %1, but not what of them is radiated and what the air "
                    "takes. State the air on the Objects page, or record wider temperatures.")
                     .arg(QLocale().createSeparatedList(untold));
    m_identifiedNote->setText(notes.join(u'\n'));
}

void ReviewPage::setIdentificationFailed(const QString& sentence) {
    setIdentified({});
    m_identifiedNote->setText(sentence);
}

void ReviewPage::setCountFailed() {
    setIdentified({});
    m_counted_percent.reset();
    m_isCountFailed = true;
    if (m_session)
        m_replay->setMetrics(QString::fromStdString(m_session->facts().path), nullptr);
    showCounting();
}

void ReviewPage::setDamaged() {
    m_isDamaged = true;
    if (m_session)
        showOutcome();
}

void ReviewPage::setVerdict(const SessionVerdict& verdict) {
    m_verdict = verdict;
    if (m_session)
        showOutcome();
}

void ReviewPage::setVerificationFailed(const QString& sentence) {
    m_unverified = tr("Not verified: %1").arg(sentence);
    if (m_session)
        showVerification();
}

void ReviewPage::setShade(double share) {
    m_shadeShare = share;
    showShade();
}

void ReviewPage::showShade() {
    m_shade.value->setText(std::isnan(m_shadeShare) ? kNoValue
                           : m_shadeShare == 0.0
                               ? tr("No object shades another")
                               : tr("At most %1 % of an object's view factor is taken by the others")
                                     .arg(QLocale().toString(100.0 * m_shadeShare, 'f', 1)));
}

void ReviewPage::clear() {
    m_session.reset();
    m_sentences.clear();
    m_final->setRun({}, {});
    m_metrics->clear();
    m_events->clear();
    m_replay->clear();
    m_sessions->setOpened({});
    showRun(false);
}

void ReviewPage::setTemperatureUnit(TemperatureUnit unit) {
    m_sessions->setTemperatureUnit(unit);
    m_replay->setTemperatureUnit(unit);
    m_losses->setTemperatureUnit(unit);
    m_final->setTemperatureUnit(unit);
    m_metrics->setTemperatureUnit(unit);
}

void ReviewPage::showEvents() {
    struct Line {
        double time_s;
        QString text;
        EventKind kind;
    };
    std::vector<Line> lines;
    for (std::size_t i = 0; i < m_session->facts().events.size(); ++i) {
        const TraceEvent& event = m_session->facts().events[i];
        lines.push_back(
            {event.time_s, m_sentences.value(static_cast<qsizetype>(i)), eventKind(event.message.code)});
    }
    for (const TraceNote& note : m_session->facts().notes)
        lines.push_back({note.time_s, noteText(note), EventKind::Note});
    std::ranges::stable_sort(lines, {}, &Line::time_s);
    m_events->clear();
    for (const Line& line : lines)
        m_events->add(line.time_s, line.text, line.kind);
}

void ReviewPage::showOutcome() {
    const bool isDamaged = m_isDamaged || m_sessions->isDamaged(m_session->facts().path);
    const Outcome outcome = isDamaged        ? Outcome::Damaged
                            : isAlteredNow() ? Outcome::Altered
                            : m_wasRecording ? Outcome::Recording
                                             : outcomeOf(m_session->facts().outcome);
    m_outcomeIcon->setPixmap(
        outcomePixmap(outcome, isDark(this), 16, devicePixelRatioF(), endPriority(m_session->facts())));
    m_outcomeWord->setText(outcome == Outcome::Other ? QString::fromStdString(m_session->facts().outcome)
                                                     : outcomeWord(outcome));
    const QString labels = runLabelWords(m_session->facts().labels);
    const QString text = labels.isEmpty() ? outcomeText() : outcomeText() + u'\n' + labels;
    m_outcomeWord->setToolTip(text);
    m_outcome.value->setText(text);
    showVerification();
}

bool ReviewPage::isAlteredNow() const {
    return m_verdict && isAltered(*m_verdict);
}

void ReviewPage::showVerification() {
    const QString text = m_verdict                 ? verificationText(*m_verdict)
                         : !m_unverified.isEmpty() ? m_unverified
                                                   : tr("Being verified\u2026");
    m_verification.value->setText(text);
    m_verification.value->setToolTip(
        m_verdict && !m_verdict->head.empty() && !isAlteredNow()
            ? tr("Head of the hash chain: %1").arg(QString::fromStdString(m_verdict->head))
            : QString());
    if (!isAlteredNow()) {
        m_altered->clear();
        m_isAlteredSeen = false;
    } else if (!m_isAlteredSeen) {
        m_altered->say(MessageBar::Kind::Problem, text);
    }
}

QString ReviewPage::outcomeText() const {
    const std::string& outcome = m_session->facts().outcome;
    if (!m_wasRecording && isCutAfterStop(m_session->facts()))
        return cutAfterStopText();
    if (outcome == kOutcomeInterrupted)
        return tr(
            "Interrupted: the recording ended without a Stop, and was closed later. What had been written "
            "is here.");
    if (m_wasRecording)
        return tr("Opened while it was being recorded: open it again to see the rest.");
    if (m_session->facts().interrupted())
        return tr("Interrupted: the recording ended without a Stop. What had been written is here.");
    if (outcome == "settled")
        return tr("All objects settled");
    if (outcome == "not-settled")
        return tr("Not all objects settled");
    if (outcome == "stopped")
        return tr("Stopped"); // by whom is not recorded
    if (outcome == "emergency-stop")
        return tr("Ended by STOP");
    if (outcome == "fault")
        return tr("Ended by a fault");
    return QString::fromStdString(outcome);
}

void ReviewPage::showFact(const Fact& fact, const QString& text) {
    fact.value->setText(text);
    fact.caption->setVisible(!text.isEmpty());
    fact.value->setVisible(!text.isEmpty());
}

void ReviewPage::refreshTexts() {
    m_emptyTitle->setText(tr("No session open"));
    m_emptyText->setText(tr("Choose a recorded run in the list and press Enter, or open a file: its traces, "
                            "events and metrics are shown here, "
                            "and it can be played again."));
    m_emptyText->setPalette(captionPalette(palette()));
    for (QPushButton* button : {m_open, m_openEmpty})
        button->setText(tr("&Open session\u2026"));
    m_export->setText(tr("E&xport"));
    m_export->setToolTip(tr("Write this session as a report, as figures or for other programs"));
    const std::array<QString, kForms.size()> forms{tr("Report (&PDF)\u2026"),
                                                   tr("Report (&HTML)\u2026"),
                                                   tr("&Figures (PNG, SVG, PDF)\u2026"),
                                                   tr("Tables (&CSV)\u2026"),
                                                   tr("Tables with &all digits (CSV)\u2026"),
                                                   tr("&NeXus (HDF5)\u2026"),
                                                   tr("&VTK, for ParaView\u2026")};
    for (std::size_t k = 0; k < forms.size(); ++k)
        m_export->menu()->actions()[static_cast<qsizetype>(k)]->setText(forms[k]);
    const QString details[] = {tr("Metrics"), tr("Events and notes"), tr("Final values"), tr("Heat rates"),
                               tr("About the recording")};
    for (int i = 0; i < m_detail->count(); ++i)
        m_detail->setItemText(i, details[i]);
    nameChoice(m_detail, tr("What is known of the run"));
    m_identifiedTitle->setText(tr("Heat rates \u03bb\u2081 in K/s"));
    m_lossesTitle->setText(tr("Losses, of radiation and air"));
    m_useIdentified->setText(tr("Use as start values"));
    m_useIdentified->setToolTip(
        tr("Controllers of the open experiment start with the identified rates, in the "
           "objects of the same name and material under the same source."));
    m_useExperiment->setText(tr("Open as new experiment"));
    m_useExperiment->setToolTip(
        tr("Opens what was run here, objects, source, targets and limits as the recording has them, as a new "
           "experiment without a file."));
    if (m_identifying)
        m_identifiedNote->setText(tr("Fitting the heat balance to the record\u2026"));
    showCounting();
    const QPalette caption = captionPalette(palette());
    const std::initializer_list<std::pair<Fact, QString>> facts{{m_outcome, tr("Outcome")},
                                                                {m_verification, tr("Verification")},
                                                                {m_duration, tr("Duration")},
                                                                {m_controller, tr("Controller")},
                                                                {m_belief, tr("Heat rates at Start")},
                                                                {m_shade, tr("Shade")},
                                                                {m_created, tr("Recorded")},
                                                                {m_pace, tr("Simulation")},
                                                                {m_software, tr("Software")}};
    for (const auto& [fact, text] : facts) {
        fact.caption->setText(text);
        fact.caption->setPalette(caption);
    }
    if (!m_session)
        return;
    const QString path = QString::fromStdString(m_session->facts().path);
    m_file->setText(QFileInfo(path).fileName());
    m_file->setToolTip(path);
    m_tag->setText(m_session->facts().simulated ? tr("SIMULATED") : tr("LIVE"));
    showOutcome();
    showShade();
    m_duration.value->setText(durationText());
    m_controller.value->setText(controllerWord(m_session->facts().experiment.controller.kind));
    showFact(m_belief, wrongRatesText(m_session->facts().experiment));
    const auto pace =
        simulationPace(m_session->facts(), m_session->size() == 0 ? 0.0 : m_session->lastTime_s());
    showFact(m_pace, pace ? paceWords(*pace) : QString());
    const QDateTime created =
        QDateTime::fromString(QString::fromStdString(m_session->facts().created), Qt::ISODate);
    m_created.value->setText(created.isValid() ? formatDate(created)
                                               : QString::fromStdString(m_session->facts().created));
    m_software.value->setText(QString::fromStdString(m_session->facts().software));
}

/// The run's own, as in the list and in the metrics.
QString ReviewPage::durationText() const {
    if (m_session->size() == 0)
        return kNoValue;
    const double last_s = m_session->lastTime_s(), until_s = controlledUntil_s(m_session->facts());
    const QString run = formatDuration(std::isfinite(until_s) ? until_s : last_s);
    return until_s < last_s
               ? tr("%1, recorded until %2", "two times since Start").arg(run, formatDuration(last_s))
               : run;
}

void ReviewPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refreshTexts();
    QWidget::changeEvent(event);
}

/// What no widget on the page takes for itself.
void ReviewPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space || event->modifiers() != Qt::NoModifier)
        return QWidget::keyPressEvent(event);
    if (m_session)
        m_replay->togglePlay();
    else
        emit told(tr("There is nothing to play: no run is open. Choose one in the list."));
}

} // namespace bask
