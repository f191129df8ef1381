#include "widgets/objects/object_list.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QApplication>
#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>

namespace bask {
namespace {

constexpr int kKindRole = Qt::UserRole;

/// Two lines a row, the object's line sample before them.
class ObjectDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
        return {120, 2 * option.fontMetrics.height() + 16};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem item = option;
        initStyleOption(&item, index);
        const QString name = item.text;
        item.text.clear();
        item.widget->style()->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);

        const bool dark = isDark(item.palette);
        const bool selected = item.state.testFlag(QStyle::State_Selected);
        const QRect text = textRect(option.rect);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(selected ? QPen(Qt::white, 1.5) : QPen(Qt::NoPen));
        painter->setBrush(seriesColor(index.row(), dark));
        painter->drawRoundedRect(
            QRectF(option.rect.left() + 9, option.rect.top() + 9, 6, option.rect.height() - 18), 3.0, 3.0);
        QFont bold = option.font;
        bold.setWeight(QFont::DemiBold);
        painter->setFont(bold);
        painter->setPen(item.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        const QRect first(text.left(), text.top(), text.width(), text.height() / 2);
        painter->drawText(first, Qt::AlignLeft | Qt::AlignBottom,
                          QFontMetrics(bold).elidedText(name, Qt::ElideRight, first.width()));
        painter->setFont(option.font);
        if (!selected)
            painter->setPen(secondaryText(dark));
        const QRect second = first.translated(0, text.height() / 2);
        painter->drawText(
            second, Qt::AlignLeft | Qt::AlignVCenter,
            option.fontMetrics.elidedText(index.data(kKindRole).toString(), Qt::ElideRight, second.width()));
        painter->restore();
    }

    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex&) const override {
        editor->setGeometry(textRect(option.rect).adjusted(-3, 2, 0, -2));
    }

private:
    static QRect textRect(const QRect& row) { return row.adjusted(24, 4, -6, -4); }
};

} // namespace

ObjectList::ObjectList(QWidget* parent) : QListWidget(parent) {
    setItemDelegate(new ObjectDelegate(this));
    setRenamable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!m_filling)
            emit objectSelected(row);
    });
    connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!m_filling)
            emit objectRenamed(row(item), item->text().trimmed());
    });
    refresh();
}

void ObjectList::setObjects(const std::vector<ObjectSpec>& objects, int selected, TemperatureUnit unit) {
    m_objects = objects;
    m_unit = unit;
    m_filling = true;
    while (count() > static_cast<int>(objects.size()))
        delete takeItem(count() - 1);
    while (count() < static_cast<int>(objects.size())) {
        auto* item = new QListWidgetItem(this);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    setCurrentRow(selected);
    m_filling = false;
    refresh();
}

void ObjectList::setRenamable(bool renamable) {
    setEditTriggers(renamable ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                              : QAbstractItemView::NoEditTriggers);
}

QString ObjectList::kindText(const ObjectSpec& object) const {
    const auto* disk = outlineAs<Disk>(object.shape);
    const auto* series = outlineAs<FourierContour>(object.shape);
    const QString kind = disk     ? tr("disk, %1 cm").arg(QLocale().toString(disk->radius_m * 100.0, 'g', 4))
                         : series ? harmonicsText(series->harmonics())
                                  : tr("polygon");
    const std::size_t holes = holesOf(object.shape).size();
    return holes > 0 ? kind + QStringLiteral(", ") + holesText(holes) : kind;
}

void ObjectList::refresh() {
    setAccessibleName(tr("Objects"));
    m_filling = true;
    for (int i = 0; i < count(); ++i) {
        const ObjectSpec& object = m_objects[static_cast<std::size_t>(i)];
        const QString name = QString::fromStdString(object.name);
        const QString kind = tr("%1 \u00b7 %2", "kind and target of an object")
                                 .arg(kindText(object), formatTemperature(object.target_K, m_unit));
        item(i)->setText(name);
        item(i)->setData(kKindRole, kind);
        item(i)->setData(Qt::AccessibleDescriptionRole, kind);
        item(i)->setToolTip(tr("%1: %2. Press F2 to rename.").arg(name, kind));
    }
    m_filling = false;
}

void ObjectList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        refresh();
    QListWidget::changeEvent(event);
}

} // namespace bask
