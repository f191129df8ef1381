#pragma once
// The drawing by Qt over the scene: axes with ticks in cm, the colour bar, and the labels of source and
// objects.

#include "engine/base/units.h"
#include "engine/exchange/target_surfaces.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/label_layout.h"
#include "widgets/scene/camera_fit.h"

#include <QColor>
#include <QCoreApplication>
#include <QPainterPath>
#include <QPalette>
#include <QString>

#include <vector>

class QPainter;

namespace bask {

/// A label beside something in the scene.
struct SceneLabel {
    QString text;
    QString value;                          ///< after the text, lighter; may be empty
    QColor colour;                          ///< colour of its mark; if invalid, no mark
    bool optional = false;                  ///< left out if it would cover something
    std::vector<Eigen::Vector3d> outline_R; ///< m; the label is placed beside this outline and avoids it
};

/// Everything the overlay shows, as values.
struct OverlayContent {
    Box frame; ///< box whose edges have the axes, R, m; or angles, rad
    PoseSubset axes = PoseSubset::Translation;
    std::vector<SceneLabel> labels;                    ///< in order of importance
    std::vector<std::vector<Eigen::Vector3d>> paths_R; ///< m; lines that labels leave visible
    bool hasBar = false;
    NiceRange bar;    ///< in the shown unit
    QString barTitle; ///< title above it: quantity and unit
};

/// Draws the overlay with the palette's colours. Text stays upright and sharp at any pixel ratio and in any
/// script.
class SceneOverlay {
    Q_DECLARE_TR_FUNCTIONS(bask::SceneOverlay)
public:
    /// Returns the space (logical pixels) that axes and bar need at each side.
    static QMarginsF margins(const QFont& font, QSizeF size);

    void paint(QPainter& painter, QSizeF size, const QPalette& palette, const Projection& projection,
               const OverlayContent& content);

private:
    struct Frame; ///< one picture's working values
    void paintAxes(Frame& frame);
    void paintAxis(Frame& frame, int axis);
    void paintBar(Frame& frame);
    void paintLabels(Frame& frame);
    void paintLabel(Frame& frame, const SceneLabel& label, const QRectF& anchor, const QRectF& place);

    LabelLayout m_layout;
};

} // namespace bask
