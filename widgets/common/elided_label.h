#pragma once
// A line of text that is shortened if necessary; its tool tip shows all of it.

#include <QLabel>

namespace bask {

class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

} // namespace bask
