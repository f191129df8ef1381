#pragma once
// Parts of SVG that both passes over a drawing read: lengths, viewports, kinds of elements. Uses Qt's types:
// for svg_survey and svg_filter only.

#include <QByteArray>
#include <QString>
#include <QStringList>

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
/// Returns the pixels of an absolute unit, and of em and ex for a letter of 16 px.
std::optional<double> pixelsOf(const QString& unit);

/// Returns the attributes of an element that are lengths: "x", "width".
const QStringList& lengthsOf(const QString& element);
/// Returns whether a text is a length that is understood, or empty: also a percentage, and "auto" where an
/// element may have it.
bool isLength(const QString& attribute, const QString& text);

struct Box {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};
std::optional<Box> viewBoxOf(const QXmlStreamAttributes& attributes);
/// Returns the map from the view box to the viewport, according to preserveAspectRatio.
Eigen::Affine2d viewTransform(const Box& view, const Box& port, const QString& preserve);

QString nameOf(const QXmlStreamReader& reader);
/// Returns the link as it stands in the file.
QString hrefOf(const QXmlStreamAttributes& attributes);
/// Returns the linked element of the same file; other files are never opened.
QString linkOf(const QXmlStreamAttributes& attributes);
bool isGroup(const QString& name);
bool isShape(const QString& name);
bool isPaint(const QString& name);
bool isDrawn(const QString& name);
/// Returns whether an element of this name would be visible, although it is left out.
bool isSeen(const QString& name);

/// Returns whether an element's own attributes say that it is not to be seen.
bool isHidden(const QXmlStreamAttributes& attributes);

/// Gives a drawing to the reader. A declared encoding that Qt does not know is read as Latin-1, because names
/// and numbers are ASCII.
void feed(QXmlStreamReader& reader, const QByteArray& bytes);

} // namespace bask::svg
