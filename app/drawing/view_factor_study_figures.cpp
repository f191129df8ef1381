#include "app/drawing/view_factor_study_figures.h"

#include <cmath>

namespace bask {
namespace {

using StudyRows = std::vector<StudyRow>;

/// Points of the rows that `wanted` picks.
template <class Wanted, class Point>
FigureSeries seriesOf(const QString& name, const StudyRows& rows, const Wanted& wanted, const Point& point) {
    FigureSeries series{name, {}};
    for (const StudyRow& row : rows)
        if (wanted(row))
            series.points << point(row);
    return series;
}

Figure emptyFigure(const ViewFactorStudy& study, const char* title) {
    Figure figure;
    figure.title = QString::fromUtf8(title);
    figure.note =
        QString::fromUtf8("Bask's bunny over a disk of radius 10 cm, 5 cm apart, parallel: F₂₁ = %1. "
                          "The paper's 0.764602 is another bunny's.")
            .arg(study.exact, 0, 'f', 9);
    figure.yLabel = QStringLiteral("Absolute error of F₂₁");
    return figure;
}

Figure elementsFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "Surface integral: error against the number of elements");
    figure.xLabel = QStringLiteral("Elements on each face");
    figure.series = {seriesOf(
        QStringLiteral("surface integral"), study.rows,
        [](const StudyRow& row) { return row.method == StudyMethod::SurfaceIntegral; },
        [](const StudyRow& row) { return QPointF(row.elements, row.error); })};
    // For the eye: how the error of a staircase of squares falls.
    const auto& points = figure.series[0].points;
    FigureSeries trend{QStringLiteral("slope −3/4"), {}};
    for (const QPointF& point : points)
        trend.points << QPointF(point.x(), 0.1 * std::pow(point.x() / 10.0, -0.75));
    trend.hasMarkers = false;
    figure.series << trend;
    return figure;
}

Figure harmonicsFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "Fourier method: error against the number of harmonics");
    figure.xLabel = QStringLiteral("Harmonics of the outline");
    figure.isXLogarithmic = false;
    for (int points : {8, 16, 32, 64})
        figure.series << seriesOf(
            QStringLiteral("Simpson, %1 points").arg(points), study.rows,
            [&](const StudyRow& row) { return row.method == StudyMethod::Fourier && row.points == points; },
            [](const StudyRow& row) { return QPointF(row.harmonics, row.error); });
    figure.series << seriesOf(
        QStringLiteral("truncation alone (Bask's solver)"), study.rows,
        [](const StudyRow& row) { return row.method == StudyMethod::SolverFourier; },
        [](const StudyRow& row) { return QPointF(row.harmonics, row.error); });
    return figure;
}

Figure pointsFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "Fourier method: error of the quadrature against its points");
    figure.xLabel = QStringLiteral("Quadrature points on each contour");
    figure.xBase = 2;
    figure.yLabel = QStringLiteral("Absolute error against the same truncated outline");
    for (int harmonics : {1, 2, 5, 10, 20})
        figure.series << seriesOf(
            harmonics == 1 ? QStringLiteral("1 harmonic") : QStringLiteral("%1 harmonics").arg(harmonics),
            study.rows,
            [&](const StudyRow& row) {
                return row.method == StudyMethod::Fourier && row.harmonics == harmonics;
            },
            [](const StudyRow& row) { return QPointF(row.points, row.quadratureError.value_or(0.0)); });
    return figure;
}

Figure timeFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "All methods: error against time");
    figure.xLabel = QStringLiteral("Time of one evaluation (µs)");
    figure.yLabel += QStringLiteral(" (10⁻¹²: that or less)");
    figure.smallest = 1e-12; // the reference is no better
    const auto at = [](const StudyRow& row) { return QPointF(row.time_us, row.error); };
    const auto of = [](StudyMethod method, int harmonics) {
        return [=](const StudyRow& row) { return row.method == method && row.harmonics == harmonics; };
    };
    figure.series << seriesOf(QStringLiteral("surface integral"), study.rows,
                              of(StudyMethod::SurfaceIntegral, 0), at);
    for (int harmonics : {5, 20})
        figure.series << seriesOf(QStringLiteral("Fourier method, %1 harmonics").arg(harmonics), study.rows,
                                  of(StudyMethod::Fourier, harmonics), at);
    figure.series << seriesOf(
        QStringLiteral("Bask with gradient, 1 to 20 harmonics"), study.rows,
        [](const StudyRow& row) { return row.method == StudyMethod::SolverFourier; }, at);
    figure.series.last().isJoined = false;
    figure.series << seriesOf(QStringLiteral("Bask with gradient, outline"), study.rows,
                              of(StudyMethod::SolverOutline, 0), at);
    return figure;
}

} // namespace

std::vector<Figure> viewFactorStudyFigures(const ViewFactorStudy& study) {
    return {elementsFigure(study), harmonicsFigure(study), pointsFigure(study), timeFigure(study)};
}

} // namespace bask
