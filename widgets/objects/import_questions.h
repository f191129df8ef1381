#pragma once
// What a file of outlines does not contain: the unit of a list, the scale of a picture, and which part is the
// object.

#include "engine/shape/contour_import.h"
#include "widgets/objects/outline_picker.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace bask {

/// Shows the questions for the kind of file. Object names: "importUnit", "importWidth", "importScaleMethod",
/// "importLength", "importMeasure", "importScale", "importMarkerSide", "importDictionary", "importByColour",
/// "importPickColour", "importColourTolerance".
class ImportQuestions : public QWidget {
    Q_OBJECT

public:
    explicit ImportQuestions(QWidget* parent = nullptr);

    void setFile(const QString& path);
    /// The answers so far; while lengthsKnown() is false, a pixel counts as one millimetre.
    ContourImportOptions options() const;
    bool lengthsKnown() const;
    /// Returns which answer is missing, by the name of its field; for while lengthsKnown() is false.
    QString missingText() const;
    /// Call if the list's header names no unit: until the answer a number counts as millimetres.
    void setUnitMissing();
    /// Sets the width of the chosen outline; typing another one scales all outlines.
    void setWidth_m(double width_m);
    /// Whether a known length between two points gives the scale.
    bool usesRuler() const;
    void setRuler(const QLineF& ruler_px);
    void setColour(const QColor& colour);

    static bool isImage(const QString& path);
    static bool isList(const QString& path);

signals:
    void changed();
    void toolChanged(bask::OutlinePicker::Tool tool);

public slots:
    void releaseTools();

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class ScaleMethod { KnownLength, Scale, Marker };
    ScaleMethod scaleMethod() const;
    void showRows();
    void showColour();
    void retranslate();

    bool m_image = false;
    bool m_list = false;
    bool m_unitMissing = false;
    double m_factor = 1.0;
    double m_width_mm = 0.0; ///< the shown width
    QLineF m_ruler_px;
    QColor m_colour;
    QFormLayout* m_form;
    QComboBox* m_unit;
    QDoubleSpinBox* m_width;
    QComboBox* m_scaleMethod;
    QDoubleSpinBox* m_length;
    QPushButton* m_measure;
    QDoubleSpinBox* m_scale;
    QDoubleSpinBox* m_markerSide;
    QComboBox* m_dictionary;
    QCheckBox* m_byColour;
    QPushButton* m_pickColour;
    QDoubleSpinBox* m_tolerance;
    QLabel* m_hint;
};

} // namespace bask
