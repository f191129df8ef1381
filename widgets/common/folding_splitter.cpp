#include "widgets/common/folding_splitter.h"

#include <QEvent>

#include <algorithm>
#include <utility>

namespace bask {
namespace {

constexpr int kPartHeight = 280; ///< px at least, beneath another: a plot or a picture is to be seen there

QSize leastSize(const QWidget& part) {
    return part.minimumSizeHint().expandedTo(part.minimumSize()).boundedTo(part.maximumSize());
}

struct Needed {
    int beside = 0, widest = 0, beneath = 0, highest = 0;
};

Needed neededOf(const QSplitter& splitter) {
    Needed out;
    int parts = 0;
    for (int i = 0; i < splitter.count(); ++i) {
        const QWidget& part = *splitter.widget(i);
        if (part.isHidden() && part.testAttribute(Qt::WA_WState_ExplicitShowHide))
            continue; // not: its page was never shown
        const QSize least = leastSize(part);
        out.beside += least.width();
        out.widest = std::max(out.widest, least.width());
        out.beneath += std::max(least.height(), kPartHeight);
        out.highest = std::max(out.highest, least.height());
        ++parts;
    }
    const int handles = std::max(0, parts - 1) * splitter.handleWidth();
    out.beside += handles;
    out.beneath += handles;
    return out;
}

} // namespace

FoldingSplitter::FoldingSplitter(QWidget* parent) : QSplitter(Qt::Horizontal, parent) {
    setChildrenCollapsible(false);
}

QSize FoldingSplitter::minimumSizeHint() const {
    const Needed needed = neededOf(*this);
    return {needed.widest, isFolded() ? needed.beneath : needed.highest};
}

bool FoldingSplitter::event(QEvent* event) {
    const bool isDone = QSplitter::event(event);
    if (event->type() == QEvent::LayoutRequest) // of a language, say
        fold();
    return isDone;
}

void FoldingSplitter::resizeEvent(QResizeEvent* event) {
    fold(); // before the sizes are those that the new width squeezes
    QSplitter::resizeEvent(event);
}

void FoldingSplitter::fold() {
    const bool isNarrow = width() < neededOf(*this).beside;
    if (isNarrow == isFolded())
        return;
    (isFolded() ? m_beneath : m_beside) = sizes();
    setOrientation(isNarrow ? Qt::Vertical : Qt::Horizontal);
    const QList<int> before = std::exchange(isNarrow ? m_beneath : m_beside, {});
    setSizes(before.isEmpty() ? QList<int>(count(), kPartHeight) : before);
    updateGeometry();
}

} // namespace bask
