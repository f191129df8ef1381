#include "widgets/targets/pairs_view.h"

#include "engine/base/message_code.h"
#include "engine/base/whole_file.h"
#include "engine/exchange/reachable_file.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/marked_picture.h"
#include "widgets/common/theme.h"
#include "widgets/targets/reach_map.h"

#include <QBuffer>
#include <QDir>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kMinSide = 230;
constexpr int kMaxSide = 560;
constexpr QSize kPicture(480, 480);
constexpr double kPictureScale = 2.0;

/// A map, its picture, and the path of both but for the ending.
struct ExportedMap {
    QString stem;
    ReachableMap map;
    QImage picture;
};

/// Nothing is there, or an earlier export.
bool mayReplace(const QString& path) {
    constexpr qint64 kLongest = 200;
    QFile there(path);
    if (there.size() == 0 || isMarkedPicture(path, QLatin1String(kReachableMark)))
        return true;
    return there.open(QIODevice::ReadOnly) && there.readLine(kLongest).startsWith(kReachableMark);
}

QString tableOf(const ExportedMap& map) {
    return map.stem + QStringLiteral(".csv");
}

QString pictureOf(const ExportedMap& map) {
    return map.stem + QStringLiteral(".png");
}

Result<void> writeMaps(const std::vector<ExportedMap>& maps, const std::vector<std::string>& names) {
    for (const ExportedMap& map : maps)
        for (const QString& path : {tableOf(map), pictureOf(map)})
            if (!mayReplace(path))
                return Error(MessageCode::ExportForeign, path.toStdString());
    for (const ExportedMap& map : maps) {
        const auto written = writeWholeFile(tableOf(map).toStdString(), reachableCsv(names, map.map));
        if (!written)
            return written;
        QByteArray png;
        QBuffer buffer(&png);
        map.picture.save(&buffer, "PNG"); // memory takes it
        if (const auto drawn = writeWholeFile(pictureOf(map).toStdString(), png.toStdString()); !drawn)
            return drawn;
    }
    return {};
}

/// Whether the maps of two experiments differ by more than where the targets lie.
bool sameMaps(Experiment a, const Experiment& b) {
    if (a.objects.size() != b.objects.size())
        return false;
    for (std::size_t i = 0; i < a.objects.size(); ++i)
        a.objects[i].target_K = b.objects[i].target_K;
    a.controller = b.controller;
    return a == b;
}

QPixmap colourBar(bool dark, QSize size, double devicePixelRatio) {
    QImage bar(size.width(), 1, QImage::Format_RGB32);
    for (int x = 0; x < bar.width(); ++x)
        bar.setPixelColor(x, 0, mapColour(x / (bar.width() - 1.0), dark));
    QPixmap pixmap = QPixmap::fromImage(bar.scaled(size * devicePixelRatio));
    pixmap.setDevicePixelRatio(devicePixelRatio);
    return pixmap;
}

} // namespace

PairsView::PairsView(QWidget* parent)
    : QWidget(parent), m_caption(new QLabel(this)), m_rareColour(new QLabel(this)), m_rare(new QLabel(this)),
      m_few(new QLabel(this)), m_colours(new QLabel(this)), m_many(new QLabel(this)),
      m_exportButton(new QPushButton(this)), m_note(new QLabel(this)), m_scroll(new QScrollArea(this)) {
    m_note->setObjectName("mapsNote");
    m_exportButton->setObjectName("exportMaps");
    m_caption->setWordWrap(true);
    m_note->setWordWrap(true);
    auto* content = new QWidget;
    m_grid = new QGridLayout(content);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(6);
    m_grid->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_scroll->setWidget(content);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

    auto* key = new QHBoxLayout;
    for (QLabel* label : {m_rareColour, m_rare, m_few, m_colours, m_many})
        key->addWidget(label);
    key->insertSpacing(2, 10);
    key->addStretch(1);
    auto* top = new QHBoxLayout;
    top->addWidget(m_caption, 1);
    top->addWidget(m_exportButton, 0, Qt::AlignTop);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 6);
    layout->addLayout(top);
    layout->addLayout(key);
    layout->addWidget(m_note, 1, Qt::AlignTop);
    layout->addWidget(m_scroll, 1);
    connect(m_exportButton, &QPushButton::clicked, this, &PairsView::askAndExport);
    showAll();
}

void PairsView::setExperiment(const Experiment& experiment) {
    const bool otherMaps = !sameMaps(m_experiment, experiment);
    const bool otherNumber = experiment.objects.size() != m_experiment.objects.size();
    m_experiment = experiment;
    m_stale = m_stale || otherMaps;
    if (otherNumber)
        buildMaps();
    showAll();
}

void PairsView::setMaps(const std::vector<ReachableMap>& maps) {
    if (!maps.empty() && maps.size() != m_maps.size())
        return; // of other objects
    m_made = maps;
    m_stale = false;
    for (std::size_t i = 0; i < maps.size(); ++i)
        m_maps[i]->setMap(maps[i]);
    showAll();
}

void PairsView::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    showAll();
}

void PairsView::setEditable(bool editable) {
    m_editable = editable;
    showAll();
}

void PairsView::buildMaps() {
    for (ReachMap* map : m_maps)
        delete map;
    m_maps.clear();
    m_made.clear();
    const int N = static_cast<int>(m_experiment.objects.size());
    for (int first = 0; first < N; ++first)
        for (int second = first + 1; second < N; ++second) {
            auto* map = new ReachMap(m_scroll->widget());
            map->setObjectName(QStringLiteral("map%1").arg(m_maps.size()));
            connect(map, &ReachMap::targetsDragged, this,
                    [this, first, second](double first_K, double second_K) {
                        emit targetsDragged(first, second, first_K, second_K);
                    });
            connect(map, &ReachMap::targetsPicked, this,
                    [this, first, second](double first_K, double second_K) {
                        emit targetsPicked(first, second, first_K, second_K);
                    });
            connect(map, &ReachMap::dragDropped, this, &PairsView::dragDropped);
            m_maps.push_back(map);
        }
    arrange();
}

/// The number of columns with which all maps are in view and largest; where none does, as many as have room.
void PairsView::arrange() {
    if (m_maps.empty())
        return;
    const int count = static_cast<int>(m_maps.size());
    const int gap = m_grid->spacing();
    const int wide = m_scroll->width() - m_scroll->verticalScrollBar()->sizeHint().width();
    int columns = std::clamp((wide + gap) / (kMinSide + gap), 1, count);
    int side = (wide + gap) / columns - gap;
    for (int c = columns, best = kMinSide; c >= 1; --c) {
        const int rows = (count + c - 1) / c;
        const int whole = std::min((wide + gap) / c, (m_scroll->height() + gap) / rows) - gap;
        if (whole < best)
            continue;
        best = side = whole;
        columns = c;
    }
    side = std::clamp(side, kMinSide, kMaxSide);
    for (int i = 0; i < count; ++i) {
        ReachMap* map = m_maps[static_cast<std::size_t>(i)];
        map->setFixedSize(side, side);
        m_grid->addWidget(map, i / columns, i % columns); // moves one that is there
    }
}

void PairsView::askAndExport() {
    const QString folder = askFolder(this, tr("Folder for the tables and pictures"), FileFolder::Exports);
    if (!folder.isEmpty())
        exportTo(folder);
}

void PairsView::exportTo(const QString& folder) {
    std::vector<std::string> names;
    for (const ObjectSpec& object : m_experiment.objects)
        names.push_back(object.name);
    std::vector<ExportedMap> maps;
    QStringList files;
    for (std::size_t i = 0; i < m_made.size(); ++i) {
        const ReachableMap& map = m_made[i];
        const QString stem = QString::fromStdString(reachableFileStem(map.first, map.second));
        QImage picture = m_maps[i]->picture(kPicture, kPictureScale);
        markPicture(picture, QLatin1String(kReachableMark));
        maps.push_back({QDir(folder).filePath(stem), map, std::move(picture)});
        files << tableOf(maps.back()) << pictureOf(maps.back());
    }
    m_export.run(
        [maps = std::move(maps), names = std::move(names)] { return writeMaps(maps, names); },
        [this, folder, files](Result<void> written) {
            if (!written)
                emit problem(QStringLiteral("%1: %2").arg(QString::fromStdString(written.error().where),
                                                          messageText(written.error().message)));
            else
                emit exported(tr("Tables and pictures of the pairs written to %1").arg(folder), files);
        });
}

void PairsView::showAll() {
    const bool dark = isDark(this);
    std::size_t i = 0;
    bool placed = !m_stale && !m_made.empty();
    for (std::size_t first = 0; first < m_experiment.objects.size(); ++first)
        for (std::size_t second = first + 1; second < m_experiment.objects.size(); ++second, ++i) {
            const ObjectSpec& a = m_experiment.objects[first];
            const ObjectSpec& b = m_experiment.objects[second];
            ReachMap& map = *m_maps[i];
            map.setNames(QString::fromStdString(a.name), QString::fromStdString(b.name));
            map.setTarget_K({a.target_K, b.target_K});
            map.setStale(m_stale);
            map.setTemperatureUnit(m_unit);
            map.setEditable(m_editable);
            placed = placed && m_made[i].target_K == Eigen::Vector2d(a.target_K, b.target_K);
        }
    const bool nothing = m_maps.empty() || (!m_stale && m_made.empty());
    m_note->setText(m_maps.empty()
                        ? tr("Maps need two objects or more.")
                        : tr("No pose of the workspace keeps the clearance: there is nothing to map."));
    m_note->setVisible(nothing);
    m_scroll->setVisible(!nothing);
    for (QLabel* label : {m_caption, m_rareColour, m_rare, m_few, m_colours, m_many})
        label->setVisible(!nothing);
    m_caption->setText(tr("Which temperatures two objects can have together, whatever the others do. Drag a "
                          "point, or double-click, to set their targets."));
    m_rare->setText(tr("rare"));
    m_rare->setToolTip(tr("Some pose has both, found by search; none of the poses that were counted does."));
    m_few->setText(tr("few poses"));
    m_many->setText(tr("many (log)"));
    m_colours->setPixmap(colourBar(dark, {60, 10}, devicePixelRatioF()));
    QPixmap rare(QSize(10, 10) * devicePixelRatioF());
    rare.fill(rareColour(palette()));
    rare.setDevicePixelRatio(devicePixelRatioF());
    m_rareColour->setPixmap(rare);
    m_colours->setToolTip(tr("Share of the workspace's poses at which the pair settles there, on a "
                             "logarithmic scale. Where it is small, the pair asks for a pose that is hard to "
                             "keep."));
    for (QLabel* label : {m_caption, m_rare, m_few, m_many, m_note})
        label->setPalette(captionPalette(palette()));
    m_exportButton->setText(tr("Export\u2026"));
    m_exportButton->setToolTip(tr("Write each map as a table (CSV) and as a picture (PNG)."));
    m_exportButton->setVisible(!nothing);
    m_exportButton->setEnabled(placed);
}

void PairsView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    emit wanted(true);
}

void PairsView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit wanted(false);
}

void PairsView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void PairsView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showAll();
    QWidget::changeEvent(event);
}

} // namespace bask
