#include "widgets/common/point_at.h"

#include "widgets/common/theme.h"

#include <QEvent>
#include <QPainter>
#include <QTimer>
#include <QWidget>

#include <chrono>

namespace bask {
namespace {

constexpr std::chrono::seconds kShown{3};
constexpr int kMargin = 5;

class Frame : public QWidget {
public:
    Frame(QWidget* control, const QRect& part) : QWidget(control->window()) {
        const QRect around(control->mapTo(window(), part.topLeft()), part.size());
        setObjectName(QStringLiteral("pointedAt"));
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setGeometry(around.adjusted(-kMargin, -kMargin, kMargin, kMargin));
        show();
        raise();
        QTimer::singleShot(kShown, this, &QObject::deleteLater);
        control->installEventFilter(this);
    }

    /// It would be around nothing.
    bool eventFilter(QObject* control, QEvent* event) override {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Move || event->type() == QEvent::Hide)
            deleteLater();
        return QWidget::eventFilter(control, event);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(accentColor(isDark(this)), 3.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), 5.0, 5.0);
    }
};

} // namespace

void pointAt(QWidget* control) {
    pointAt(control, control->rect());
}

void pointAt(QWidget* control, const QRect& part) {
    delete control->window()->findChild<QWidget*>(QStringLiteral("pointedAt"));
    new Frame(control, part);
}

} // namespace bask
