#pragma once
// A text that is as large as its place, for what is read from across the room.

#include <QLabel>

#include <initializer_list>
#include <utility>

namespace bask {

/// How a text is to be taken, in the marks and colours that all windows have for it.
struct LargeLook {
    bool isUnknown = false;  ///< nobody knows: its mark and colour, in bold
    bool isGrey = false;     ///< a caption, or what was known last
    bool isStruck = false;   ///< not believed
    bool isAlarmInk = false; ///< in the colour of its priority
    int priority = 0;        ///< of an alarm: its mark; 0 for none
    bool operator==(const LargeLook&) const = default;
};

/// One line, or more with wordWrap(). Nothing is cut off: what is too long even in the smallest letters is
/// shortened, and its tool tip shows all of it.
class LargeText : public QLabel {
    Q_OBJECT
public:
    LargeText(const char* name, Qt::Alignment side, QWidget* parent);

    void setLook(const LargeLook& look);
    /// Makes it a text of figures: without room for letters that hang below the line, and not larger than
    /// `widest` would be, so that figures do not change their size with their values.
    void setFigures(const QString& widest);
    /// Draws this behind the figures, smaller; the mark of an unknown value stands over it.
    void setUnit(const QString& unit);
    const LargeLook& look() const { return m_look; }
    bool isShortened() const;

    /// Height of a figure in px if the text had this room.
    int figureHeight(QSize room) const;

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QFont sized(double size_px) const;
    double besides(int size_px) const; ///< width of mark and unit
    double unitWidth(int size_px) const;
    int markSide(int size_px) const;
    bool hasMark() const { return m_look.isUnknown || m_look.priority > 0; }
    QString widest() const;
    bool fits(const QString& text, int size_px, QSize room) const;
    int fit(const QString& text, QSize room) const;
    int size_px() const;
    QColor ink() const;
    void drawMark(QPainter& painter, QPointF corner, int size_px) const;
    void forgetSize();

    LargeLook m_look;
    QString m_figures; ///< the widest; empty for words
    QString m_unit;
    mutable int m_size_px = 0; ///< 0: not known
    mutable QString m_fitted;
};

/// Places widgets side by side, each with its share of the width.
void placeInRow(const QRect& row, int gap, std::initializer_list<std::pair<QWidget*, double>> shares);

} // namespace bask
