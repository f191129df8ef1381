#include "widgets/common/floating_place.h"

#include <QEvent>
#include <QWidget>

#include <algorithm>

namespace bask {
namespace {

constexpr int kMargin_px = 12, kMaxWidth_px = 760;

/// What its parents leave of it: a scrolled page is larger. Its own parts may hide it, as plots do.
QRect seenOf(const QWidget& page) {
    QRect seen = page.rect();
    QPoint offset;
    for (const QWidget* w = &page; !w->isWindow() && w->parentWidget() != nullptr; w = w->parentWidget()) {
        offset += w->pos();
        seen &= w->parentWidget()->rect().translated(-offset);
    }
    return seen.isEmpty() ? page.rect() : seen;
}

/// Moves a bar up, past what has to be seen, as long as there is room.
QRect movedAbove(const QWidget& page, QRect bar, int highest) {
    for (bool isFree = false; !isFree;) {
        isFree = true;
        for (const QWidget* each : page.findChildren<QWidget*>()) {
            const int wanted = each->property(kKeptFree_px).toInt();
            if (wanted <= 0 || !each->isVisible())
                continue;
            const int height = std::min(wanted, each->height());
            const QRect kept(each->mapTo(&page, QPoint(0, each->height() - height)),
                             QSize(each->width(), height));
            if (!kept.intersects(bar) || kept.top() - bar.height() < highest)
                continue;
            bar.moveBottom(kept.top() - 1);
            isFree = false;
        }
    }
    return bar;
}

} // namespace

FloatingPlace::FloatingPlace(QWidget& bar, QWidget& page) : QObject(&bar), m_bar(bar), m_page(page) {
    bar.installEventFilter(this);
    page.installEventFilter(this);
}

bool FloatingPlace::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool isOfBar = watched == &m_bar && (type == QEvent::ShowToParent || type == QEvent::LayoutRequest);
    const bool isOfPage =
        watched == &m_page && (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show);
    if (isOfBar || isOfPage)
        place();
    return false;
}

void FloatingPlace::place() {
    if (m_bar.isHidden())
        return;
    const QRect seen = seenOf(m_page);
    const int width = std::min(seen.width() - 2 * kMargin_px, kMaxWidth_px);
    const int height = m_bar.hasHeightForWidth() ? m_bar.heightForWidth(width) : m_bar.sizeHint().height();
    const int top = std::max(seen.top(), seen.bottom() - kMargin_px - height); // it begins in sight
    m_bar.setGeometry(
        movedAbove(m_page, QRect(seen.center().x() - width / 2, top, width, height), seen.top()));
    m_bar.raise();
}

} // namespace bask
