#include "widgets/objects/harmonics_panel.h"

#include "widgets/common/theme.h"
#include "widgets/objects/fourier_fits.h"
#include "widgets/objects/residual_plot.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>

namespace bask {

HarmonicsPanel::HarmonicsPanel(QWidget* parent)
    : QWidget(parent), m_fits(new FourierFits(this)), m_caption(new QLabel(this)),
      m_slider(new QSlider(Qt::Horizontal, this)), m_spin(new QSpinBox(this)), m_residual(new QLabel(this)),
      m_warningIcon(new QLabel(this)), m_warning(new QLabel(this)), m_plot(new ResidualPlot(this)) {
    m_slider->setObjectName("harmonicsSlider");
    m_spin->setObjectName("harmonicsSpin");
    m_residual->setObjectName("residual");
    m_warning->setObjectName("crossingWarning");
    m_plot->setObjectName("residualPlot");
    m_slider->setRange(1, kMaxHarmonics);
    m_slider->setPageStep(5);
    m_spin->setRange(1, kMaxHarmonics);
    m_spin->setKeyboardTracking(false);
    m_caption->setBuddy(m_spin);
    m_residual->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_residual->setWordWrap(true);
    m_warning->setWordWrap(true);

    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_caption, 0, 0);
    layout->addWidget(m_slider, 0, 1);
    layout->addWidget(m_spin, 0, 2);
    layout->addWidget(m_residual, 1, 0, 1, 3);
    auto* warning = new QHBoxLayout;
    warning->addWidget(m_warningIcon);
    warning->addWidget(m_warning, 1);
    layout->addLayout(warning, 2, 0, 1, 3);
    layout->addWidget(m_plot, 3, 0, 1, 3);
    layout->setColumnStretch(1, 1);

    connect(m_slider, &QSlider::valueChanged, this, [this](int h) { choose(h, !m_slider->isSliderDown()); });
    connect(m_slider, &QSlider::sliderReleased, this, [this] { choose(m_slider->value(), true); });
    connect(m_spin, &QSpinBox::valueChanged, this, [this](int h) { choose(h, true); });
    connect(m_plot, &ResidualPlot::harmonicsClicked, this, [this](int h) { choose(h, true); });
    connect(m_fits, &FourierFits::fitReady, this, &HarmonicsPanel::onFitReady);
    setOutline({}, 0, Qt::gray, {});
}

void HarmonicsPanel::setOutline(const Contour& outline, int harmonics, const QColor& color,
                                const QString& why) {
    const QSignalBlocker blockSlider(m_slider);
    const QSignalBlocker blockSpin(m_spin);
    const bool usable = !outline.points_m.empty();
    if (outline != m_fits->outline())
        m_plot->clear();
    m_fits->setOutline(outline);
    m_plot->setColor(color);
    m_plot->setCurrent(usable ? harmonics : 0);
    const int shown = std::clamp(harmonics, 1, kMaxHarmonics);
    m_slider->setValue(shown);
    m_spin->setValue(shown);
    m_waiting = m_commit = false;
    m_why = why;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_slider, m_spin, m_plot})
        widget->setEnabled(usable);
    m_fits->want(shown);
    refreshTexts();
}

void HarmonicsPanel::choose(int harmonics, bool commit) {
    {
        const QSignalBlocker blockSlider(m_slider);
        const QSignalBlocker blockSpin(m_spin);
        m_slider->setValue(harmonics);
        m_spin->setValue(harmonics);
    }
    m_plot->setCurrent(harmonics);
    m_waiting = true;
    m_commit = commit;
    m_fits->want(harmonics);
    deliver();
    refreshTexts();
}

void HarmonicsPanel::deliver() {
    const auto& fit = m_fits->fit(m_slider->value());
    if (!m_waiting || !fit)
        return;
    m_waiting = false;
    const FourierFit copy = *fit; // a receiver may set another outline
    if (m_commit)
        emit fitCommitted(copy);
    else
        emit fitChanged(copy);
}

void HarmonicsPanel::onFitReady(int harmonics) {
    if (const auto& fit = m_fits->fit(harmonics))
        m_plot->setResidual(harmonics, fit->rms_m, fit->max_m);
    if (harmonics == m_slider->value()) {
        deliver();
        refreshTexts();
    }
}

void HarmonicsPanel::refreshTexts() {
    m_caption->setText(tr("&Harmonics"));
    m_slider->setAccessibleName(tr("Number of harmonics"));
    m_spin->setAccessibleName(tr("Number of harmonics"));
    m_residual->setAccessibleName(tr("Residual"));
    m_warningIcon->setPixmap(alarmPixmap(3, isDark(this), 16, devicePixelRatioF()));

    const bool usable = !m_fits->outline().points_m.empty();
    const auto& fit = m_fits->fit(m_slider->value());
    const bool crosses = usable && fit && fit->crossesItself;
    m_warningIcon->setVisible(crosses);
    m_warning->setVisible(crosses);
    m_warning->setText(tr("With this number of harmonics the outline crosses itself; choose another."));
    if (!usable)
        m_residual->setText(m_why);
    else if (!fit)
        m_residual->setText(tr("Fitting\u2026"));
    else
        m_residual->setText(tr("Residual: <b>%1 mm</b> rms, <b>%2 mm</b> at most")
                                .arg(QLocale().toString(fit->rms_m * 1e3, 'f', 3),
                                     QLocale().toString(fit->max_m * 1e3, 'f', 3)));
}

void HarmonicsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refreshTexts();
    QWidget::changeEvent(event);
}

} // namespace bask
