#include "widgets/common/point_at.h"

#include "widgets/common/theme.h"

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
    Frame(QWidget* window, const QRect& around) : QWidget(window) {
        setObjectName(QStringLiteral("pointedAt"));
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setGeometry(around.adjusted(-kMargin, -kMargin, kMargin, kMargin));
        show();
        raise();
        QTimer::singleShot(kShown, this, &QObject::deleteLater);
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
    QWidget* window = control->window();
    delete window->findChild<QWidget*>(QStringLiteral("pointedAt"));
    new Frame(window, {control->mapTo(window, QPoint(0, 0)), control->size()});
}

} // namespace bask
