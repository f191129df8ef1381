#include "widgets/common/stop_button.h"

#include "widgets/common/theme.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPointer>

namespace bask {

StopButton::StopButton(QWidget* parent) : QAbstractButton(parent) {
    setObjectName(QStringLiteral("stopButton"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    connect(this, &QAbstractButton::pressed, this, &StopButton::stopRequested);
    // A QShortcut is deaf while a modal dialog or a menu is open.
    qApp->installEventFilter(this);
    retranslateUi();
}

StopButton::StopButton(StopButton& original, QWidget* dialog)
    : QAbstractButton(dialog), m_original(&original) {
    setWindowFlags(Qt::Tool | Qt::FramelessWindowHint | Qt::WindowStaysOnTopHint |
                   Qt::WindowDoesNotAcceptFocus);
    setObjectName(QStringLiteral("stopTwin"));
    setAttribute(Qt::WA_ShowWithoutActivating);
    setFocusPolicy(Qt::NoFocus);
    setCursor(Qt::PointingHandCursor);
    setFont(original.font());
    m_key = original.m_key;
    connect(this, &QAbstractButton::pressed, &original, &StopButton::stopRequested);
    retranslateUi();
    setGeometry({original.mapToGlobal(QPoint(0, 0)), original.size()});
    show();
}

void StopButton::standOver(QWidget* dialog) {
    if (isVisible() && dialog->isVisible() && twinOn(dialog) == nullptr)
        new StopButton(*this, dialog);
}

StopButton* StopButton::twinOn(const QWidget* dialog) const {
    for (StopButton* twin : dialog->findChildren<StopButton*>(QString(), Qt::FindDirectChildrenOnly))
        if (twin->m_original == this)
            return twin;
    return nullptr;
}

bool StopButton::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
        auto* dialog = qobject_cast<QWidget*>(watched);
        if (dialog != nullptr && dialog->isWindow() && dialog->isModal()) {
            StopButton* twin = twinOn(dialog);
            if (event->type() == QEvent::Show) // the twin comes when the dialog's own window is there
                QMetaObject::invokeMethod(
                    this, [this, there = QPointer(dialog)] { there ? standOver(there) : void(); },
                    Qt::QueuedConnection);
            else if (twin != nullptr)
                twin->deleteLater();
        }
    }
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_F12) {
            if (!key->isAutoRepeat())
                emit stopRequested();
            return true;
        }
    }
    return QAbstractButton::eventFilter(watched, event);
}

void StopButton::retranslateUi() {
    setText(tr("STOP"));
    setToolTip(tr("Zero velocity and heater off now; latched until reset (F12).\n"
                  "This is a software stop, not a safety-rated emergency stop."));
    setAccessibleName(tr("STOP: zero velocity and heater off now (F12)"));
    setAccessibleDescription(tr("Software stop, not a safety-rated emergency stop."));
    updateGeometry();
    update();
}

void StopButton::setKeyShown(bool isShown) {
    m_key = isShown ? QStringLiteral("F12") : QString();
    updateGeometry();
    update();
}

QSize StopButton::sizeHint() const {
    QFont big = font();
    big.setBold(true);
    big.setPointSizeF(font().pointSizeF() * 1.35);
    const QFontMetrics metrics(big);
    return {metrics.horizontalAdvance(text()) + QFontMetrics(font()).horizontalAdvance(m_key) + 56,
            std::max(metrics.height() + 14, 38)};
}

void StopButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor red(0xc6, 0x1f, 0x1f);
    painter.setBrush(isDown() ? red.darker(135) : underMouse() ? red.lighter(112) : red);
    const QColor edge = isDark(this) ? red.lighter(150) : red.darker(150); // red alone is dim in the dark
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::WindowText), 2.0) : QPen(edge, 1.0));
    const double inside = hasFocus() ? 1.0 : 1.5;
    painter.drawRoundedRect(QRectF(rect()).adjusted(inside, inside, -inside, -inside), 5, 5);

    QFont big = font();
    big.setBold(true);
    big.setPointSizeF(font().pointSizeF() * 1.35);
    const int wordWidth = QFontMetrics(big).horizontalAdvance(text());
    const int keyWidth = QFontMetrics(font()).horizontalAdvance(m_key);
    const int left = (width() - wordWidth - keyWidth - (m_key.isEmpty() ? 0 : 10)) / 2;
    painter.setPen(Qt::white);
    painter.setFont(big);
    painter.drawText(QRect(left, 0, wordWidth + 2, height()), Qt::AlignVCenter | Qt::AlignLeft, text());
    painter.setFont(font());
    painter.drawText(QRect(left + wordWidth + 10, 0, keyWidth + 2, height()),
                     Qt::AlignVCenter | Qt::AlignLeft, m_key);
}

void StopButton::changeEvent(QEvent* event) {
    QAbstractButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange)
        update();
}

} // namespace bask
