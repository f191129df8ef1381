#pragma once
// Parts of a page beside each other, or one beneath the other where they have no room for that.

#include <QSplitter>

namespace bask {

/// Its minimum width is that of its widest part: what is narrower than all of them together folds it. What a
/// person has dragged is kept for each of the two.
class FoldingSplitter : public QSplitter {
    Q_OBJECT
public:
    explicit FoldingSplitter(QWidget* parent = nullptr);
    bool isFolded() const { return orientation() == Qt::Vertical; }

    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fold();

    QList<int> m_beside, m_beneath; ///< sizes of the arrangement that is not shown; empty: never shown
};

} // namespace bask
