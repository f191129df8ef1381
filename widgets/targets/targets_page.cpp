#include "widgets/targets/targets_page.h"

#include "widgets/common/display.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/folding_splitter.h"
#include "widgets/common/labels.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"
#include "widgets/common/verdict_words.h"
#include "widgets/targets/pairs_view.h"
#include "widgets/targets/reach_bar.h"
#include "widgets/targets/surfaces_view.h"

#include <QCheckBox>
#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bask {
namespace {

constexpr int kRowHeight = 44;
constexpr int kMinTableWidth = 620;
constexpr int kLinesPerRow = 4; // of the grid: a rule, the target, its bar, words
constexpr int kColumns = 6;
constexpr int kVerdictLines = 2; // or more; rows would move under the hand with each line that comes or goes
constexpr double kSameTarget_K = 1e-6;

QLabel* wrapped(QWidget* parent, const char* name = nullptr) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText); // names are the user's
    if (name != nullptr)
        label->setObjectName(QString::fromLatin1(name));
    return label;
}

QFrame* horizontalLine(QWidget* parent) {
    auto* line = new QFrame(parent);
    line->setObjectName("rowLine");
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Plain);
    return line;
}

} // namespace

struct TargetsPage::Row {
    QLabel* swatch;
    QLabel* name;
    QuantitySpinBox* target;
    ReachBar* bar;
    QLabel* icon;
    QLabel* word;
    QLabel* detail;
    QPushButton* nearest;
    QCheckBox* keep;
};

TargetsPage::TargetsPage(QWidget* parent)
    : QWidget(parent), m_title(new QLabel(this)), m_note(wrapped(this, "targetsNote")),
      m_jointIcon(new QLabel(this)), m_joint(wrapped(this, "jointVerdict")),
      m_jointDetail(wrapped(this, "jointDetail")), m_useNearest(new QPushButton(this)),
      m_explanationTitle(new QLabel(this)), m_explanation(wrapped(this)), m_infeasibleTitle(new QLabel(this)),
      m_infeasible(wrapped(this, "infeasibleNote")) {
    makeBold(m_title, 1.25);
    makeBold(m_explanationTitle);
    makeBold(m_infeasibleTitle);

    m_useNearest->setObjectName("useNearest");
    QSizePolicy room = m_useNearest->sizePolicy();
    room.setRetainSizeWhenHidden(true);
    m_useNearest->setSizePolicy(room);
    makeBold(m_joint);
    m_joint->setProperty(kKeptFree_px, kWholeWidget_px);
    m_joint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    connect(m_useNearest, &QPushButton::clicked, this, &TargetsPage::useNearestTogether);
    auto* title = new QHBoxLayout;
    title->addWidget(m_title, 1);
    title->addWidget(m_useNearest);
    auto* joint = new QHBoxLayout;
    joint->setSpacing(10);
    joint->addWidget(m_jointIcon, 0, Qt::AlignTop);
    joint->addWidget(m_joint, 1);
    auto* head = new QVBoxLayout;
    head->setContentsMargins(18, 14, 18, 0);
    head->addLayout(title);
    head->addLayout(joint);
    auto* words = new QGridLayout;
    words->setHorizontalSpacing(32);
    words->addWidget(m_explanationTitle, 0, 0);
    words->addWidget(m_infeasibleTitle, 0, 1);
    words->addWidget(m_explanation, 1, 0, Qt::AlignTop);
    words->addWidget(m_infeasible, 1, 1, Qt::AlignTop);
    words->setColumnStretch(0, 1);
    words->setColumnStretch(1, 1);

    auto* content = new QWidget(this);
    m_table = new QWidget(content);
    m_table->setProperty(kKeptFree_px, kWholeWidget_px); // the verdicts, also those in words below them
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(18, 0, 18, 14);
    layout->setSpacing(12);
    layout->addWidget(m_note);
    layout->addWidget(m_table);
    layout->addWidget(m_jointDetail);
    layout->addSpacing(10);
    layout->addLayout(words);
    layout->addStretch(1);

    auto* scroll = new QScrollArea(this);
    scroll->setObjectName("targetRows");
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setMinimumWidth(kMinTableWidth);
    auto* left = new QWidget(this);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(head);
    column->addWidget(scroll, 1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    m_surfaces = new SurfacesView(this);
    m_pairs = new PairsView(this);
    m_views = new QTabWidget(this);
    m_views->setObjectName("targetViews");
    m_views->setDocumentMode(true);
    m_views->addTab(m_surfaces, QString());
    m_views->addTab(m_pairs, QString());
    auto* splitter = new FoldingSplitter(this);
    splitter->addWidget(left);
    splitter->addWidget(m_views);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({650, 530});
    outer->addWidget(splitter);
    connect(m_surfaces, &SurfacesView::startWanted, this, &TargetsPage::startWanted);
    connect(m_surfaces, &SurfacesView::problem, this, &TargetsPage::problem);
    connect(m_pairs, &PairsView::targetsDragged, this, &TargetsPage::dragPair);
    connect(m_pairs, &PairsView::targetsPicked, this,
            [this](int first, int second, double first_K, double second_K) {
                dragPair(first, second, first_K, second_K);
                commit();
            });
    connect(m_pairs, &PairsView::dragDropped, this, &TargetsPage::triesDropped);
    connect(m_pairs, &PairsView::wanted, this, &TargetsPage::pairsWanted);
    connect(m_pairs, &PairsView::problem, this, &TargetsPage::problem);
    connect(m_pairs, &PairsView::exported, this, &TargetsPage::exported);
    connect(m_surfaces, &SurfacesView::exported, this, &TargetsPage::exported);
    buildRows();
}

TargetsPage::~TargetsPage() = default;

void TargetsPage::buildRows() {
    for (QWidget* old : m_table->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        delete old;
    delete m_grid;
    m_rows.clear();
    m_headers.clear();
    m_grid = new QGridLayout(m_table);
    m_grid->setContentsMargins(0, 4, 0, 0);
    m_grid->setHorizontalSpacing(10);
    m_grid->setVerticalSpacing(0);
    for (const int column : {1, 2, 3}) {
        m_headers.push_back(new QLabel(m_table));
        m_grid->addWidget(m_headers.back(), 0, column);
    }
    m_grid->setColumnStretch(3, 1);
    m_grid->setColumnMinimumWidth(1, 120);
    for (std::size_t i = 0; i < m_experiment.objects.size(); ++i)
        addRow(static_cast<int>(i));
    m_grid->addWidget(horizontalLine(m_table), kLinesPerRow * static_cast<int>(m_rows.size()) + 1, 0, 1,
                      kColumns);
    m_table->setVisible(!m_rows.empty());
    showAll();
}

void TargetsPage::addRow(int index) {
    const auto row = static_cast<std::size_t>(index);
    const auto named = [index](QWidget* widget, const char* name) {
        widget->setObjectName(QString::fromLatin1(name) + QString::number(index));
    };
    Row made{new QLabel(m_table),   new QLabel(m_table),      new QuantitySpinBox(m_table),
             new ReachBar(m_table), new QLabel(m_table),      new QLabel(m_table),
             wrapped(m_table),      new QPushButton(m_table), new QCheckBox(m_table)};
    named(made.target, "target");
    named(made.bar, "reach");
    named(made.word, "verdict");
    named(made.detail, "verdictDetail");
    named(made.nearest, "nearest");
    named(made.keep, "keep");
    made.name->setTextFormat(Qt::PlainText);
    makeBold(made.name, 1.1);
    makeBold(made.word);
    QFont large = made.target->font();
    large.setPointSizeF(large.pointSizeF() * 1.2);
    made.target->setFont(large);
    made.target->setFocusPolicy(Qt::StrongFocus);
    made.bar->setSeries(index);
    made.name->setBuddy(made.target);
    made.target->setRange_K(kelvinFromCelsius(kMinTemperature_degC), kelvinFromCelsius(kMaxTemperature_degC));
    connect(made.target, &QuantitySpinBox::valueTyped_K, this,
            [this, row](double target_K) { tryTarget(row, target_K); });
    connect(made.target, &QuantitySpinBox::valueEdited_K, this,
            [this, row](double target_K) { editTarget(row, target_K); });
    connect(made.bar, &ReachBar::targetDragged, this,
            [this, row](double target_K) { tryTarget(row, target_K); });
    connect(made.bar, &ReachBar::targetDropped, this, &TargetsPage::commit);
    connect(made.bar, &ReachBar::dragDropped, this, &TargetsPage::triesDropped);
    connect(made.keep, &QCheckBox::toggled, this, [this] {
        m_stale = true;
        showAll();
        emit keptChanged(kept());
    });
    connect(made.nearest, &QPushButton::clicked, this, [this, row] { useNearest(row); });

    auto* verdict = new QHBoxLayout;
    verdict->setSpacing(8);
    verdict->addWidget(made.icon);
    verdict->addWidget(made.word, 1);

    const int line = kLinesPerRow * index + 1;
    m_grid->addWidget(horizontalLine(m_table), line, 0, 1, kColumns);
    m_grid->addWidget(made.swatch, line + 1, 0);
    m_grid->addWidget(made.name, line + 1, 1);
    m_grid->addWidget(made.target, line + 1, 2);
    m_grid->addLayout(verdict, line + 1, 3);
    m_grid->addWidget(made.nearest, line + 1, 4);
    m_grid->addWidget(made.keep, line + 1, 5);
    m_grid->addWidget(made.bar, line + 2, 1, 1, kColumns - 1);
    m_grid->addWidget(made.detail, line + 3, 1, 1, kColumns - 1);
    m_grid->setRowMinimumHeight(line + 1, kRowHeight);
    m_rows.push_back(made);
}

void TargetsPage::setExperiment(const Experiment& experiment) {
    const bool sameRows = experiment.objects.size() == m_rows.size();
    m_experiment = experiment;
    m_given_K = targets_K();
    m_surfaces->setExperiment(experiment);
    if (sameRows) {
        showAll();
        return;
    }
    m_verdict.reset();
    buildRows();
    emit keptChanged(kept());
}

void TargetsPage::setVerdict(const JointVerdict& verdict, const std::vector<MountingRemark>& shade) {
    m_shade = shade;
    m_verdict.reset();
    if (verdict.conditions1.size() == m_rows.size())
        m_verdict = verdict;
    if (m_verdict) {
        m_surfaces->setExperiment(m_experiment); // whose targets may have been typed here
        m_surfaces->setVerdict(verdict);
    }
    m_stale = false;
    m_prediction_s.reset();
    showAll();
    askPrediction();
}

void TargetsPage::setPrediction(const std::optional<double>& settling_s) {
    m_prediction_s = settling_s;
    showJoint();
}

void TargetsPage::dropPrediction() {
    m_prediction_s.reset();
    showJoint();
    askPrediction();
}

void TargetsPage::askPrediction() {
    if (isVisible() && m_verdict && m_verdict->feasible && !m_stale && !m_prediction_s)
        emit predictionWanted();
}

void TargetsPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    askPrediction();
}

void TargetsPage::setStale(bool stale) {
    m_stale = stale;
    m_surfaces->setStale(stale);
    showAll();
}

void TargetsPage::setPairs(const std::vector<ReachableMap>& maps) {
    m_pairs->setMaps(maps);
}

void TargetsPage::setEditable(bool editable, const QString& why) {
    m_editable = editable;
    m_why = why;
    m_pairs->setEditable(editable);
    showAll();
}

void TargetsPage::setStartable(bool startable, const QString& why) {
    m_surfaces->setStartable(startable, why);
}

void TargetsPage::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_surfaces->setTemperatureUnit(unit);
    m_pairs->setTemperatureUnit(unit);
    showAll();
}

std::vector<double> TargetsPage::targets_K() const {
    std::vector<double> targets_K;
    for (const ObjectSpec& object : m_experiment.objects)
        targets_K.push_back(object.target_K);
    return targets_K;
}

std::vector<bool> TargetsPage::kept() const {
    std::vector<bool> kept;
    for (const Row& row : m_rows)
        kept.push_back(row.keep->isChecked());
    return kept;
}

void TargetsPage::clearKept() {
    for (const Row& row : m_rows) {
        const QSignalBlocker quiet(row.keep);
        row.keep->setChecked(false);
    }
    emit keptChanged(kept());
}

void TargetsPage::editTarget(std::size_t row, double target_K) {
    if (row >= m_experiment.objects.size())
        return;
    m_experiment.objects[row].target_K = target_K;
    commit();
}

/// The verdict follows every step; the experiment is edited by commit().
void TargetsPage::tryTarget(std::size_t row, double target_K) {
    if (row >= m_experiment.objects.size() || m_experiment.objects[row].target_K == target_K)
        return;
    m_experiment.objects[row].target_K = target_K;
    showAll();
    emit targetsTried(targets_K());
}

void TargetsPage::commit() {
    showAll();
    if (targets_K() == m_given_K)
        return;
    m_given_K = targets_K();
    emit targetsEdited(m_given_K);
}

void TargetsPage::useNearest(std::size_t row) {
    if (m_verdict && row < m_verdict->conditions1.size())
        editTarget(row, nearestReachable_K(m_verdict->conditions1[row], m_unit));
}

void TargetsPage::useNearestTogether() {
    if (!m_verdict || m_verdict->nearest_K.size() != m_rows.size())
        return;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        m_experiment.objects[i].target_K = m_verdict->nearest_K[i];
    commit();
}

void TargetsPage::dragPair(int first, int second, double first_K, double second_K) {
    m_experiment.objects[static_cast<std::size_t>(first)].target_K = first_K;
    m_experiment.objects[static_cast<std::size_t>(second)].target_K = second_K;
    showAll();
    emit targetsTried(targets_K());
}

bool TargetsPage::rowStale(std::size_t row) const {
    return m_stale || !m_verdict ||
           std::abs(m_verdict->conditions1[row].target_K - m_experiment.objects[row].target_K) >
               kSameTarget_K;
}

void TargetsPage::showRow(std::size_t i) {
    Row& row = m_rows[i];
    const ObjectSpec& object = m_experiment.objects[i];
    const QString name = QString::fromStdString(object.name);
    const bool dark = isDark(this);
    const bool stale = rowStale(i);
    const bool known = m_verdict.has_value();
    const TargetVerdict own = known ? m_verdict->conditions1[i] : TargetVerdict{};
    row.swatch->setPixmap(seriesSwatch(static_cast<int>(i), dark, {26, 14}, devicePixelRatioF()));
    row.name->setText(name);
    row.target->setTemperatureUnit(m_unit);
    row.target->setValue_K(object.target_K);
    row.target->setEnabled(m_editable);
    row.target->setToolTip(m_editable ? QString() : m_why);
    row.target->setAccessibleName(tr("Target of %1").arg(name));
    row.bar->setTemperatureUnit(m_unit);
    row.bar->setTarget_K(object.target_K);
    row.bar->setVerdict(known ? std::optional(own) : std::nullopt);
    row.bar->setStale(stale);
    row.bar->setEditable(m_editable);

    const FeasibilityVerdict verdict = known ? verdictHere(own) : FeasibilityVerdict::Reachable;
    const bool bad = !stale && verdict != FeasibilityVerdict::Reachable;
    row.icon->setVisible(bad);
    row.icon->setPixmap(alarmPixmap(3, dark, 18, devicePixelRatioF()));
    const bool alone = !bad && known && !m_verdict->feasible && m_rows.size() > 1;
    row.word->setText(stale ? tr("Checking\u2026") : alone ? tr("Reachable alone") : verdictWord(verdict));
    row.word->setEnabled(!stale);
    row.detail->setText(stale ? QString() : verdictDetail(own, m_experiment.environment_K, m_unit));
    row.detail->setPalette(captionPalette(palette()));
    row.nearest->setText(tr("Nearest reachable"));
    row.nearest->setAccessibleName(tr("Set the target of %1 to the nearest reachable one").arg(name));
    row.nearest->setEnabled(bad && m_editable);
    row.nearest->setToolTip(
        bad ? tr("Set the target to %1").arg(formatTemperature(nearestReachable_K(own, m_unit), m_unit))
            : tr("The target is within reach already."));
    row.keep->setText(tr("Keep"));
    row.keep->setAccessibleName(tr("Keep the target of %1").arg(name));
    row.keep->setToolTip(tr("Leave this target as it is when the nearest ones are sought."));
    row.keep->setVisible(m_rows.size() > 1);
}

void TargetsPage::showAxis() {
    double low_K = m_experiment.environment_K;
    double high_K = low_K + 50.0;
    for (std::size_t i = 0; m_verdict && i < m_rows.size(); ++i) {
        const TargetVerdict& own = m_verdict->conditions1[i];
        low_K = std::min(low_K, own.lowest_K);
        high_K = i == 0 ? own.highest_K : std::max(high_K, own.highest_K);
    }
    const double margin_K = 0.12 * (high_K - low_K);
    for (Row& row : m_rows)
        row.bar->setAxis_K(low_K - margin_K, high_K + margin_K);
}

QString TargetsPage::objectName(std::size_t row) const {
    return QString::fromStdString(m_experiment.objects[row].name);
}

void TargetsPage::showJoint() {
    bool stale = false;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        stale = stale || rowStale(i);
    const bool bad = !m_rows.empty() && !stale && !m_verdict->feasible;
    const auto fit = checkTargets(m_experiment);
    m_joint->setMinimumHeight(
        std::max(stale ? m_joint->height() : 0, kVerdictLines * m_joint->fontMetrics().lineSpacing()));
    m_jointIcon->setVisible(bad || (!stale && !fit));
    m_jointIcon->setPixmap(alarmPixmap(3, isDark(this), 18, devicePixelRatioF()));
    if (m_rows.empty())
        m_joint->setText(tr("There is no object yet. Add one on the Objects page."));
    else if (stale)
        m_joint->setText(tr("Checking the targets\u2026"));
    else if (bad)
        m_joint->setText(tr("Cannot be held: %1.").arg(messageText(m_verdict->reason, m_unit)));
    else if (!fit)
        m_joint->setText(sentenceText(fit.error().message, m_unit));
    else
        m_joint->setText(m_rows.size() == 1 ? tr("The target can be held.")
                                            : tr("All targets can be held together."));
    m_joint->setEnabled(!stale);
    QString detail = stale || m_rows.empty() ? QString() : jointDetail();
    if (!detail.isEmpty() && m_verdict->caveat != Message{})
        detail += QLatin1Char('\n') + sentenceText(m_verdict->caveat, m_unit);
    if (!detail.isEmpty())
        for (const MountingRemark& remark : m_shade)
            detail += QStringLiteral("\n\u2022 ") + messageText(remark.message, m_unit);
    if (!detail.isEmpty() && m_shade.empty() && m_rows.size() > 1)
        detail += QLatin1Char('\n') + tr("No object shades another at this pose.");
    m_jointDetail->setText(detail);
    m_jointDetail->setPalette(captionPalette(palette()));
    m_useNearest->setText(tr("Use nearest feasible"));
    m_useNearest->setVisible(bad && !m_verdict->nearest_K.empty());
    const bool kept = !bad || m_verdict->fixedKept;
    m_useNearest->setEnabled(m_editable && kept);
    m_useNearest->setToolTip(
        kept ? QString()
             : tr("The targets to be kept cannot be held together: untick \u201cKeep\u201d for one."));
}

QString TargetsPage::jointDetail() const {
    const JointVerdict& verdict = *m_verdict;
    if (!verdict.anyPose)
        return {};
    if (verdict.feasible)
        return tr("Held at %1; %2 from the nearest limit: %3.")
                   .arg(poseText(verdict.pose, m_experiment.robot), marginText(verdict.margin),
                        limitWord(verdict.margin)) +
               QLatin1Char('\n') + predictionText();
    QStringList residuals, nearest;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        residuals << QStringLiteral("%1 %2").arg(objectName(i),
                                                 formatDifference(verdict.residuals_K[i], m_unit));
        nearest << QStringLiteral("%1 %2").arg(objectName(i),
                                               formatTemperature(verdict.nearest_K[i], m_unit));
    }
    const QString separator = tr(", ", "between names");
    QString text = tr("Best compromise, at %1: %2.")
                       .arg(poseText(verdict.pose, m_experiment.robot), residuals.join(separator));
    text += QLatin1Char('\n') + tr("Nearest targets that can be held: %1.").arg(nearest.join(separator));
    if (!verdict.fixedKept)
        text += QLatin1Char(' ') + tr("Those to be kept cannot be held together.");
    return text;
}

QString TargetsPage::predictionText() const {
    if (!m_prediction_s)
        return tr("Predicting how long a run takes\u2026");
    if (!*m_prediction_s)
        return tr("Predicted: a run from the start pose does not settle within %1 (simulated).")
            .arg(formatDuration(m_experiment.simulation.durationLimit_s));
    return tr("Predicted: a run from the start pose has settled after %1 (simulated).")
        .arg(formatDuration(**m_prediction_s));
}

void TargetsPage::showAll() {
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        showRow(i);
    m_pairs->setExperiment(m_experiment);
    showAxis();
    showJoint();
    refreshTexts();
}

void TargetsPage::refreshTexts() {
    const QPalette caption = captionPalette(palette());
    QPalette lines = palette();
    lines.setColor(QPalette::WindowText, hairline(isDark(this)));
    for (QFrame* line : m_table->findChildren<QFrame*>(QStringLiteral("rowLine")))
        line->setPalette(lines);
    m_views->setTabText(0, tr("Surfaces"));
    m_views->setTabText(1, tr("Pairs"));
    m_title->setText(tr("Targets"));
    m_note->setText(m_why);
    m_note->setVisible(!m_editable && !m_why.isEmpty());
    const std::array<QString, 3> headers{tr("Object"), tr("Target"), tr("Verdict")};
    for (std::size_t i = 0; i < m_headers.size(); ++i) {
        m_headers[i]->setText(headers.at(i));
        m_headers[i]->setPalette(caption);
        m_headers[i]->setVisible(!m_rows.empty());
    }
    m_explanationTitle->setText(tr("What is checked"));
    m_explanation->setText(
        tr("To stay at its target an object must take up as much heat as it gives off. That fixes its view "
           "factor F, the share of its sight that the source fills: near 0 far away, near 1 close to the "
           "source and facing it. A target is reachable if its F occurs somewhere in the robot's workspace "
           "with the clearance kept; all can be held together if one pose has the F of each. In the bars, "
           "solid is what can be held here, outlined what the source could hold at F = 1."));
    m_infeasibleTitle->setText(tr("Starting out of reach"));
    m_infeasible->setText(
        tr("A run with a target out of reach needs your explicit agreement at Start. It "
           "holds the best compromise it "
           "finds, says so, and the session records that you agreed. During a run new targets "
           "are taken at once; if they cannot be held, an event says why."));
    m_explanation->setPalette(caption);
    m_infeasible->setPalette(caption);
}

void TargetsPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showAll();
    QWidget::changeEvent(event);
}

} // namespace bask
