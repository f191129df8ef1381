#include "widgets/objects/harmonics_panel.h"

#include "widgets/common/display.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/number_field.h"
#include "widgets/common/theme.h"
#include "widgets/objects/fourier_fits.h"
#include "widgets/objects/residual_plot.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kFirstHarmonics = 5; // offered for an outline that has no fit yet

QString number(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

} // namespace

HarmonicsPanel::HarmonicsPanel(QWidget* parent)
    : QWidget(parent), m_fits(new FourierFits(this)), m_caption(new QLabel(this)),
      m_slider(new QSlider(Qt::Horizontal, this)), m_spin(new WholeNumberField(this)),
      m_fewest(new QPushButton(this)), m_tolerance(new NumberField(this)), m_useOutline(new QCheckBox(this)),
      m_residual(new QLabel(this)), m_verdict(new QLabel(this)), m_takeClosest(new QPushButton(this)),
      m_warningIcon(new QLabel(this)), m_warning(new QLabel(this)), m_plot(new ResidualPlot(this)) {
    m_slider->setObjectName("harmonicsSlider");
    m_spin->setObjectName("harmonicsSpin");
    m_fewest->setObjectName("fewestHarmonics");
    m_tolerance->setObjectName("tolerance");
    m_useOutline->setObjectName("useOutline");
    m_residual->setObjectName("residual");
    m_verdict->setObjectName("toleranceVerdict");
    m_verdict->setProperty(kKeptFree_px, kWholeWidget_px);
    m_takeClosest->setObjectName("takeClosest");
    m_warning->setObjectName("crossingWarning");
    m_plot->setObjectName("residualPlot");
    m_slider->setRange(1, kMaxHarmonics);
    m_slider->setPageStep(5);
    m_spin->setRange(1, kMaxHarmonics);
    m_spin->setKeyboardTracking(false);
    m_tolerance->setRange(0.01, 100.0);
    m_tolerance->setDecimals(2);
    m_tolerance->setSingleStep(0.1);
    m_tolerance->setValue(0.5);
    m_caption->setBuddy(m_spin);
    m_residual->setTextInteractionFlags(Qt::TextSelectableByMouse);
    for (QLabel* label : {m_residual, m_verdict, m_warning})
        label->setWordWrap(true);
    m_verdict->hide();
    m_takeClosest->hide();
    for (QLabel* label :
         {m_warningIcon, m_warning}) { // or the preview would change its size while the slider is dragged
        QSizePolicy kept = label->sizePolicy();
        kept.setRetainSizeWhenHidden(true);
        label->setSizePolicy(kept);
    }
    arrange();
    connectAll();
    setOutline({}, 0, Qt::gray, {});
}

void HarmonicsPanel::arrange() {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    // At the foot, where no longer text above moves the slider under the mouse that drags it.
    layout->addWidget(m_caption, 4, 0);
    layout->addWidget(m_slider, 4, 1);
    layout->addWidget(m_spin, 4, 2);
    auto* choices = new QHBoxLayout;
    choices->addWidget(m_fewest);
    choices->addWidget(m_tolerance);
    choices->addStretch(1);
    choices->addWidget(m_useOutline);
    layout->addLayout(choices, 5, 0, 1, 3);
    layout->addWidget(m_residual, 0, 0, 1, 3);
    layout->addWidget(m_verdict, 1, 0, 1, 2);
    layout->addWidget(m_takeClosest, 1, 2, Qt::AlignTop);
    auto* warning = new QHBoxLayout;
    warning->addWidget(m_warningIcon);
    warning->addWidget(m_warning, 1);
    layout->addLayout(warning, 2, 0, 1, 3);
    layout->addWidget(m_plot, 3, 0, 1, 3);
    layout->setColumnStretch(1, 1);
}

void HarmonicsPanel::connectAll() {
    connect(m_slider, &QSlider::valueChanged, this, [this](int h) { choose(h, !m_slider->isSliderDown()); });
    connect(m_slider, &QSlider::sliderReleased, this, [this] { choose(m_slider->value(), true); });
    connect(m_spin, &QDoubleSpinBox::valueChanged, this, [this] { choose(m_spin->whole(), true); });
    connect(m_plot, &ResidualPlot::harmonicsClicked, this, [this](int h) { choose(h, true); });
    connect(m_fewest, &QPushButton::clicked, this, [this] {
        m_sought_m = m_tolerance->value() * 1e-3;
        chooseFewest();
    });
    connect(m_tolerance->findChild<QLineEdit*>(), &QLineEdit::returnPressed, m_fewest, &QPushButton::click);
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, [this] {
        m_sought_m.reset(); // what was said is of another tolerance
        setVerdict({});
    });
    connect(m_takeClosest, &QPushButton::clicked, this, [this] { choose(m_closest, true); });
    connect(m_useOutline, &QCheckBox::toggled, this, &HarmonicsPanel::useOutline);
    connect(m_fits, &FourierFits::fitReady, this, &HarmonicsPanel::onFitReady);
}

void HarmonicsPanel::setOutline(const Contour& outline, int harmonics, const QColor& color,
                                const QString& why) {
    const QSignalBlocker blockSlider(m_slider);
    const QSignalBlocker blockSpin(m_spin);
    const QSignalBlocker blockUse(m_useOutline);
    const bool usable = !outline.points_m.empty();
    const bool another = outline != m_fits->outline();
    if (another) {
        m_plot->clear();
        m_sought_m.reset();
        setVerdict({});
    }
    m_fits->setOutline(outline);
    m_plot->setColor(color);
    m_plot->setCurrent(usable ? harmonics : 0);
    // The number before is kept for the way back from the outline itself.
    if (harmonics > 0 || another)
        m_slider->setValue(harmonics > 0 ? harmonics : kFirstHarmonics);
    m_spin->setValue(m_slider->value());
    m_useOutline->setChecked(usable && harmonics == 0);
    m_waiting = m_commit = false;
    m_why = why;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_slider, m_spin, m_fewest, m_tolerance, m_plot})
        widget->setEnabled(usable);
    m_useOutline->setEnabled(!m_fits->polygon().points_m.empty());
    m_fits->want(m_slider->value());
    refreshTexts();
    tellDistances();
}

void HarmonicsPanel::choose(int harmonics, bool commit) {
    {
        const QSignalBlocker blockSlider(m_slider);
        const QSignalBlocker blockSpin(m_spin);
        const QSignalBlocker blockUse(m_useOutline);
        m_slider->setValue(harmonics);
        m_spin->setValue(harmonics);
        m_useOutline->setChecked(false);
    }
    m_sought_m.reset();
    setVerdict({});
    m_plot->setCurrent(harmonics);
    m_waiting = true;
    m_commit = commit;
    m_fits->want(harmonics);
    deliver();
    refreshTexts();
}

void HarmonicsPanel::deliver() {
    const auto& found = m_fits->fit(m_slider->value());
    if (!m_waiting || !found)
        return;
    m_waiting = false;
    const FourierFit copy = found->fit; // a receiver may set another outline
    if (m_commit)
        emit fitCommitted(copy);
    else
        emit fitChanged(copy);
    tellDistances();
}

void HarmonicsPanel::tellDistances() {
    const auto& found = m_fits->fit(m_slider->value());
    if (found && !m_useOutline->isChecked())
        emit distancesReady(found->fit, m_fits->points(), found->distances_m);
}

// As fitFourierWithin does, but with the fits that are there: the answer is known with the last one below it.
void HarmonicsPanel::chooseFewest() {
    if (!m_sought_m)
        return;
    std::optional<FourierFit> closest;
    for (int h = 1; h <= kMaxHarmonics; ++h) {
        const auto& found = m_fits->fit(h);
        if (!found && !m_fits->complete())
            return setVerdict(tr("Fitting\u2026 %1 of %2").arg(m_fits->done()).arg(kMaxHarmonics));
        if (!found || found->fit.crossesItself || !checkHoles(shapeOfFit(found->fit, m_holes)))
            continue;
        if (found->fit.hausdorff_m <= *m_sought_m)
            return choose(h, true);
        if (!closest || found->fit.hausdorff_m < closest->hausdorff_m)
            closest = found->fit;
    }
    const QString asked = number(*m_sought_m * 1e3, 2);
    m_sought_m.reset();
    if (closest)
        setVerdict(tr("%1 mm cannot be reached with up to %2 harmonics: %3 of them come closest, within %4 "
                      "mm. The outline itself is exact.")
                       .arg(asked)
                       .arg(kMaxHarmonics)
                       .arg(closest->contour.harmonics())
                       .arg(number(closest->hausdorff_m * 1e3, 3)),
                   closest->contour.harmonics());
    else
        setVerdict(tr("With any number of harmonics up to %1 the outline crosses itself. The outline itself "
                      "is exact.")
                       .arg(kMaxHarmonics));
}

void HarmonicsPanel::useOutline(bool use) {
    if (!use)
        return choose(m_slider->value(), true);
    m_sought_m.reset();
    setVerdict({});
    const Contour copy = m_fits->polygon();
    emit outlineCommitted(copy);
}

void HarmonicsPanel::onFitReady(int harmonics) {
    if (const auto& found = m_fits->fit(harmonics))
        m_plot->setResidual(harmonics, found->fit.rms_m, found->fit.max_m);
    m_useOutline->setEnabled(true);
    if (harmonics == m_slider->value()) {
        if (m_waiting)
            deliver();
        else
            tellDistances();
        refreshTexts();
    }
    chooseFewest();
}

void HarmonicsPanel::setVerdict(const QString& text, int closest) {
    m_closest = closest;
    m_verdict->setText(text);
    m_verdict->setVisible(!text.isEmpty());
    m_takeClosest->setText(tr("Take %1", "a number of harmonics").arg(closest));
    m_takeClosest->setAccessibleName(tr("Take %1 harmonics").arg(closest));
    m_takeClosest->setVisible(closest > 0 && closest != m_slider->value());
}

void HarmonicsPanel::refreshTexts() {
    m_caption->setText(tr("&Harmonics"));
    m_slider->setAccessibleName(tr("Number of harmonics"));
    m_spin->setAccessibleName(tr("Number of harmonics"));
    m_fewest->setText(tr("Fewest harmonics &within"));
    m_fewest->setToolTip(tr("Chooses the fewest harmonics whose outline does not cross itself and is nowhere "
                            "farther from the imported one than this (Hausdorff distance)."));
    m_tolerance->setSuffix(tr(" mm"));
    m_tolerance->setAccessibleName(tr("Distance within which the Fourier outline shall be"));
    m_tolerance->setToolTip(m_fewest->toolTip());
    m_useOutline->setText(tr("Use the outli&ne itself"));
    m_useOutline->setToolTip(tr("Takes the imported outline as a polygon, corner by corner, in place of a "
                                "Fourier outline. Exact; slower the more corners it has."));
    m_residual->setToolTip(tr(
        "Residual: between points at equal arc length, as a root mean square (rms) and at most. Hausdorff "
        "distance: the farthest that any point of one outline is from the nearest of the other; it is what "
        "\"Fewest harmonics within\" is about. Area: of the Fourier outline against the imported one."));
    m_warning->setText(tr("With this number of harmonics the outline crosses itself; choose another."));
    m_warningIcon->setPixmap(alarmPixmap(3, isDark(this), 16, devicePixelRatioF()));
    refreshResidual();
}

void HarmonicsPanel::refreshResidual() {
    const bool usable = !m_fits->outline().points_m.empty();
    const bool fitted = usable && !m_useOutline->isChecked();
    const auto& found = m_fits->fit(m_slider->value());
    const bool crosses = fitted && found && found->fit.crossesItself;
    m_warningIcon->setVisible(crosses);
    m_warning->setVisible(crosses);
    if (!usable)
        m_residual->setText(m_why);
    else if (!fitted)
        m_residual->setText(outlineText());
    else if (!found)
        m_residual->setText(tr("Fitting\u2026"));
    else
        m_residual->setText(
            tr("Residual <b>%1 mm</b> rms, <b>%2 mm</b> at most; Hausdorff <b>%3 mm</b>; area <b>%4 %</b>")
                .arg(number(found->fit.rms_m * 1e3, 3), number(found->fit.max_m * 1e3, 3),
                     number(found->fit.hausdorff_m * 1e3, 3), formatSigned(found->fit.areaError * 100.0, 2)));
}

QString HarmonicsPanel::outlineText() const {
    const std::size_t all = m_fits->outline().points_m.size(), kept = m_fits->polygon().points_m.size();
    const auto count = [](std::size_t n) { return QLocale().toString(static_cast<qulonglong>(n)); };
    if (kept == 0 || kept == all)
        return tr("The imported outline itself is used: %1 corners.").arg(count(all));
    return tr("The imported outline itself is used, thinned from %1 to %2 corners.")
        .arg(count(all), count(kept));
}

void HarmonicsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_sought_m.reset();
        setVerdict({}); // its sentence is in the language before
    }
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refreshTexts();
    QWidget::changeEvent(event);
}

} // namespace bask
