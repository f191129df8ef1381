#include "widgets/common/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QProxyStyle>
#include <QStyleOption>
#include <QWidget>

#include <array>
#include <cmath>

namespace bask {
namespace {

// Blue, bluish green, reddish purple, neutral, sky blue.
constexpr std::array<QRgb, 5> kSeriesLight{0x0072b2, 0x00875f, 0xb04f86, 0x4d4d4d, 0x2f8fc9};
constexpr std::array<QRgb, 5> kSeriesDark{0x56b4e9, 0x2fc79b, 0xe59bc6, 0xd6d6d6, 0x7fa4ff};

QColor rgb(QRgb value) {
    return QColor(qRed(value), qGreen(value), qBlue(value));
}

struct Shades {
    QRgb window, base, alternate, button, text, disabled, placeholder, highlight, highlightedText;
    QRgb light, midlight, mid, dark, shadow, toolTip, link;
};
constexpr Shades kLight{0xf2f3f4, 0xffffff, 0xf7f8f9, 0xe9ebed, 0x1d2125, 0x8d959d, 0x687179, 0x2f6da8,
                        0xffffff, 0xffffff, 0xeef0f1, 0xb9c0c6, 0x9aa2a9, 0x6d757c, 0xfffbe6, 0x1f5f99};
constexpr Shades kDark{0x212427, 0x181a1c, 0x1e2123, 0x2e3236, 0xe4e7ea, 0x767e86, 0x868f97, 0x3a78b2,
                       0xffffff, 0x454a4f, 0x383c41, 0x15171a, 0x121416, 0x000000, 0x2e3236, 0x7ab8f0};

QPixmap blankPixmap(QSize size, double devicePixelRatio) {
    QPixmap pixmap(size * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    return pixmap;
}

/// Fusion draws the frames of boxes darker than the window, which on a dark one nobody sees, widens only
/// short menu buttons: the words of a long one touch its arrow, and lays the list of a combo box over what is
/// above it, which may be STOP.
class FramedFusion : public QProxyStyle {
public:
    FramedFusion() : QProxyStyle(QStringLiteral("Fusion")) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool isRadio = element == PE_IndicatorRadioButton;
        if ((element != PE_IndicatorCheckBox && !isRadio) || !isDark(option->palette))
            return;
        painter->save();
        painter->setBrush(Qt::NoBrush);
        painter->setPen(secondaryText(true));
        const QRect frame = option->rect.adjusted(0, 0, -1, -1);
        if (isRadio) {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->drawEllipse(frame);
        } else {
            painter->drawRect(frame);
        }
        painter->restore();
    }

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* more) const override {
        return hint == SH_ComboBox_Popup ? 0 : QProxyStyle::styleHint(hint, option, widget, more);
    }

    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override {
        const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        const bool hasMenu = type == CT_PushButton && button != nullptr &&
                             button->features.testFlag(QStyleOptionButton::HasMenu);
        const int room = hasMenu ? 2 * pixelMetric(PM_ButtonMargin, option, widget) : 0;
        const bool isChoice =
            type == CT_ItemViewItem && widget != nullptr && widget->inherits("QComboBoxListView");
        constexpr int kAsInAMenu = 8;
        return QProxyStyle::sizeFromContents(type, option, contents + QSize(room, 0), widget) +
               QSize(0, isChoice ? kAsInAMenu : 0);
    }
};

/// A square mark with one sign.
QPixmap squarePixmap(const QString& sign, const QColor& ink, const QPen& frame, const QBrush& ground,
                     int size, double devicePixelRatio) {
    QPixmap pixmap = blankPixmap({size, size}, devicePixelRatio);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(frame);
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(0, 0, size, size).adjusted(1, 1, -1, -1), size * 0.16, size * 0.16);
    QFont font = QApplication::font();
    font.setBold(true);
    font.setPixelSize(qMax(7, qRound(size * 0.72)));
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(QRectF(0, 0, size, size), Qt::AlignCenter, sign);
    return pixmap;
}

} // namespace

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::WindowText).lightnessF() > palette.color(QPalette::Window).lightnessF();
}

bool isDark(const QWidget* widget) {
    return isDark(widget->palette());
}

QPalette themePalette(bool dark) {
    const Shades& s = dark ? kDark : kLight;
    QPalette p;
    p.setColor(QPalette::Window, rgb(s.window));
    p.setColor(QPalette::WindowText, rgb(s.text));
    p.setColor(QPalette::Base, rgb(s.base));
    p.setColor(QPalette::AlternateBase, rgb(s.alternate));
    p.setColor(QPalette::Text, rgb(s.text));
    p.setColor(QPalette::Button, rgb(s.button));
    p.setColor(QPalette::ButtonText, rgb(s.text));
    p.setColor(QPalette::BrightText, Qt::white);
    p.setColor(QPalette::PlaceholderText, rgb(s.placeholder));
    p.setColor(QPalette::Highlight, rgb(s.highlight));
    p.setColor(QPalette::HighlightedText, rgb(s.highlightedText));
    p.setColor(QPalette::Light, rgb(s.light));
    p.setColor(QPalette::Midlight, rgb(s.midlight));
    p.setColor(QPalette::Mid, rgb(s.mid));
    p.setColor(QPalette::Dark, rgb(s.dark));
    p.setColor(QPalette::Shadow, rgb(s.shadow));
    p.setColor(QPalette::ToolTipBase, rgb(s.toolTip));
    p.setColor(QPalette::ToolTipText, rgb(s.text));
    p.setColor(QPalette::Link, rgb(s.link));
    for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, rgb(s.disabled));
    p.setColor(QPalette::Disabled, QPalette::Highlight, rgb(s.mid));
    return p;
}

void applyTheme(QApplication& application, Theme theme) {
    static const bool systemDark = isDark(QGuiApplication::palette());
    const bool dark = theme == Theme::System ? systemDark : theme == Theme::Dark;
    if (dynamic_cast<FramedFusion*>(QApplication::style()) == nullptr)
        QApplication::setStyle(new FramedFusion);
    application.setPalette(themePalette(dark));
}

QColor seriesColor(int index, bool dark) {
    const auto i = static_cast<std::size_t>(qMax(0, index)) % kSeriesLight.size();
    return rgb(dark ? kSeriesDark[i] : kSeriesLight[i]);
}

QColor paleSeriesColor(int index, bool dark) {
    constexpr double kWeight = 0.9; // with less the fifth has no contrast of 3:1 any more
    return mixed(seriesColor(index, dark), themePalette(dark).color(QPalette::Base), kWeight);
}

QList<qreal> seriesDashes(int index) {
    switch (qMax(0, index) % 6) {
    case 1:
        return {7, 2.5};
    case 2:
        return {7, 2.5, 1.5, 2.5};
    case 3:
        return {1.5, 2};
    case 4:
        return {12, 3};
    case 5:
        return {7, 2.5, 1.5, 2.5, 1.5, 2.5};
    default:
        return {};
    }
}

QPen seriesPen(int index, bool dark, double width) {
    QPen pen(seriesColor(index, dark), width);
    if (const auto dashes = seriesDashes(index); !dashes.isEmpty())
        pen.setDashPattern(dashes);
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::RoundJoin);
    return pen;
}

QPixmap seriesSwatch(int index, bool dark, QSize size, double devicePixelRatio) {
    QPixmap pixmap = blankPixmap(size, devicePixelRatio);
    QPainter painter(&pixmap);
    painter.setPen(seriesPen(index, dark, 2.5));
    const double y = std::floor(size.height() / 2.0) + 0.5;
    painter.drawLine(QPointF(0, y), QPointF(size.width(), y));
    return pixmap;
}

QColor alarmColor(int priority, bool dark) {
    switch (priority) {
    case 1:
        return dark ? QColor(0xff, 0x6b, 0x60) : QColor(0xc6, 0x28, 0x28);
    case 2:
        return dark ? QColor(0xff, 0xa0, 0x3c) : QColor(0xd9, 0x6b, 0x00);
    default:
        return dark ? QColor(0xf2, 0xd0, 0x45) : QColor(0xd9, 0xb4, 0x00);
    }
}

QColor alarmEdgeColor(int priority, bool dark) {
    const QColor colour = alarmColor(priority, dark);
    return priority == 3 && !dark ? colour.darker(150) : colour;
}

QColor alarmInkColor(int priority, bool dark) {
    return priority == 1 && !dark ? Qt::white : Qt::black;
}

QPixmap alarmPixmap(int priority, bool dark, int size, double devicePixelRatio, bool isOver) {
    QPixmap pixmap = blankPixmap({size, size}, devicePixelRatio);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = alarmColor(priority, dark), rim = alarmEdgeColor(priority, dark);
    painter.setPen(isOver          ? QPen(secondaryText(dark), 1.2)
                   : rim != colour ? QPen(rim, 1.0)
                                   : QPen(Qt::NoPen));
    painter.setBrush(isOver ? QBrush(Qt::NoBrush) : QBrush(colour));
    const double edge = isOver ? 1.0 : 0.5;
    const QRectF box = QRectF(0, 0, size, size).adjusted(edge, edge, -edge, -edge);
    QRectF textBox = box;
    if (priority == 1) {
        painter.drawPolygon(QPolygonF{{box.center().x(), box.top()}, box.bottomRight(), box.bottomLeft()});
        textBox.setTop(box.top() + 0.3 * size);
    } else if (priority == 2) {
        painter.drawPolygon(QPolygonF{{box.center().x(), box.top()},
                                      {box.right(), box.center().y()},
                                      {box.center().x(), box.bottom()},
                                      {box.left(), box.center().y()}});
    } else {
        painter.drawEllipse(box);
    }
    QFont font = QApplication::font();
    font.setBold(true);
    font.setPixelSize(qMax(6, qRound(size * (priority == 1 ? 0.58 : 0.62))));
    painter.setFont(font);
    painter.setPen(isOver ? secondaryText(dark) : alarmInkColor(priority, dark));
    painter.drawText(textBox, Qt::AlignCenter, QString::number(priority));
    return pixmap;
}

QColor unknownColor(bool dark) {
    return dark ? QColor(0xce, 0xa6, 0xf5) : QColor(0x77, 0x36, 0xa3);
}

QPixmap unknownPixmap(bool dark, int size, double devicePixelRatio) {
    const QColor colour = unknownColor(dark);
    QPen frame(colour, qMax(1.2, size * 0.08));
    frame.setDashPattern({1.8, 1.2});
    return squarePixmap(QStringLiteral("?"), colour, frame, Qt::NoBrush, size, devicePixelRatio);
}

QPixmap problemPixmap(bool dark, int size, double devicePixelRatio) {
    return squarePixmap(QStringLiteral("!"), alarmInkColor(3, dark),
                        QPen(alarmEdgeColor(3, dark), qMax(1.0, size * 0.08)), alarmColor(3, dark), size,
                        devicePixelRatio);
}

QColor accentColor(bool dark) {
    return dark ? QColor(0x6a, 0xae, 0xe6) : QColor(0x1f, 0x66, 0xa3);
}
QColor secondaryText(bool dark) {
    return dark ? QColor(0xa3, 0xac, 0xb4) : QColor(0x58, 0x61, 0x6a);
}
QColor hairline(bool dark) {
    return dark ? QColor(0x3c, 0x41, 0x46) : QColor(0xd5, 0xd9, 0xdc);
}

QColor mixed(const QColor& color, const QColor& ground, double weight) {
    const auto blend = [weight](float a, float b) {
        return static_cast<float>(weight * static_cast<double>(a) + (1.0 - weight) * static_cast<double>(b));
    };
    return QColor::fromRgbF(blend(color.redF(), ground.redF()), blend(color.greenF(), ground.greenF()),
                            blend(color.blueF(), ground.blueF()));
}

QPalette captionPalette(const QPalette& palette) {
    QPalette caption = palette;
    caption.setColor(QPalette::WindowText, secondaryText(isDark(palette)));
    return caption;
}

} // namespace bask
