#include "widgets/review/two_line_delegate.h"

#include "widgets/common/theme.h"

#include <QApplication>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace bask {
namespace {

/// The second line does not get bold with the first.
QFont detailFont(const QStyleOptionViewItem& option) {
    return option.widget != nullptr ? option.widget->font() : option.font;
}

} // namespace

void TwoLineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    const QString detail = index.data(kDetailRole).toString();
    if (detail.isEmpty())
        return QStyledItemDelegate::paint(painter, option, index);
    QStyleOptionViewItem cell = option;
    initStyleOption(&cell, index);
    const QString text = std::exchange(cell.text, {});
    const QStyle* style = cell.widget != nullptr ? cell.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget); // ground, focus
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &cell, cell.widget) + 1;
    const QRect room = cell.rect.adjusted(margin, 0, -margin, 0);
    const bool isSelected = cell.state.testFlag(QStyle::State_Selected);
    const QPalette::ColorGroup group =
        cell.state.testFlag(QStyle::State_Active) ? QPalette::Active : QPalette::Inactive;
    const QColor ink = cell.palette.color(group, isSelected ? QPalette::HighlightedText : QPalette::Text);
    const auto draw = [&](const QString& line, const QFont& font, const QColor& colour, QRect place) {
        painter->setFont(font);
        painter->setPen(colour);
        painter->drawText(place, Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine,
                          QFontMetrics(font).elidedText(line, Qt::ElideRight, place.width()));
    };
    painter->save();
    draw(text, cell.font, ink, QRect(room.topLeft(), QSize(room.width(), room.height() / 2)));
    draw(detail, detailFont(cell), isSelected ? ink : secondaryText(isDark(cell.palette)),
         room.adjusted(0, room.height() / 2, 0, 0));
    painter->restore();
}

QSize TwoLineDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    if (!m_areTwo)
        return size;
    const QFontMetrics detail(detailFont(option));
    const int margins = 2 * (QApplication::style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
    const int width = detail.horizontalAdvance(index.data(kDetailRole).toString()) + margins;
    return {std::max(size.width(), width), size.height() + detail.height()};
}

} // namespace bask
