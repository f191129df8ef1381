#pragma once
// A cell with a second, quieter line under its text.

#include <QStyledItemDelegate>

namespace bask {

/// All cells have the height of two lines, or of one, so that rows stay of one height.
class TwoLineDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int kDetailRole = Qt::UserRole + 16; ///< the second line; empty: the text is centred

    using QStyledItemDelegate::QStyledItemDelegate;
    void setTwoLines(bool areTwo) { m_areTwo = areTwo; }
    bool hasTwoLines() const { return m_areTwo; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    bool m_areTwo = false;
};

} // namespace bask
