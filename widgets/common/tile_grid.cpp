#include "widgets/common/tile_grid.h"

#include "engine/model/experiment.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/object_tile.h"

#include <QEvent>
#include <QGridLayout>

#include <algorithm>

namespace bask {
namespace {

constexpr int kGapOfTiles = 6;
constexpr int kMaxInOneRow = 4;

} // namespace

TileGrid::TileGrid(QWidget* parent) : QWidget(parent), m_layout(new QGridLayout(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(kGapOfTiles);
    setProperty(kKeptFree_px, kWholeWidget_px);
}

void TileGrid::setObjects(const QString& objectName, const QStringList& names) {
    qDeleteAll(m_tiles);
    m_tiles.clear();
    m_perRow = 0;
    for (const QString& name : names) {
        const auto i = static_cast<int>(m_tiles.size());
        auto* tile = new ObjectTile(i, this);
        tile->setObjectName(objectName + QString::number(i));
        tile->setName(name);
        tile->setTemperatureUnit(m_unit);
        m_tiles.push_back(tile);
    }
    arrange();
}

void TileGrid::setLimits(const Experiment& experiment) {
    for (std::size_t i = 0; i < std::min(m_tiles.size(), experiment.objects.size()); ++i) {
        const ObjectSpec& object = experiment.objects[i];
        m_tiles[i]->setLimits(warningLimit_K(experiment, object), tripLimit_K(experiment, object));
    }
}

void TileGrid::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    for (ObjectTile* tile : m_tiles)
        tile->setTemperatureUnit(unit);
}

int TileGrid::widest() const {
    int width = 0;
    for (const ObjectTile* tile : m_tiles)
        width = std::max(width, tile->minimumSizeHint().width());
    return width;
}

/// One tile's width: what holds it may become so narrow.
QSize TileGrid::minimumSizeHint() const {
    return {widest(), m_layout->totalMinimumSize().height()};
}

void TileGrid::arrange() {
    const auto count = static_cast<int>(m_tiles.size());
    if (count == 0)
        return;
    const int wanted = count <= kMaxInOneRow ? count : (count + 1) / 2;
    const int perRow = std::clamp((width() + kGapOfTiles) / (widest() + kGapOfTiles), 1, wanted);
    if (perRow == m_perRow)
        return;
    m_perRow = perRow;
    for (int i = 0; i < count; ++i)
        m_layout->addWidget(m_tiles[static_cast<std::size_t>(i)], i / perRow, i % perRow);
}

bool TileGrid::event(QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
        arrange();
    return QWidget::event(event);
}

} // namespace bask
