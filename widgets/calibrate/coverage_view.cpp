#include "widgets/calibrate/coverage_view.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr std::array kNames{"coverageX", "coverageY", "coverageSize", "coverageTilt"};
constexpr int kMaxSentences = 2; // more than that nobody does at once

} // namespace

CoverageView::CoverageView(QWidget* parent)
    : QWidget(parent), m_views(new QLabel(this)), m_missing(new QLabel(this)), m_map(new QCheckBox(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    for (std::size_t k = 0; k < m_rows.size(); ++k) {
        m_rows[k] = {new QLabel(this), new QProgressBar(this), new QLabel(this)};
        m_rows[k].bar->setObjectName(QString::fromLatin1(kNames[k]));
        m_rows[k].bar->setRange(0, 100);
        m_rows[k].bar->setTextVisible(false);
        m_rows[k].bar->setFixedHeight(10);
        m_rows[k].word->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_rows[k].word->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("100 %\u00a0\u2713")));
        const int row = static_cast<int>(k);
        grid->addWidget(m_rows[k].name, row, 0);
        grid->addWidget(m_rows[k].bar, row, 1, Qt::AlignVCenter);
        grid->addWidget(m_rows[k].word, row, 2);
    }
    m_views->setObjectName("coverageViews");
    m_missing->setObjectName("coverageMissing");
    m_missing->setWordWrap(true);
    m_missing->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // Always of one height: what comes and goes would move the buttons.
    m_missing->setMinimumHeight((1 + kMaxSentences) * fontMetrics().lineSpacing());
    m_map->setObjectName("coverageShown");
    grid->addWidget(m_views, 4, 0, 1, 2);
    grid->addWidget(m_map, 4, 1, 1, 2, Qt::AlignRight);
    grid->addWidget(m_missing, 5, 0, 1, 3);
    connect(m_map, &QCheckBox::toggled, this, &CoverageView::mapWanted);
    setCoverage(coverageOf({}));
}

void CoverageView::setCoverage(const Coverage& coverage) {
    m_coverage = coverage;
    retranslate();
}

bool CoverageView::isMapWanted() const {
    return m_map->isChecked();
}

void CoverageView::retranslate() {
    const std::array names{tr("Left to right"), tr("Top to bottom"), tr("Nearness"), tr("Tilt")};
    const std::array shares{m_coverage.x, m_coverage.y, m_coverage.size, m_coverage.tilt};
    for (std::size_t k = 0; k < m_rows.size(); ++k) {
        const int percent = static_cast<int>(std::floor(100.0 * shares[k]));
        m_rows[k].name->setText(names[k]);
        m_rows[k].bar->setValue(percent);
        m_rows[k].bar->setAccessibleName(tr("Covered: %1").arg(names[k]));
        m_rows[k].word->setText(percent == 100 ? QStringLiteral("\u2713")
                                               : QStringLiteral("%1\u00a0%").arg(percent));
    }
    m_views->setText(m_coverage.views < Coverage::kEnoughViews
                         ? tr("%1 of %2 views").arg(m_coverage.views).arg(Coverage::kEnoughViews)
                         : tr("%1 views").arg(m_coverage.views));
    m_map->setText(tr("Show on the &picture"));
    m_map->setToolTip(tr("Colours the picture by how many corners were seen where."));
    QStringList sentences;
    for (const Message& message : m_coverage.missing)
        if (sentences.size() < kMaxSentences)
            sentences << tr("%1.").arg(sentenceText(message));
    m_missing->setText(sentences.isEmpty() ? tr("This is enough: calibrate.")
                                           : sentences.join(QLatin1Char('\n')));
}

void CoverageView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
