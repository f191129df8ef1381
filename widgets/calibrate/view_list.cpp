#include "widgets/calibrate/view_list.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QImage>
#include <QLocale>
#include <QSignalBlocker>

#include <optional>

namespace bask {
namespace {

enum ViewColumn { kView, kResidual };
constexpr int kStandsOutRole = Qt::UserRole + 1;
constexpr int kAlarmIcon = 16;

} // namespace

ViewList::ViewList(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("viewList");
    setColumnCount(2);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setIconSize({kPictureWidth, kPictureHeight});
    header()->setSectionResizeMode(kView, QHeaderView::ResizeToContents);
    header()->setStretchLastSection(true);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (column == kView)
            emit usedChanged(indexOfTopLevelItem(item), item->checkState(kView) == Qt::Checked);
    });
    retranslate();
}

void ViewList::add(const QImage& picture) {
    const QSignalBlocker quiet(this);
    auto* item = new QTreeWidgetItem(this);
    item->setText(kView, QString::number(count()));
    item->setIcon(kView, QPixmap::fromImage(picture));
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(kView, Qt::Checked);
    showResidual(item);
    scrollToItem(item);
}

void ViewList::setResidual(int view, std::optional<double> residual_px, bool standsOut) {
    const QSignalBlocker quiet(this);
    QTreeWidgetItem* item = topLevelItem(view);
    item->setData(kResidual, Qt::UserRole, residual_px ? QVariant(*residual_px) : QVariant());
    item->setData(kResidual, kStandsOutRole, standsOut);
    showResidual(item);
}

void ViewList::showResidual(QTreeWidgetItem* item) {
    const QVariant residual_px = item->data(kResidual, Qt::UserRole);
    const bool standsOut = item->data(kResidual, kStandsOutRole).toBool();
    const QString value = residual_px.isValid()
                              ? tr("%1 px").arg(QLocale().toString(residual_px.toDouble(), 'f', 2))
                              : kNoValue;
    item->setText(kResidual, standsOut ? tr("%1, stands out").arg(value) : value);
    item->setIcon(kResidual,
                  standsOut ? QIcon(alarmPixmap(3, isDark(this), kAlarmIcon, devicePixelRatioF())) : QIcon());
}

bool ViewList::isUsed(int view) const {
    return topLevelItem(view)->checkState(kView) == Qt::Checked;
}

void ViewList::setUsed(int view, bool isUsed) {
    topLevelItem(view)->setCheckState(kView, isUsed ? Qt::Checked : Qt::Unchecked);
}

void ViewList::retranslate() {
    const QSignalBlocker quiet(this);
    setHeaderLabels({tr("View"), tr("Residual")});
    setAccessibleName(tr("Views of the calibration"));
    setToolTip(tr("A view that is not ticked is left out."));
    for (int k = 0; k < count(); ++k)
        showResidual(topLevelItem(k));
}

void ViewList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        retranslate();
    QTreeWidget::changeEvent(event);
}

} // namespace bask
