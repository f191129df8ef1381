#include "widgets/thermal/thermal_controls.h"

#include "widgets/common/display.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace bask {
namespace {

constexpr double kHalfBand_K = 0.5;
constexpr double kLimitsApart_K = 1.0;
constexpr double kColdest_K = 150.0, kHottest_K = 2000.0;
enum IsothermKind { kNoIsotherm, kIsothermAbove, kIsothermNear };

QuantitySpinBox* temperatureField(QWidget* parent, const char* name) {
    auto* field = new QuantitySpinBox(parent);
    field->setObjectName(QLatin1String(name));
    field->setRange_K(kColdest_K, kHottest_K);
    return field;
}

QComboBox* choice(QWidget* parent, const char* name, int count) {
    auto* box = new QComboBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (int i = 0; i < count; ++i)
        box->addItem(QString());
    return box;
}

QWidget* group(QWidget* parent, std::initializer_list<QWidget*> parts) {
    auto* row = new QWidget(parent);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    for (QWidget* part : parts)
        layout->addWidget(part);
    layout->addStretch(1);
    return row;
}

void setTexts(QComboBox& box, const QStringList& texts) {
    for (int i = 0; i < box.count(); ++i)
        box.setItemText(i, texts[i]);
}

} // namespace

ThermalControls::ThermalControls(QWidget* parent)
    : QWidget(parent), m_layout(new QHBoxLayout(this)), m_palette(choice(this, "thermalPalette", 2)),
      m_limits(choice(this, "thermalLimits", 3)), m_isotherm(choice(this, "thermalIsotherm", 3)),
      m_min(temperatureField(this, "thermalMin")), m_max(temperatureField(this, "thermalMax")),
      m_isothermAt(temperatureField(this, "thermalIsothermAt")), m_to(new QLabel(this)),
      m_zoom(new QCheckBox(this)), m_smooth(new QCheckBox(this)) {
    m_colours = group(this, {m_palette, m_limits, m_min, m_to, m_max});
    m_marks = group(this, {m_isotherm, m_isothermAt, m_zoom, m_smooth});
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(6);
    m_layout->addWidget(m_colours);
    m_layout->addWidget(m_marks, 1);
    m_zoom->setObjectName(QStringLiteral("thermalZoom"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_smooth->setObjectName(QStringLiteral("thermalSmooth"));
    m_smooth->setChecked(true);
    m_to->setText(QStringLiteral("\u2013"));
    setShownRange({});
    for (QComboBox* box : {m_palette, m_limits, m_isotherm})
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            showFields();
            emit changed();
        });
    for (QuantitySpinBox* field : {m_min, m_max, m_isothermAt})
        connect(field, &QuantitySpinBox::valueEdited_K, this, [this] {
            keepApart();
            emit changed();
        });
    for (QCheckBox* box : {m_zoom, m_smooth})
        connect(box, &QCheckBox::toggled, this, &ThermalControls::changed);
    retranslateUi();
    showFields();
}

ThermalPalette ThermalControls::colours() const {
    return static_cast<ThermalPalette>(m_palette->currentIndex());
}

ThermalLimits ThermalControls::limits() const {
    return static_cast<ThermalLimits>(m_limits->currentIndex());
}

ThermalRange ThermalControls::fixedRange() const {
    return {m_min->value_K(), m_max->value_K()};
}

std::optional<Isotherm> ThermalControls::isotherm() const {
    if (m_isotherm->currentIndex() == kNoIsotherm)
        return std::nullopt;
    return Isotherm{m_isothermAt->value_K(), m_isotherm->currentIndex() == kIsothermNear ? kHalfBand_K : 0.0};
}

bool ThermalControls::isZoomed() const {
    return m_zoom->isChecked();
}

bool ThermalControls::isSmooth() const {
    return m_smooth->isChecked();
}

void ThermalControls::setShownRange(const ThermalRange& range) {
    if (limits() != ThermalLimits::Fixed) {
        m_min->setRange_K(kColdest_K, kHottest_K);
        m_max->setRange_K(kColdest_K, kHottest_K);
        m_min->setValue_K(range.min_K);
        m_max->setValue_K(range.max_K);
        keepApart();
    }
    if (!m_hasIsotherm)
        m_isothermAt->setValue_K(0.5 * (range.min_K + range.max_K));
}

void ThermalControls::keepApart() {
    m_min->setRange_K(kColdest_K, m_max->value_K() - kLimitsApart_K);
    m_max->setRange_K(m_min->value_K() + kLimitsApart_K, kHottest_K);
}

void ThermalControls::setTemperatureUnit(TemperatureUnit unit) {
    for (QuantitySpinBox* field : {m_min, m_max, m_isothermAt})
        field->setTemperatureUnit(unit);
}

void ThermalControls::showFields() {
    m_hasIsotherm = m_hasIsotherm || m_isotherm->currentIndex() != kNoIsotherm;
    for (QWidget* part : std::initializer_list<QWidget*>{m_min, m_to, m_max})
        part->setVisible(limits() == ThermalLimits::Fixed);
    m_isothermAt->setVisible(m_isotherm->currentIndex() != kNoIsotherm);
}

void ThermalControls::retranslateUi() {
    setTexts(*m_palette, {tr("Inferno"), tr("Grey")});
    m_palette->setAccessibleName(tr("Colours of the thermal picture"));
    m_palette->setToolTip(m_palette->accessibleName());
    setTexts(*m_limits, {tr("Limits: objects"), tr("Limits: picture"), tr("Limits: fixed")});
    m_limits->setAccessibleName(tr("Limits of the colours"));
    m_limits->setToolTip(tr("What the colours span: the objects' pixels with a margin, all pixels but the "
                            "0.5 % at either end, or limits of your own."));
    m_min->setAccessibleName(tr("Lower limit of the colours"));
    m_max->setAccessibleName(tr("Upper limit of the colours"));
    setTexts(*m_isotherm, {tr("No isotherm"), tr("Isotherm: above"), tr("Isotherm: near")});
    m_isotherm->setAccessibleName(tr("Isotherm"));
    m_isotherm->setToolTip(tr("Draws the pixels in green that are above a temperature, or nearer to it than "
                              "0.5 K."));
    m_isothermAt->setAccessibleName(tr("Temperature of the isotherm"));
    m_zoom->setText(tr("Zoom"));
    m_zoom->setToolTip(tr("Show the objects with a margin instead of the whole picture."));
    m_smooth->setText(tr("Smooth"));
    m_smooth->setToolTip(tr("Smooth the picture; else each pixel is a square of one colour."));
}

QSize ThermalControls::minimumSizeHint() const {
    const QSize colours = m_colours->minimumSizeHint(), marks = m_marks->minimumSizeHint();
    return {std::max(colours.width(), marks.width()), std::max(colours.height(), marks.height())};
}

void ThermalControls::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const int needed = m_colours->sizeHint().width() + m_layout->spacing() + m_marks->sizeHint().width();
    const auto direction = width() < needed ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
    if (direction == m_layout->direction())
        return;
    m_layout->setDirection(direction);
    updateGeometry();
}

void ThermalControls::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QWidget::changeEvent(event);
}

} // namespace bask
