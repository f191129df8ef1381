#include "widgets/review/review_page.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/event_list.h"
#include "widgets/common/labels.h"
#include "widgets/common/theme.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/review/final_values.h"
#include "widgets/review/identified_table.h"

#include <QDateTime>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace bask {
namespace {

// In the order of the export button's menu.
constexpr std::array kForms{SessionForm::ReportPdf, SessionForm::ReportHtml, SessionForm::Figures,
                            SessionForm::Csv,       SessionForm::Nexus,      SessionForm::Vtk};

bool isMarked(MessageCode code) {
    switch (code) {
    case MessageCode::EventHeld:
    case MessageCode::EventResumed:
    case MessageCode::EventSettled:
    case MessageCode::EventTargetsChanged:
    case MessageCode::EventGainsChanged:
        return true;
    default:
        return alarmPriority(code) > 0;
    }
}

} // namespace

ReviewPage::ReviewPage(QWidget* parent) : QWidget(parent), m_stack(new QStackedWidget(this)) {
    m_stack->addWidget(buildEmpty());
    m_stack->addWidget(buildRun());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_stack);
    for (QPushButton* button : {m_open, m_openEmpty})
        connect(button, &QPushButton::clicked, this, &ReviewPage::openRequested);
    connect(m_useIdentified, &QPushButton::clicked, this, &ReviewPage::useIdentifiedRequested);
    connect(m_temperature, &TracePlot::timeRangeChosen, m_error, &TracePlot::setTimeRange);
    connect(m_error, &TracePlot::timeRangeChosen, m_temperature, &TracePlot::setTimeRange);
    connect(m_events, &EventList::timeChosen, this, [this](double time_s) {
        const double half_s =
            std::max(0.5 * (m_temperature->visibleTo_s() - m_temperature->visibleFrom_s()), 1.0);
        for (TracePlot* plot : {m_temperature, m_error})
            plot->setTimeRange(time_s - half_s, time_s + half_s);
    });
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

ReviewPage::Fact ReviewPage::addFact(QWidget* parent, const char* name) {
    auto* box = new QVBoxLayout;
    box->setSpacing(1);
    Fact fact{new QLabel(parent), new QLabel(parent)};
    fact.value->setObjectName(QString::fromLatin1(name));
    fact.value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    fact.value->setWordWrap(true);
    fact.caption->setBuddy(fact.value);
    box->addWidget(fact.caption);
    box->addWidget(fact.value);
    box->addStretch(1);
    static_cast<QHBoxLayout*>(parent->layout())->addLayout(box, 1);
    return fact;
}

QWidget* ReviewPage::buildHeader(QWidget* parent) {
    auto* header = new QWidget(parent);
    m_file = boldLabel(header, 1.25);
    m_file->setObjectName("sessionFile");
    m_file->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_tag = boldLabel(header);
    m_tag->setObjectName("sessionTag");
    m_tag->setFrameShape(QFrame::Box);
    m_tag->setContentsMargins(6, 1, 6, 1);
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
    title->addStretch(1);
    title->addWidget(m_open);
    title->addWidget(m_export);

    auto* facts = new QWidget(header);
    auto* row = new QHBoxLayout(facts);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(18);
    m_outcome = addFact(facts, "factOutcome");
    row->setStretch(0, 2);
    m_duration = addFact(facts, "factDuration");
    m_controller = addFact(facts, "factController");
    m_created = addFact(facts, "factCreated");
    m_software = addFact(facts, "factSoftware");

    auto* layout = new QVBoxLayout(header);
    layout->setContentsMargins(0, 0, 0, 4);
    layout->setSpacing(8);
    layout->addLayout(title);
    layout->addWidget(facts);
    return header;
}

QWidget* ReviewPage::buildIdentified(QWidget* parent) {
    auto* box = new QWidget(parent);
    m_identifiedTitle = boldLabel(box);
    m_identified = new IdentifiedTable(box);
    m_identified->setObjectName("identifiedRates");
    m_identifiedNote = new QLabel(box);
    m_identifiedNote->setObjectName("identifiedNote");
    m_identifiedNote->setWordWrap(true);
    m_useIdentified = new QPushButton(box);
    m_useIdentified->setObjectName("useIdentified");
    m_useIdentified->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->addWidget(m_identifiedNote, 1);
    row->addWidget(m_useIdentified, 0, Qt::AlignTop);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_identifiedTitle);
    layout->addWidget(m_identified);
    layout->addLayout(row);
    return box;
}

QWidget* ReviewPage::buildRun() {
    auto* box = new QWidget(this);
    auto* plots = new QWidget(box);
    m_temperatureTitle = boldLabel(plots);
    m_errorTitle = boldLabel(plots);
    m_temperature = new TracePlot(Quantity::Temperature, plots);
    m_temperature->setObjectName("reviewTemperature");
    m_error = new TracePlot(Quantity::Error, plots);
    m_error->setObjectName("reviewError");
    m_error->setMarkerTextsVisible(false);
    auto* left = new QVBoxLayout(plots);
    left->setContentsMargins(0, 0, 6, 0);
    left->addWidget(m_temperatureTitle);
    left->addWidget(m_temperature, 3);
    left->addWidget(m_errorTitle);
    left->addWidget(m_error, 2);

    auto* tables = new QWidget(box);
    m_finalTitle = boldLabel(tables);
    m_eventsTitle = boldLabel(tables);
    m_final = new FinalValuesTable(tables);
    m_final->setObjectName("finalValues");
    m_events = new EventList(tables);
    m_events->setObjectName("reviewEvents");
    auto* right = new QVBoxLayout(tables);
    right->setContentsMargins(6, 0, 0, 0);
    right->addWidget(m_finalTitle);
    right->addWidget(m_final);
    right->addWidget(buildIdentified(tables));
    right->addWidget(m_eventsTitle);
    right->addWidget(m_events, 1);
    tables->setMinimumWidth(420);

    auto* splitter = new QSplitter(Qt::Horizontal, box);
    splitter->addWidget(plots);
    splitter->addWidget(tables);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({620, 520});
    splitter->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(14, 12, 14, 12);
    layout->addWidget(buildHeader(box));
    layout->addWidget(splitter, 1);
    return box;
}

void ReviewPage::setSession(const SessionRecord& session, const QStringList& eventSentences) {
    m_session = std::make_unique<SessionRecord>(session);
    m_sentences = eventSentences;
    m_final->setValues(finalValues(session));
    m_identified->setRows({});
    m_useIdentified->setEnabled(false);
    m_identifiedNote->clear();
    m_identifying = true;
    showTraces();
    showEvents();
    refreshTexts();
    m_stack->setCurrentIndex(1);
}

void ReviewPage::setIdentified(const std::vector<IdentifiedRow>& rows) {
    m_identifying = false;
    m_identified->setRows(rows);
    QStringList notes;
    for (const IdentifiedRow& row : rows)
        if (!row.unusable.isEmpty())
            notes << QStringLiteral("%1: %2").arg(row.name, row.unusable);
    m_identifiedNote->setText(notes.join(u'\n'));
    m_useIdentified->setEnabled(notes.size() < static_cast<qsizetype>(rows.size()));
}

void ReviewPage::setIdentificationFailed(const QString& sentence) {
    setIdentified({});
    m_identifiedNote->setText(sentence);
}

void ReviewPage::clear() {
    m_session.reset();
    m_sentences.clear();
    m_final->setValues({});
    m_events->clear();
    for (TracePlot* plot : {m_temperature, m_error})
        plot->clear();
    m_stack->setCurrentIndex(0);
}

void ReviewPage::setTemperatureUnit(TemperatureUnit unit) {
    m_temperature->setTemperatureUnit(unit);
    m_error->setTemperatureUnit(unit);
    m_final->setTemperatureUnit(unit);
}

void ReviewPage::showTraces() {
    QStringList names;
    for (const ObjectSpec& object : m_session->experiment.objects)
        names << QString::fromStdString(object.name);
    for (TracePlot* plot : {m_temperature, m_error}) {
        plot->setObjects(names);
        plot->clearMarkers();
        plot->setSamples(m_session->samples);
        for (std::size_t i = 0; i < m_session->events.size(); ++i)
            if (isMarked(m_session->events[i].message.code))
                plot->addMarker(m_session->events[i].time_s, m_sentences.value(static_cast<qsizetype>(i)));
        for (const TraceNote& note : m_session->notes)
            plot->addMarker(note.time_s, QString::fromStdString(note.text));
    }
}

void ReviewPage::showEvents() {
    struct Line {
        double time_s;
        QString text;
        EventKind kind;
    };
    std::vector<Line> lines;
    for (std::size_t i = 0; i < m_session->events.size(); ++i) {
        const TraceEvent& event = m_session->events[i];
        lines.push_back(
            {event.time_s, m_sentences.value(static_cast<qsizetype>(i)), eventKind(event.message.code)});
    }
    for (const TraceNote& note : m_session->notes)
        lines.push_back({note.time_s, QString::fromStdString(note.text), EventKind::Note});
    std::ranges::stable_sort(lines, {}, &Line::time_s);
    m_events->clear();
    for (const Line& line : lines)
        m_events->add(line.time_s, line.text, line.kind);
}

QString ReviewPage::outcomeText() const {
    const std::string& outcome = m_session->outcome;
    if (m_session->interrupted())
        return tr("Interrupted: the recording ended without a Stop. What had been written is here.");
    if (outcome == "settled")
        return tr("All objects settled");
    if (outcome == "not-settled")
        return tr("Not all objects settled");
    if (outcome == "stopped")
        return tr("Stopped by the operator");
    if (outcome == "fault")
        return tr("Ended by a fault");
    return QString::fromStdString(outcome);
}

void ReviewPage::refreshTexts() {
    m_emptyTitle->setText(tr("No session open"));
    m_emptyText->setText(tr("Open a recorded run to see its traces, events and final errors."));
    m_emptyText->setPalette(captionPalette(palette()));
    for (QPushButton* button : {m_open, m_openEmpty})
        button->setText(tr("&Open session\u2026"));
    m_export->setText(tr("E&xport"));
    m_export->setToolTip(tr("Write this session as a report, as figures or for other programs"));
    const std::array<QString, kForms.size()> forms{
        tr("Report (&PDF)\u2026"), tr("Report (&HTML)\u2026"), tr("&Figures (PNG, SVG, PDF)\u2026"),
        tr("Tables (&CSV)\u2026"), tr("&NeXus (HDF5)\u2026"),  tr("&VTK, for ParaView\u2026")};
    for (std::size_t k = 0; k < forms.size(); ++k)
        m_export->menu()->actions()[static_cast<qsizetype>(k)]->setText(forms[k]);
    m_temperatureTitle->setText(tr("Temperature"));
    m_errorTitle->setText(tr("Error"));
    m_finalTitle->setText(tr("Final values"));
    m_eventsTitle->setText(tr("Events and notes"));
    m_identifiedTitle->setText(tr("Heat rates \u03bb\u2081 in K/s"));
    m_useIdentified->setText(tr("Use as start values"));
    m_useIdentified->setToolTip(
        tr("Controllers of the open experiment start with the identified rates, in the "
           "objects of the same name and material under the same source."));
    if (m_identifying)
        m_identifiedNote->setText(tr("Fitting the heat balance to the record\u2026"));
    m_temperature->setAccessibleName(tr("Temperatures of the run"));
    m_error->setAccessibleName(tr("Errors of the run"));
    const QPalette caption = captionPalette(palette());
    const std::initializer_list<std::pair<Fact, QString>> facts{{m_outcome, tr("Outcome")},
                                                                {m_duration, tr("Duration")},
                                                                {m_controller, tr("Controller")},
                                                                {m_created, tr("Recorded")},
                                                                {m_software, tr("Software")}};
    for (const auto& [fact, text] : facts) {
        fact.caption->setText(text);
        fact.caption->setPalette(caption);
        fact.value->setAccessibleName(text);
    }
    if (!m_session)
        return;
    const QString path = QString::fromStdString(m_session->path);
    m_file->setText(QFileInfo(path).fileName());
    m_file->setToolTip(path);
    m_tag->setText(m_session->simulated ? tr("SIMULATED") : tr("LIVE"));
    m_outcome.value->setText(outcomeText());
    m_duration.value->setText(m_session->samples.empty() ? kNoValue
                                                         : formatDuration(m_session->samples.back().time_s));
    m_controller.value->setText(controllerWord(m_session->experiment.controller.kind));
    const QDateTime created = QDateTime::fromString(QString::fromStdString(m_session->created), Qt::ISODate);
    m_created.value->setText(created.isValid()
                                 ? QLocale().toString(created.toLocalTime(), QLocale::ShortFormat)
                                 : QString::fromStdString(m_session->created));
    m_software.value->setText(QString::fromStdString(m_session->software));
}

void ReviewPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refreshTexts();
    QWidget::changeEvent(event);
}

} // namespace bask
