#include "widgets/rig/unit_finder.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include <algorithm>

namespace bask {
namespace {

constexpr int kRows = 4, kUnit = Qt::UserRole, kProfile = Qt::UserRole + 1;

QString lineText(const SerialSettings& line) {
    return QStringLiteral("%1 %2%3%4")
        .arg(line.baud)
        .arg(line.dataBits)
        .arg(QLatin1Char(line.parity))
        .arg(line.stopBits);
}

} // namespace

UnitFinder::UnitFinder(QWidget* parent)
    : QWidget(parent), m_find(new QPushButton(this)), m_progress(new QLabel(this)),
      m_found(new QListWidget(this)) {
    m_find->setObjectName("findUnits");
    m_find->setAutoDefault(false);
    m_progress->setObjectName("findProgress");
    m_progress->setWordWrap(true);
    m_found->setObjectName("foundUnits");
    m_found->setFixedHeight(kRows * (fontMetrics().height() + 4) + 4);
    m_found->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // its tooltip has all of it
    m_found->hide();
    auto* top = new QHBoxLayout;
    top->addWidget(m_find, 0, Qt::AlignTop);
    top->addWidget(m_progress, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(top);
    layout->addWidget(m_found);
    connect(m_find, &QPushButton::clicked, this, [this] {
        if (isOn()) {
            reset();
            emit stopWanted();
            return;
        }
        reset();
        m_isAsked = true;
        emit findWanted();
        retranslate();
    });
    connect(m_found, &QListWidget::itemClicked, this, &UnitFinder::choose);
    connect(m_found, &QListWidget::itemActivated, this, &UnitFinder::choose);
    retranslate();
}

void UnitFinder::setProfiles(const std::vector<std::pair<std::string, std::string>>& profiles) {
    m_profiles = profiles;
}

void UnitFinder::reset() {
    m_isAsked = false;
    m_state = {};
    list();
    retranslate();
}

bool UnitFinder::setState(const ModbusSearchState& state) {
    if (!m_isAsked || m_state.isOver)
        return false;
    const bool wasListed = m_found->count() > 0;
    const bool isNew = state.found != m_state.found || state.isOver != m_state.isOver;
    m_state = state;
    if (isNew)
        list();
    retranslate();
    return wasListed != (m_found->count() > 0);
}

/// A row for each unit and profile. While the search is on, the last unit may still be incomplete.
void UnitFinder::list() {
    const QListWidgetItem* const current = m_found->currentItem();
    const QVariant unit = current == nullptr ? QVariant() : current->data(kUnit);
    const QVariant profile = current == nullptr ? QVariant() : current->data(kProfile);
    const QSignalBlocker blocker(m_found);
    m_found->clear();
    for (const FoundUnit& found : m_state.found) {
        if (!m_state.isOver && found.unit == m_state.unit)
            continue;
        bool isAnyShown = false;
        for (const ProfileFit& fit : found.fits) {
            const auto known =
                std::ranges::find(m_profiles, fit.profile, &std::pair<std::string, std::string>::first);
            if (known == m_profiles.end())
                continue;
            QStringList temperatures;
            for (const double t_K : fit.temperatures_K)
                temperatures << formatTemperature(t_K, m_unit);
            auto* item = new QListWidgetItem(
                tr("Unit %1: %2 (%3)")
                    .arg(found.unit)
                    .arg(QString::fromStdString(known->second), temperatures.join(listSeparator())),
                m_found);
            item->setData(kUnit, found.unit);
            item->setData(kProfile, QString::fromStdString(fit.profile));
            item->setToolTip(item->text());
            isAnyShown = true;
            if (item->data(kUnit) == unit && item->data(kProfile) == profile)
                m_found->setCurrentItem(item);
        }
        if (!isAnyShown) {
            auto* item = new QListWidgetItem(
                tr("Unit %1 answers, but no profile of this role fits").arg(found.unit), m_found);
            item->setFlags(Qt::NoItemFlags);
        }
    }
    m_found->setVisible(m_found->count() > 0);
}

void UnitFinder::choose(const QListWidgetItem* item) {
    if (item->data(kProfile).isValid())
        emit chosen(item->data(kUnit).toInt(), item->data(kProfile).toString(), m_state.line);
}

void UnitFinder::retranslate() {
    m_find->setText(isOn() ? tr("Stop") : tr("Find devices"));
    m_find->setToolTip(tr("Asks units 1 to 16 at this port. Nothing is written."));
    m_found->setAccessibleName(tr("Devices found at this port"));
    if (!m_isAsked)
        m_progress->clear();
    else if (m_state.problem.code != MessageCode::None)
        m_progress->setText(sentenceText(m_state.problem));
    else if (!m_state.isOver)
        m_progress->setText(tr("%1 %, unit %2, %3")
                                .arg(static_cast<int>(100.0 * m_state.progress))
                                .arg(m_state.unit)
                                .arg(lineText(m_state.line)));
    else
        m_progress->setText(m_state.found.empty() ? tr("No unit from 1 to 16 answers.") : tr("Choose one:"));
}

void UnitFinder::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    list();
    retranslate();
}

} // namespace bask
