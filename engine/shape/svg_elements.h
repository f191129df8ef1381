#pragma once
// Pieces of SVG that both passes over a drawing read: lengths, viewports, kinds of elements. Qt's types: for
// svg_survey and svg_filter only.

#include <QByteArray>
#include <QString>

#include <Eigen/Geometry>

#include <optional>

class QXmlStreamAttributes;
class QXmlStreamReader;

namespace bask::svg {

struct Length {
    double value = 0.0;
    QString unit; ///< "" for a plain number
};
std::optional<Length> lengthOf(const QString& text);
/// Pixels of an absolute unit, and of em and ex at the usual 16 px letter.
std::optional<double> pixelsOf(const QString& unit);

struct Box {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};
std::optional<Box> viewBoxOf(const QXmlStreamAttributes& attributes);
/// From the view box to the viewport, as preserveAspectRatio says.
Eigen::Affine2d viewTransform(const Box& view, const Box& port, const QString& preserve);

QString nameOf(const QXmlStreamReader& reader);
/// The element of the same file that is linked to; other files are never opened.
QString linkOf(const QXmlStreamAttributes& attributes);
bool isGroup(const QString& name);
bool isShape(const QString& name);
bool isPaint(const QString& name);
bool isDrawn(const QString& name);
/// Left out, though it would be seen.
bool isSeen(const QString& name);

/// Gives the reader a drawing; a declared encoding which Qt does not know is taken for Latin-1: names and
/// numbers are ASCII.
void feed(QXmlStreamReader& reader, const QByteArray& bytes);

} // namespace bask::svg
