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
    if ((isOfBar || isOfPage) && !m_bar.isHidden())
        place();
    return false;
}

void FloatingPlace::place() {
    const QRect seen = seenOf(m_page);
    const int width = std::min(seen.width() - 2 * kMargin_px, kMaxWidth_px);
    const int height = m_bar.hasHeightForWidth() ? m_bar.heightForWidth(width) : m_bar.sizeHint().height();
    const int top = std::max(seen.top(), seen.bottom() - kMargin_px - height); // it begins in sight
    m_bar.setGeometry(seen.center().x() - width / 2, top, width, height);
    m_bar.raise();
}

} // namespace bask
