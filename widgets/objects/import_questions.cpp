#include "widgets/objects/import_questions.h"

#include "engine/shape/marker.h"
#include "engine/shape/outline_formats.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"
#include "widgets/common/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>

namespace bask {
namespace {

constexpr int kUnitFromHeader = -1;

/// A positive length that is not known until it is typed.
QDoubleSpinBox* lengthBox(QWidget* parent, const char* name, int decimals, double max) {
    auto* box = new NumberField(parent);
    box->setObjectName(QString::fromLatin1(name));
    box->setDecimals(decimals);
    box->setRange(0.0, max);
    box->setKeyboardTracking(false);
    return box;
}

/// The unit is told also while there is no number.
void setUnit(QDoubleSpinBox* box, const QString& suffix) {
    box->setSuffix(suffix);
    box->setSpecialValueText(kNoValue + suffix);
}

bool isOfKind(const QString& path, OutlineKind kind) {
    const OutlineFormat* format = outlineFormatOf(path.toStdString());
    return format != nullptr && format->kind == kind;
}

void setLabel(QFormLayout* form, QWidget* field, const QString& text) {
    static_cast<QLabel*>(form->labelForField(field))->setText(text);
}

} // namespace

bool ImportQuestions::isImage(const QString& path) {
    return isOfKind(path, OutlineKind::Picture);
}

bool ImportQuestions::isList(const QString& path) {
    return isOfKind(path, OutlineKind::List);
}

ImportQuestions::ImportQuestions(QWidget* parent)
    : QWidget(parent), m_form(new QFormLayout(this)), m_unit(new QComboBox(this)),
      m_width(lengthBox(this, "importWidth", 3, 1e6)), m_scaleMethod(new QComboBox(this)),
      m_length(lengthBox(this, "importLength", 2, 1e4)), m_measure(new QPushButton(this)),
      m_scale(lengthBox(this, "importScale", 3, 1e5)),
      m_markerSide(lengthBox(this, "importMarkerSide", 2, 1e4)), m_dictionary(new QComboBox(this)),
      m_byColour(new QCheckBox(this)), m_pickColour(new QPushButton(this)),
      m_tolerance(lengthBox(this, "importColourTolerance", 1, 100.0)), m_hint(new QLabel(this)) {
    m_unit->setObjectName("importUnit");
    m_scaleMethod->setObjectName("importScaleMethod");
    m_measure->setObjectName("importMeasure");
    m_measure->setCheckable(true);
    m_dictionary->setObjectName("importDictionary");
    m_dictionary->addItems(QString::fromStdString(markerDictionaries()).split(QStringLiteral(", ")));
    m_byColour->setObjectName("importByColour");
    m_pickColour->setObjectName("importPickColour");
    m_pickColour->setCheckable(true);
    m_hint->setWordWrap(true);
    for (const int unit :
         {kUnitFromHeader, static_cast<int>(LengthUnit::Millimetre), static_cast<int>(LengthUnit::Centimetre),
          static_cast<int>(LengthUnit::Metre), static_cast<int>(LengthUnit::Inch)})
        m_unit->addItem(QString(), unit);
    for (const ScaleMethod method : {ScaleMethod::KnownLength, ScaleMethod::Scale, ScaleMethod::Marker})
        m_scaleMethod->addItem(QString(), static_cast<int>(method));

    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_unit, m_width, m_scaleMethod, m_length, m_measure, m_scale,
                                         m_markerSide, m_dictionary, m_byColour, m_pickColour, m_tolerance})
        m_form->addRow(QStringLiteral(" "), field);
    m_form->addRow(m_hint);

    connect(m_unit, &QComboBox::currentIndexChanged, this, &ImportQuestions::changed);
    connect(m_width, &QDoubleSpinBox::valueChanged, this, [this](double width_mm) {
        if (!(width_mm > 0.0) || !(m_width_mm > 0.0))
            return;
        m_factor *= width_mm / m_width_mm;
        m_width_mm = width_mm;
        emit changed();
    });
    connect(m_scaleMethod, &QComboBox::currentIndexChanged, this, [this] {
        m_measure->setChecked(false);
        showRows();
        emit changed();
    });
    for (QDoubleSpinBox* box : {m_length, m_scale, m_markerSide, m_tolerance})
        connect(box, &QDoubleSpinBox::valueChanged, this, &ImportQuestions::changed);
    connect(m_dictionary, &QComboBox::currentIndexChanged, this, &ImportQuestions::changed);
    connect(m_byColour, &QCheckBox::toggled, this, [this](bool on) {
        showRows();
        m_pickColour->setChecked(on && !m_colour.isValid());
        if (m_colour.isValid())
            emit changed();
    });
    const auto tool = [this](QPushButton* button, QPushButton* other, OutlinePicker::Tool what) {
        connect(button, &QPushButton::toggled, this, [this, other, what](bool on) {
            if (on)
                other->setChecked(false);
            emit toolChanged(on ? what : OutlinePicker::Tool::Pick);
        });
    };
    tool(m_measure, m_pickColour, OutlinePicker::Tool::Measure);
    tool(m_pickColour, m_measure, OutlinePicker::Tool::Colour);
    retranslate();
}

void ImportQuestions::setFile(const QString& path) {
    const QSignalBlocker quiet(this);
    m_image = isImage(path);
    m_list = isList(path);
    m_colour = QColor(); // {} would be a Qt::GlobalColor
    m_ruler_px = QLineF();
    m_unitMissing = false;
    m_factor = 1.0;
    m_unit->setCurrentIndex(0);
    m_scaleMethod->setCurrentIndex(0);
    for (QDoubleSpinBox* box : {m_length, m_scale, m_markerSide, m_tolerance})
        box->setValue(0.0);
    m_byColour->setChecked(false);
    m_measure->setChecked(false);
    m_pickColour->setChecked(false);
    showColour();
    showRows();
}

ImportQuestions::ScaleMethod ImportQuestions::scaleMethod() const {
    return static_cast<ScaleMethod>(m_scaleMethod->currentData().toInt());
}

void ImportQuestions::setUnitMissing() {
    m_unitMissing = true;
}

void ImportQuestions::setWidth_m(double width_m) {
    const QSignalBlocker quiet(m_width);
    m_width_mm = width_m * 1e3;
    m_width->setValue(m_width_mm);
}

bool ImportQuestions::usesRuler() const {
    return m_image && scaleMethod() == ScaleMethod::KnownLength;
}

bool ImportQuestions::lengthsKnown() const {
    if (!m_image)
        return !m_unitMissing || m_unit->currentData().toInt() != kUnitFromHeader;
    switch (scaleMethod()) {
    case ScaleMethod::KnownLength:
        return m_length->value() > 0.0 && m_ruler_px.length() > 0.0;
    case ScaleMethod::Scale:
        return m_scale->value() > 0.0;
    case ScaleMethod::Marker:
        break;
    }
    return m_markerSide->value() > 0.0;
}

QString ImportQuestions::missingText() const {
    if (!m_image)
        return tr("Its true size is not known yet: choose the unit above.");
    switch (scaleMethod()) {
    case ScaleMethod::KnownLength:
        return m_length->value() > 0.0
                   ? tr("Its true size is not known yet: lay the ruler over the length above.")
                   : tr("Its true size is not known yet: type the length of the ruler above.");
    case ScaleMethod::Scale:
        return tr("Its true size is not known yet: type the scale above.");
    case ScaleMethod::Marker:
        break;
    }
    return tr("Its true size is not known yet: type the side of the marker\u2019s square above.");
}

ContourImportOptions ImportQuestions::options() const {
    constexpr double kMPerMm = 1e-3;
    ContourImportOptions options;
    if (const int unit = m_unit->currentData().toInt(); m_list && unit != kUnitFromHeader)
        options.unit = static_cast<LengthUnit>(unit);
    else if (m_unitMissing)
        options.unit = LengthUnit::Millimetre;
    options.factor = m_factor;
    if (!m_image)
        return options;
    options.factor = 1.0;
    options.leaveOutBorder = true; // the panel says so, and the operator sees what is left
    if (!lengthsKnown())
        options.scale_px_per_mm = 1.0;
    else if (scaleMethod() == ScaleMethod::KnownLength)
        options.knownLength = KnownLength{{m_ruler_px.x1(), m_ruler_px.y1()},
                                          {m_ruler_px.x2(), m_ruler_px.y2()},
                                          m_length->value() * kMPerMm};
    else if (scaleMethod() == ScaleMethod::Scale)
        options.scale_px_per_mm = m_scale->value();
    else
        options.marker =
            ReferenceMarker{m_markerSide->value() * kMPerMm, m_dictionary->currentText().toStdString()};
    if (m_byColour->isChecked() && m_colour.isValid()) {
        options.colour = PickedColour{{static_cast<std::uint8_t>(m_colour.red()),
                                       static_cast<std::uint8_t>(m_colour.green()),
                                       static_cast<std::uint8_t>(m_colour.blue())},
                                      {}};
        if (m_tolerance->value() > 0.0)
            options.colour->tolerance = m_tolerance->value();
    }
    return options;
}

void ImportQuestions::setRuler(const QLineF& ruler_px) {
    m_ruler_px = ruler_px;
    if (usesRuler() && m_length->value() > 0.0)
        emit changed();
}

void ImportQuestions::setColour(const QColor& colour) {
    m_colour = colour;
    showColour();
    m_pickColour->setChecked(false);
    emit changed();
}

void ImportQuestions::releaseTools() {
    m_measure->setChecked(false);
    m_pickColour->setChecked(false);
}

void ImportQuestions::showRows() {
    const auto method = scaleMethod();
    const auto show = [this](QWidget* field, bool on) { m_form->setRowVisible(field, on); };
    show(m_unit, m_list);
    show(m_width, !m_image && !m_list);
    show(m_scaleMethod, m_image);
    show(m_length, m_image && method == ScaleMethod::KnownLength);
    show(m_measure, m_image && method == ScaleMethod::KnownLength);
    show(m_scale, m_image && method == ScaleMethod::Scale);
    show(m_markerSide, m_image && method == ScaleMethod::Marker);
    show(m_dictionary, m_image && method == ScaleMethod::Marker);
    show(m_byColour, m_image);
    show(m_pickColour, m_image && m_byColour->isChecked());
    show(m_tolerance, m_image && m_byColour->isChecked());
    show(m_hint, m_image);
    m_hint->setText(method == ScaleMethod::KnownLength
                        ? tr("Lay the ruler over a length that you know: drag its ends, or click both. The "
                             "picture must be taken straight from above.")
                    : method == ScaleMethod::Scale
                        ? tr("The picture must be taken straight from above, or scanned.")
                        : tr("A printed ArUco marker lies beside the object, in the plane of its face. It "
                             "tells the scale and undoes the perspective."));
}

void ImportQuestions::showColour() {
    if (!m_colour.isValid()) {
        m_pickColour->setIcon({});
        return;
    }
    QPixmap swatch(16, 16);
    swatch.fill(m_colour);
    QPainter painter(&swatch);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawRect(0, 0, 15, 15);
    painter.end();
    m_pickColour->setIcon(swatch);
}

void ImportQuestions::retranslate() {
    setLabel(m_form, m_unit, tr("&Unit"));
    setLabel(m_form, m_width, tr("&Width"));
    setLabel(m_form, m_scaleMethod, tr("&Scale from"));
    setLabel(m_form, m_length, tr("&Length"));
    setLabel(m_form, m_measure, QString());
    setLabel(m_form, m_scale, tr("&Scale"));
    setLabel(m_form, m_markerSide, tr("S&ide of its square"));
    setLabel(m_form, m_dictionary, tr("&Dictionary"));
    setLabel(m_form, m_byColour, tr("Object"));
    setLabel(m_form, m_pickColour, QString());
    setLabel(m_form, m_tolerance, tr("&Tolerance"));
    for (int i = 0; i < m_unit->count(); ++i) {
        const int unit = m_unit->itemData(i).toInt();
        m_unit->setItemText(i, unit == kUnitFromHeader
                                   ? tr("as its header says")
                                   : QString::fromLatin1(lengthUnitName(static_cast<LengthUnit>(unit))));
    }
    nameChoice(m_unit, tr("Unit of the coordinates"));
    m_scaleMethod->setAccessibleName(tr("What gives the picture its scale"));
    m_scale->setAccessibleName(tr("Scale of the picture, pixels per millimetre"));
    m_markerSide->setAccessibleName(tr("Side of the marker\u2019s black square"));
    nameChoice(m_dictionary, tr("Dictionary of the marker"));
    m_tolerance->setAccessibleName(tr("Tolerance of the colour"));
    m_scaleMethod->setItemText(0, tr("a known length"));
    m_scaleMethod->setItemText(1, tr("pixels per millimetre"));
    m_scaleMethod->setItemText(2, tr("an ArUco marker in it"));
    setUnit(m_length, tr(" mm"));
    m_length->setAccessibleName(tr("Length of the ruler"));
    m_measure->setText(tr("Click its two ends"));
    setUnit(m_scale, tr(" px/mm"));
    setUnit(m_width, tr(" mm"));
    m_width->setAccessibleName(tr("Width of the outline chosen"));
    m_width->setToolTip(tr("As the drawing says. Type another to make all of it larger or smaller."));
    setUnit(m_markerSide, tr(" mm"));
    m_byColour->setText(tr("tell it by its colour"));
    m_byColour->setToolTip(tr("Otherwise by the picture\u2019s opacity or brightness."));
    m_pickColour->setText(tr("Click the object"));
    m_tolerance->setSpecialValueText(tr("automatic"));
    m_tolerance->setToolTip(tr("Largest distance from the colour clicked, in CIE Lab; 0: found by itself"));
    showRows();
}

void ImportQuestions::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        showColour();
    QWidget::changeEvent(event);
}

} // namespace bask
