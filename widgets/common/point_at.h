#pragma once
// Shows a frame around a control for a moment, so that it is found.

class QRect;
class QWidget;

namespace bask {

/// Only one at a time in a window; the control works normally. Object name: "pointedAt".
void pointAt(QWidget* control);
void pointAt(QWidget* control, const QRect& part);

} // namespace bask
