#include "widgets/common/floating_place.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QWidget>

#include <algorithm>
#include <optional>
#include <ranges>

namespace bask {
namespace {

constexpr int kMargin_px = 12, kMaxWidth_px = 760, kBetween_px = 4;

/// What its parents up to the window leave of it: a scrolled page is larger. Its own parts may hide it, as
/// plots do.
QRect seenOf(const QWidget& page) {
    QRect seen = page.rect();
    QPoint offset;
    for (const QWidget* w = &page; !w->isWindow() && w->parentWidget() != nullptr; w = w->parentWidget()) {
        offset += w->pos();
        seen &= w->parentWidget()->rect().translated(-offset);
    }
    return seen.isEmpty() ? page.rect() : seen;
}

/// What its parents leave of a part, in the page.
QRect seenOn(const QWidget& page, const QWidget& part, const QRect& of) {
    QRect seen = of;
    for (const QWidget* w = &part; w != &page; w = w->parentWidget())
        seen = (seen & w->rect()).translated(w->pos());
    return seen & page.rect();
}

bool isControlOnPage(const QWidget& part) {
    const bool isControl = qobject_cast<const QAbstractButton*>(&part) != nullptr ||
                           qobject_cast<const QLineEdit*>(&part) != nullptr ||
                           qobject_cast<const QComboBox*>(&part) != nullptr ||
                           qobject_cast<const QAbstractSpinBox*>(&part) != nullptr ||
                           qobject_cast<const QTabBar*>(&part) != nullptr ||
                           qobject_cast<const QAbstractSlider*>(&part) != nullptr;
    return isControl && qobject_cast<const QScrollBar*>(&part) == nullptr;
}

/// Moves a bar up past each of these; nothing if there is no room.
std::optional<QRect> movedAbove(QRect bar, const std::vector<QRect>& kept, int highest) {
    for (bool isFree = false; !isFree;) {
        isFree = true;
        for (const QRect& each : kept)
            if (each.intersects(bar)) {
                bar.moveBottom(each.top() - 1);
                isFree = false;
            }
        if (bar.top() < highest)
            return std::nullopt;
    }
    return bar;
}

/// The same, but what has no room above it is passed over.
QRect movedAboveWhereItCan(QRect bar, const std::vector<QRect>& kept, int highest) {
    for (bool isFree = false; !isFree;) {
        isFree = true;
        for (const QRect& each : kept)
            if (each.intersects(bar) && each.top() - bar.height() >= highest) {
                bar.moveBottom(each.top() - 1);
                isFree = false;
            }
    }
    return bar;
}

} // namespace

FloatingPlace::FloatingPlace(std::initializer_list<QWidget*> bars, QWidget& page)
    : QObject(&page), m_bars(bars.begin(), bars.end()), m_page(page) {
    for (QWidget* bar : bars) {
        bar->installEventFilter(this);
        bar->setProperty(kKeptFree_px, kWholeWidget_px); // by those of a place around this one
    }
    page.installEventFilter(this);
}

bool FloatingPlace::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (watched == &m_page) {
        if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show)
            place();
        return false;
    }
    if (type != QEvent::ShowToParent && type != QEvent::LayoutRequest)
        return false;
    std::vector<QRect> others;
    QWidget* changed = nullptr;
    for (const QPointer<QWidget>& bar : m_bars)
        if (bar && !bar->isHidden()) {
            if (bar == watched)
                changed = bar;
            else
                others.push_back(bar->geometry());
        }
    if (changed != nullptr && (type == QEvent::ShowToParent || changed->size() != wantedSize(*changed))) {
        const int bottom = lowest();
        place(*changed, others,
              type == QEvent::ShowToParent ? bottom : std::min(bottom, changed->geometry().bottom()));
        raiseInOrder();
    }
    return false;
}

void FloatingPlace::place() {
    std::vector<QRect> placed;
    for (const QPointer<QWidget>& bar : m_bars)
        if (bar && !bar->isHidden()) {
            place(*bar, placed, lowest());
            placed.push_back(bar->geometry());
        }
    raiseInOrder();
}

int FloatingPlace::lowest() const {
    return seenOf(m_page).bottom() - kMargin_px;
}

QSize FloatingPlace::wantedSize(const QWidget& bar) const {
    const int width = std::min(seenOf(m_page).width() - 2 * kMargin_px, kMaxWidth_px);
    return {width, bar.hasHeightForWidth() ? bar.heightForWidth(width) : bar.sizeHint().height()};
}

void FloatingPlace::place(QWidget& bar, const std::vector<QRect>& others, int bottom) {
    const QRect seen = seenOf(m_page);
    const QSize size = wantedSize(bar);
    const int top = std::max(seen.top(), bottom + 1 - size.height()); // it begins in sight
    bar.setGeometry(freePlace({{seen.center().x() - size.width() / 2, top}, size}, others, seen.top()));
}

QRect FloatingPlace::freePlace(const QRect& wanted, const std::vector<QRect>& others, int highest) const {
    std::vector<QRect> bars, kept, controls;
    for (const QRect& other : others)
        bars.push_back(other.adjusted(0, -kBetween_px, 0, kBetween_px));
    const auto isInBar = [this](const QWidget* part) {
        return std::ranges::any_of(m_bars, [part](const QPointer<QWidget>& each) {
            return each && (each == part || each->isAncestorOf(part));
        });
    };
    for (const QWidget* each : m_page.findChildren<QWidget*>()) {
        if (!each->isVisible() || each->window() != m_page.window() || isInBar(each))
            continue;
        if (const int px = each->property(kKeptFree_px).toInt(); px > 0) {
            const int high = std::min(px, each->height());
            kept.push_back(seenOn(m_page, *each, {0, each->height() - high, each->width(), high}));
        } else if (isControlOnPage(*each)) {
            controls.push_back(seenOn(m_page, *each, each->rect()));
        }
    }
    kept.insert(kept.begin(), bars.begin(), bars.end());
    controls.insert(controls.begin(), kept.begin(), kept.end());
    for (const std::vector<QRect>& free : {controls, kept})
        if (const auto found = movedAbove(wanted, free, highest))
            return *found;
    return movedAboveWhereItCan(movedAboveWhereItCan(wanted, bars, highest), kept, highest);
}

/// The first is the last to be covered.
void FloatingPlace::raiseInOrder() {
    std::for_each(m_bars.rbegin(), m_bars.rend(), [](const auto& bar) {
        if (bar && !bar->isHidden())
            bar->raise();
    });
}

} // namespace bask
