#include "widgets/objects/object_properties.h"

#include "engine/base/units.h"
#include "engine/model/coordinate_range.h"
#include "engine/model/experiment_rig.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"
#include "widgets/common/parameter_form.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"
#include "widgets/objects/material_presets.h"
#include "widgets/objects/outline_painting.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>

#include <cmath>

namespace bask {
namespace {

constexpr double kCmPerM = 100.0;
constexpr int kRadiusDecimals = 3, kMaxRadiusDecimals = 6;
constexpr int kTyped = -1; ///< entry of the preset list for values that match none

/// Four digits; "7.621 x 10^-11" with a true multiplication sign and superscripts where there would be many
/// zeros.
QString numberText(double value) {
    static const QString kSuperscripts =
        QString::fromUtf8("\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079");
    const QLocale locale;
    if (!std::isfinite(value))
        return kNoValue;
    const QString digits = QString::number(value, 'e', 3);
    const int exponent = digits.section(QLatin1Char('e'), 1).toInt();
    if (value == 0.0 || (exponent >= -3 && exponent <= 3))
        return locale.toString(value, 'g', 4);
    QString power = exponent < 0 ? QStringLiteral("\u207b") : QString();
    for (const QChar digit : QString::number(std::abs(exponent)))
        power += kSuperscripts[digit.digitValue()];
    return QStringLiteral("%1\u00a0\u00d7\u00a010%2")
        .arg(locale.toString(digits.section(QLatin1Char('e'), 0, 0).toDouble(), 'f', 3), power);
}

/// "42 s", "6.5 min", "2.3 h".
QString timeConstantText(double time_s) {
    const QLocale locale;
    if (!std::isfinite(time_s))
        return kNoValue;
    if (time_s < 119.5)
        return ObjectProperties::tr("%1 s").arg(locale.toString(time_s, 'f', time_s < 9.95 ? 1 : 0));
    const double time_min = time_s / 60.0;
    return time_min < 119.5
               ? ObjectProperties::tr("%1 min").arg(locale.toString(time_min, 'f', time_min < 9.95 ? 1 : 0))
               : ObjectProperties::tr("%1 h").arg(locale.toString(time_min / 60.0, 'f', 1));
}

} // namespace

ObjectProperties::ObjectProperties(QWidget* parent) : QWidget(parent) {
    build();
}

QDoubleSpinBox* ObjectProperties::number(const char* name, double min, double max, int decimals, double step,
                                         std::function<void(ObjectSpec&, double)> apply) {
    auto* field = new NumberField(this);
    field->setObjectName(QString::fromLatin1(name));
    field->setRange(min, max);
    field->setDecimals(decimals);
    field->setSingleStep(step);
    field->setKeyboardTracking(false);
    field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(field, &QDoubleSpinBox::valueChanged, this, [this, apply](double value) {
        edit([apply, value](ObjectSpec& object) { apply(object, value); });
    });
    return field;
}

QDoubleSpinBox* ObjectProperties::angle(const char* name, Coordinate coordinate) {
    const ValidRange range = coordinateRange(coordinate, kMaxMounting_cm, false);
    QDoubleSpinBox* field = number(name, range.min, range.max, 1, 5.0, [coordinate](ObjectSpec& o, double v) {
        o.mounting[coordinate] = radFromDeg(v);
    });
    field->setWrapping(true);
    return field;
}

QDoubleSpinBox* ObjectProperties::materialField(const Parameter<Material>& parameter) {
    const double scale = parameter.unit.symbolPerSi;
    QDoubleSpinBox* field =
        number(parameterObjectName(parameter).toLatin1(), scale * fromWritten(parameter, parameter.range.min),
               scale * fromWritten(parameter, parameter.range.max), parameter.decimals, 1.0,
               [this, &parameter, scale](ObjectSpec& o, double v) {
                   const Material before = o.material;
                   parameter.set(o.material, v / scale);
                   o.material = withTypedValues(before, o.material, m_library);
               });
    field->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    if (*parameter.unit.symbol != '\0')
        field->setSuffix(QChar(0x00a0) + QString::fromUtf8(parameter.unit.symbol));
    return field;
}

void ObjectProperties::build() {
    using S = ObjectSpec;
    m_name = new QLineEdit(this);
    m_name->setObjectName("objectName");
    m_name->setMaxLength(60);
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        edit([name = m_name->text().trimmed().toStdString()](S& object) { object.name = name; });
    });
    m_kind = new QLabel(this);
    m_area = new QLabel(this);
    m_area->setObjectName("area");
    m_perimeter = new QLabel(this);
    m_perimeter->setObjectName("perimeter");
    const auto told = [this](const char* name) {
        auto* label = new QLabel(this);
        label->setObjectName(QString::fromLatin1(name));
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        return label;
    };
    m_presetSource = told("presetSource");
    m_presetSource->setWordWrap(true);
    m_heatCapacity = told("heatCapacity");
    m_timeConstant = told("timeConstant");
    m_lambda1 = told("lambda1");
    m_lambda2 = told("lambda2");
    m_lambda3 = told("lambda3");
    m_radius = number("radius", kCmPerM * kMinShapeRadius_m, kCmPerM * kMaxObjectRadius_m, kRadiusDecimals,
                      0.1, [](S& o, double v) { o.shape = withHoles(Disk{v / kCmPerM}, holesOf(o.shape)); });
    m_preset = new QComboBox(this);
    m_preset->setObjectName("materialPreset");
    m_preset->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(m_preset, &QComboBox::activated, this, [this](int row) {
        const int index = m_preset->itemData(row).toInt();
        if (index == kTyped)
            return;
        edit([this, index](S& o) {
            o.material = withListed(o.material, m_library, static_cast<std::size_t>(index));
        });
    });
    for (const Parameter<Material>& parameter : materialParameters())
        m_material.emplace_back(&parameter, materialField(parameter));
    m_mountX = number("mountX", -kMaxMounting_cm, kMaxMounting_cm, 2, 0.5,
                      [](S& o, double v) { o.mounting[kX] = v / kCmPerM; });
    m_mountY = number("mountY", -kMaxMounting_cm, kMaxMounting_cm, 2, 0.5,
                      [](S& o, double v) { o.mounting[kY] = v / kCmPerM; });
    m_mountZ = number("mountZ", -kMaxMounting_cm, kMaxMounting_cm, 2, 0.5,
                      [](S& o, double v) { o.mounting[kZ] = v / kCmPerM; });
    m_mountRotation = angle("mountRotation", kThetaZ);
    m_mountTiltX = angle("mountTiltX", kThetaX);
    m_mountTiltY = angle("mountTiltY", kThetaY);
    m_target = new QuantitySpinBox(this);
    m_target->setObjectName("target");
    m_target->setRange_K(kelvinFromCelsius(kMinTemperature_degC), kelvinFromCelsius(kMaxTemperature_degC));
    connect(m_target, &QuantitySpinBox::valueEdited_K, this,
            [this](double value_K) { edit([value_K](S& o) { o.target_K = value_K; }); });

    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(2, 0, 8, 4);
    layout->setHorizontalSpacing(10);
    layout->setVerticalSpacing(3);
    int row = 0;
    const auto field = [&](QWidget* widget, int column, int span = 1) {
        auto* label = new QLabel(this);
        label->setBuddy(widget);
        layout->addWidget(label, row, column, 1, span, Qt::AlignBottom);
        layout->addWidget(widget, row + 1, column, 1, span);
        m_captions.push_back({label, widget});
    };
    const auto head = [&](int index) {
        m_headings[index] = heading(layout, row);
        ++row;
    };
    head(0);
    field(m_name, 0);
    field(m_target, 1);
    row += 2;
    layout->addWidget(m_kind, row, 0, 1, 2);
    row += 1;
    field(m_radius, 0);
    row += 2;
    field(m_area, 0);
    field(m_perimeter, 1);
    row += 2;
    head(1);
    field(m_preset, 0, 2);
    row += 2;
    addMaterialRows(layout, row);
    row += 3;
    for (std::size_t i = 0; i < m_material.size(); ++i) { // two a row
        field(m_material[i].second, static_cast<int>(i % 2));
        if (i % 2 == 1 || i + 1 == m_material.size())
            row += 2;
    }
    field(m_heatCapacity, 0);
    field(m_timeConstant, 1);
    row += 2;
    field(m_lambda1, 0);
    field(m_lambda2, 1);
    row += 2;
    field(m_lambda3, 0);
    row += 2;
    head(2);
    field(m_mountX, 0);
    field(m_mountY, 1);
    row += 2;
    field(m_mountZ, 0);
    field(m_mountRotation, 1);
    row += 2;
    field(m_mountTiltX, 0);
    field(m_mountTiltY, 1);
    row += 2;
    layout->setRowStretch(row, 1);
    layout->setColumnStretch(0, 1);
    layout->setColumnStretch(1, 1);

    // A wheel that scrolls the form must not change a value it happens to pass over.
    for (QWidget* widget : findChildren<QWidget*>()) {
        if (qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
            qobject_cast<QComboBox*>(widget) != nullptr) {
            widget->setFocusPolicy(Qt::StrongFocus);
            widget->installEventFilter(this);
        }
    }
    refreshTexts();
}

void ObjectProperties::addMaterialRows(QGridLayout* layout, int row) {
    m_saveMaterial = new QPushButton(this);
    m_saveMaterial->setObjectName("saveMaterial");
    m_materials = new QPushButton(this);
    m_materials->setObjectName("materials");
    connect(m_saveMaterial, &QPushButton::clicked, this,
            [this] { emit saveMaterialWanted(m_object.material); });
    connect(m_materials, &QPushButton::clicked, this, &ObjectProperties::materialsWanted);
    layout->addWidget(m_presetSource, row, 0, 1, 2);
    layout->addWidget(m_saveMaterial, row + 1, 0, 1, 2);
    layout->addWidget(m_materials, row + 2, 0, 1, 2);
}

QLabel* ObjectProperties::heading(QGridLayout* layout, int row) {
    auto* label = boldLabel(this);
    label->setContentsMargins(0, row == 0 ? 0 : 10, 0, 2);
    layout->addWidget(label, row, 0, 1, 2);
    return label;
}

bool ObjectProperties::eventFilter(QObject* watched, QEvent* event) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() == QEvent::Wheel && widget != nullptr && !widget->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ObjectProperties::edit(const std::function<void(ObjectSpec&)>& change) {
    if (m_showing)
        return;
    ObjectSpec changed = m_object;
    change(changed);
    if (changed == m_object)
        return;
    if (!(changed.material == m_object.material)) {
        changed.material = withTrueName(changed.material, m_library);
        if (!haveSameValues(changed.material, m_object.material))
            changed.estimatedRates.reset(); // they were another material's
    }
    m_object = changed;
    showObject();
    emit objectEdited(changed);
}

void ObjectProperties::setObject(const ObjectSpec& object) {
    m_object = object;
    showObject();
}

void ObjectProperties::setMaterialLibrary(const MaterialLibrary& library) {
    m_library = library;
    showPresets();
}

void ObjectProperties::focusName() {
    m_name->setFocus(Qt::OtherFocusReason);
    m_name->selectAll();
}

void ObjectProperties::setSurroundings(const Surroundings& surroundings) {
    m_surroundings = surroundings;
    showDerived();
}

void ObjectProperties::setTemperatureUnit(TemperatureUnit unit) {
    m_target->setTemperatureUnit(unit);
}

void ObjectProperties::setReadOnly(bool readOnly) {
    for (const Caption& caption : m_captions)
        caption.field->setEnabled(!readOnly);
    m_saveMaterial->setEnabled(!readOnly);
}

void ObjectProperties::showObject() {
    m_showing = true;
    const Material& material = m_object.material;
    if (m_name->text().trimmed().toStdString() != m_object.name)
        m_name->setText(QString::fromStdString(m_object.name));
    const auto* disk = outlineAs<Disk>(m_object.shape);
    m_radius->setVisible(disk != nullptr);
    for (const Caption& caption : m_captions)
        if (caption.field == m_radius)
            caption.label->setVisible(disk != nullptr);
    if (disk != nullptr)
        setQuietly(m_radius, disk->radius_m * kCmPerM, kRadiusDecimals, kMaxRadiusDecimals);
    for (const auto& [parameter, field] : m_material)
        setQuietly(field, parameter->get(material).value() * parameter->unit.symbolPerSi);
    setQuietly(m_mountX, m_object.mounting[kX] * kCmPerM);
    setQuietly(m_mountY, m_object.mounting[kY] * kCmPerM);
    setQuietly(m_mountZ, m_object.mounting[kZ] * kCmPerM);
    setQuietly(m_mountRotation, degFromRad(m_object.mounting[kThetaZ]));
    setQuietly(m_mountTiltX, degFromRad(m_object.mounting[kThetaX]));
    setQuietly(m_mountTiltY, degFromRad(m_object.mounting[kThetaY]));
    m_target->setValue_K(m_object.target_K);
    showPresets();
    showDerived();
    m_showing = false;
}

void ObjectProperties::showPresets() {
    const QSignalBlocker block(m_preset);
    m_preset->clear();
    for (std::size_t i = 0; i < materialPresets().size(); ++i)
        m_preset->addItem(materialPresetLabel(i), static_cast<int>(i));
    const std::size_t presets = materialPresets().size();
    if (!m_library.empty())
        m_preset->insertSeparator(m_preset->count());
    for (std::size_t k = 0; k < m_library.size(); ++k)
        m_preset->addItem(QString::fromStdString(m_library[k].name), static_cast<int>(presets + k));
    const Material& material = m_object.material;
    const auto match = listedMaterial(material, m_library);
    QString told = QString::fromStdString(originText(material));
    if (match && *match < presets) {
        told = materialPresetSource(*match);
    } else if (match) {
        if (told.isEmpty())
            told = QString::fromStdString(originText(m_library[*match - presets]));
    }
    told += (told.isEmpty() ? QString() : QStringLiteral("\n")) + uncertaintyText(material);
    m_presetSource->setText(told.trimmed());
    m_presetSource->setVisible(!told.isEmpty());
    if (match) {
        m_preset->setCurrentIndex(m_preset->findData(static_cast<int>(*match)));
        return;
    }
    const QString name = QString::fromStdString(material.name);
    m_preset->insertItem(0,
                         name.isEmpty()   ? tr("typed values")
                         : told.isEmpty() ? tr("typed values (%1)").arg(name)
                                          : name,
                         kTyped);
    m_preset->setCurrentIndex(0);
}

void ObjectProperties::showDerived() {
    const QLocale locale;
    if (!(shapeArea(m_object.shape) > 0.0))
        return; // nothing set yet
    const auto* series = outlineAs<FourierContour>(m_object.shape);
    const QString kind = outlineAs<Disk>(m_object.shape) != nullptr ? tr("Disk")
                         : series != nullptr
                             ? tr("Fourier outline, %1").arg(harmonicsText(series->harmonics()))
                             : tr("Polygon");
    const std::size_t holes = holesOf(m_object.shape).size();
    m_kind->setText(holes > 0 ? kind + QStringLiteral(", ") + holesText(holes) : kind);
    const QString area = tr("%1 cm\u00b2").arg(locale.toString(shapeArea(m_object.shape) * 1e4, 'f', 2));
    m_area->setText(holesOf(m_object.shape).empty() ? area : tr("%1 without holes").arg(area));
    m_perimeter->setText(tr("%1 cm").arg(locale.toString(shapePerimeter(m_object.shape) * kCmPerM, 'f', 2)));
    m_heatCapacity->setText(tr("%1 J/(m\u00b2\u00b7K)")
                                .arg(locale.toString(m_object.material.arealHeatCapacity_J_m2K(), 'f', 0)));
    const HeatRates rates = heatRates(m_object, m_surroundings);
    m_timeConstant->setText(timeConstantText(rates.timeConstant_s(m_object.target_K)));
    m_lambda1->setText(tr("%1 K/s").arg(numberText(rates.lambda1)));
    m_lambda2->setText(tr("%1 K\u207b\u00b3\u00b7s\u207b\u00b9").arg(numberText(rates.lambda2)));
    m_lambda3->setText(tr("%1 K/s").arg(numberText(rates.lambda3)));
}

void ObjectProperties::refreshTexts() {
    m_headings[0]->setText(tr("Object"));
    m_headings[1]->setText(tr("Material"));
    m_headings[2]->setText(tr("Mounting on the end-effector"));
    std::vector<std::pair<QWidget*, QString>> captions{
        {m_name, tr("Name")},
        {m_target, tr("Target")},
        {m_radius, tr("Radius")},
        {m_area, tr("Area")},
        {m_perimeter, tr("Perimeter")},
        {m_preset, tr("Preset")},
        {m_heatCapacity, tr("Heat capacity")},
        {m_timeConstant, tr("Time constant")},
        {m_lambda1, QStringLiteral("\u03bb\u2081")},
        {m_lambda2, QStringLiteral("\u03bb\u2082")},
        {m_lambda3, QStringLiteral("\u03bb\u2083")},
        {m_mountX, tr("x")},
        {m_mountY, tr("y")},
        {m_mountZ, tr("z, height")},
        {m_mountRotation, tr("Rotation about z")},
        {m_mountTiltX, tr("Tilt about x")},
        {m_mountTiltY, tr("Tilt about y")},
    };
    for (const auto& [parameter, field] : m_material)
        captions.emplace_back(field, parameterLabel(*parameter));
    const QPalette caption = captionPalette(palette());
    for (const auto& [field, text] : captions) {
        if (qobject_cast<QLabel*>(field) == nullptr) // of a label it would be said in its text's place
            field->setAccessibleName(text);
        for (const Caption& c : m_captions) {
            if (c.field == field) {
                c.label->setText(text);
                c.label->setPalette(caption);
            }
        }
    }
    m_presetSource->setPalette(caption);
    m_saveMaterial->setText(tr("Save as material\u2026"));
    m_saveMaterial->setToolTip(tr("Keeps these values in your library of materials"));
    m_materials->setText(tr("Materials\u2026"));
    m_materials->setToolTip(tr("Your library of materials: see, rename, remove, import and export"));
    m_heatCapacity->setToolTip(tr("Of the plate, per area that is seen"));
    m_timeConstant->setToolTip(tr("Of small changes about the target"));
    m_lambda1->setToolTip(tr("Heating at view factor 1 with the source as it is set"));
    m_lambda2->setToolTip(tr("Times T\u2074: what the object radiates"));
    m_lambda3->setToolTip(tr("What the surroundings give"));
    m_kind->setPalette(caption);
    m_mountX->setAccessibleName(tr("Mounting x"));
    m_mountY->setAccessibleName(tr("Mounting y"));
    m_mountZ->setAccessibleName(tr("Mounting z"));
    for (QDoubleSpinBox* field : {m_radius, m_mountX, m_mountY, m_mountZ})
        field->setSuffix(tr(" cm"));
    for (QDoubleSpinBox* field : {m_mountRotation, m_mountTiltX, m_mountTiltY}) {
        field->setSuffix(tr(" \u00b0"));
        field->setToolTip(tr("The object is turned about the end-effector's x first, then about its y, then "
                             "about its z"));
    }
    m_showing = true;
    showPresets();
    showDerived();
    m_showing = false;
}

void ObjectProperties::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refreshTexts();
    QWidget::changeEvent(event);
}

} // namespace bask
