// Every page in every language: no text is cut off, and every control has a name and is reached by keyboard.

#include "tests/app/window_fixture.h"
#include "widgets/common/elided_label.h"
#include "widgets/plots/trace_plot.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QStackedWidget>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>

namespace bask::test {
namespace {

QString nameOf(const QObject* object) {
    return QLatin1String(object->metaObject()->className()) + u' ' + object->objectName();
}

bool isSpinBoxPart(const QWidget* widget) {
    const QWidget* parent = widget->parentWidget();
    return qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
           qobject_cast<const QComboBox*>(parent) != nullptr;
}

/// Texts that the place they have does not hold.
class Cut {
public:
    /// Ample: tabs and titles of columns are whole, too. Scarce: arrows bring tabs, and pointing at a title
    /// tells it.
    enum class Room { Ample, Scarce };
    explicit Cut(const QWidget* window, Room room = Room::Ample) : m_room(room) {
        for (const QWidget* widget : window->findChildren<QWidget*>())
            if (widget->isVisible())
                one(widget);
    }
    const QStringList& found() const { return m_found; }
    int looked() const { return m_looked; }

private:
    void need(const QWidget* widget, QSize needed, const QString& text) {
        ++m_looked;
        const QSize has = seenOf(widget);
        if (needed.width() > has.width() || needed.height() > has.height())
            m_found << QStringLiteral("%1 has %2 x %3, needs %4 x %5: %6")
                           .arg(nameOf(widget))
                           .arg(has.width())
                           .arg(has.height())
                           .arg(needed.width())
                           .arg(needed.height())
                           .arg(text);
    }

    /// What its parents leave of it; what is scrolled is seen in time.
    static QSize seenOf(const QWidget* widget) {
        QRect seen = widget->rect();
        QPoint offset;
        for (const QWidget* w = widget; !w->isWindow(); w = w->parentWidget()) {
            const QWidget* part = w->parentWidget()->parentWidget();
            if (part != nullptr && part->objectName() == QLatin1String("partScroll"))
                break; // a whole page
            if (qobject_cast<const QAbstractScrollArea*>(w->parentWidget()))
                return widget->size();
            offset += w->pos();
            seen &= w->parentWidget()->rect().translated(-offset);
        }
        return seen.size();
    }

    void one(const QWidget* widget) {
        if (const auto* label = qobject_cast<const QLabel*>(widget); label && !label->text().isEmpty()) {
            if (const auto* elided =
                    qobject_cast<const ElidedLabel*>(label)) // pointing at it tells the whole
                need(elided, elided->minimumSizeHint(), elided->text());
            else if (label->wordWrap())
                need(label, {label->minimumSizeHint().width(), label->heightForWidth(label->width())},
                     label->text());
            else
                need(label, label->sizeHint(), label->text());
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            if (!button->text().isEmpty() && button->minimumSizeHint().isValid())
                need(button, button->minimumSizeHint(), button->text());
        } else if (const auto* plot = qobject_cast<const TracePlot*>(widget)) {
            const QString title = plot->shownAxisLabel(); // written upwards
            need(plot, {0, plot->fontMetrics().horizontalAdvance(title)}, title);
        } else if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
            QStyleOptionComboBox option;
            option.initFrom(combo);
            option.editable = combo->isEditable();
            const QRect field = combo->style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                               QStyle::SC_ComboBoxEditField, combo);
            const int width = combo->fontMetrics().horizontalAdvance(combo->currentText());
            need(combo, {combo->width() + width - field.width(), 0}, combo->currentText());
        } else if (const auto* box = qobject_cast<const QAbstractSpinBox*>(widget)) {
            const auto* edit = box->findChild<QLineEdit*>();
            const int width = edit->fontMetrics().horizontalAdvance(edit->text());
            need(box, {box->width() + width - edit->contentsRect().width(), 0}, edit->text());
        } else if (const auto* header = qobject_cast<const QHeaderView*>(widget)) {
            for (int i = 0; header->orientation() == Qt::Horizontal && i < header->count(); ++i)
                if (!header->isSectionHidden(i)) {
                    const int hint = header->sectionSizeHint(i);
                    ++m_looked;
                    const bool isTold =
                        m_room == Room::Scarce &&
                        header->model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).isValid();
                    if (header->sectionSize(i) < hint && !isTold)
                        m_found << QStringLiteral("%1 of %2 has %3, needs %4: %5")
                                       .arg(nameOf(header), nameOf(header->parent()))
                                       .arg(header->sectionSize(i))
                                       .arg(hint)
                                       .arg(header->model()->headerData(i, Qt::Horizontal).toString());
                }
        } else if (const auto* bar = qobject_cast<const QTabBar*>(widget)) {
            need(bar, m_room == Room::Scarce ? bar->minimumSizeHint() : bar->sizeHint(), bar->tabText(0));
        } else if (const auto* table = qobject_cast<const QTableView*>(widget)) {
            cells(*table);
        }
    }

    /// A cell may be shorter than its text if pointing at it tells the whole.
    void cells(const QTableView& table) {
        const QAbstractItemModel& model = *table.model();
        for (int row = 0; row < model.rowCount(); ++row)
            for (int column = 0; column < model.columnCount(); ++column) {
                const QModelIndex index = model.index(row, column);
                const QString text = index.data().toString();
                if (text.isEmpty() || table.isColumnHidden(column) || table.indexWidget(index))
                    continue;
                ++m_looked;
                const int margin = 2 * (table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
                const int width = table.fontMetrics().horizontalAdvance(text) + margin;
                if (width > table.columnWidth(column) && index.data(Qt::ToolTipRole).toString().isEmpty())
                    m_found << QStringLiteral("cell %1, %2 of %3 has %4, needs %5: %6")
                                   .arg(row)
                                   .arg(column)
                                   .arg(nameOf(&table))
                                   .arg(table.columnWidth(column))
                                   .arg(width)
                                   .arg(text);
            }
    }

    const Room m_room;
    QStringList m_found;
    int m_looked = 0;
};

bool isControl(const QWidget* widget) {
    if (isSpinBoxPart(widget))
        return false;
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
           qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           (qobject_cast<const QAbstractSlider*>(widget) && !qobject_cast<const QScrollBar*>(widget)) ||
           (qobject_cast<const QAbstractItemView*>(widget) && !qobject_cast<const QHeaderView*>(widget));
}

bool hasShortcut(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    if (button == nullptr)
        return false;
    if (qobject_cast<const QLineEdit*>(widget->parentWidget()))
        return true; // clears it, as its keys do
    const auto* tool = qobject_cast<const QToolButton*>(widget);
    return !button->shortcut().isEmpty() ||
           (tool && tool->defaultAction() && !tool->defaultAction()->shortcuts().isEmpty());
}

constexpr QSize kSmall{1024, 700};

bool isScrolled(const QWidget& page, Qt::Orientation way) {
    const auto* scroll = qobject_cast<const QScrollArea*>(page.parentWidget()->parentWidget());
    return (way == Qt::Horizontal ? scroll->horizontalScrollBar() : scroll->verticalScrollBar())->isVisible();
}

class LegibleTest : public WindowTest {
protected:
    template <class Look> void onEachPage(Look look) {
        for (int page = 0; page < kPages; ++page) {
            window->pages().show(static_cast<Page>(page));
            waitForLayouts();
            look(page);
            if (page != static_cast<int>(Page::Objects))
                continue;
            auto* tabs = find<QTabBar>("objectTabs");
            tabs->setCurrentIndex(1);
            QCoreApplication::processEvents();
            look(page);
            tabs->setCurrentIndex(0);
        }
    }

    /// In front in the dock, with steps.
    void showRecipe() {
        const QList<QAction*> examples = find<QMenu>("recipeFileMenu")->actions().at(2)->menu()->actions();
        ASSERT_FALSE(examples.isEmpty());
        examples.front()->trigger();
        find<QTabWidget>("dockTabs")->setCurrentWidget(find<QWidget>("recipePanel"));
        ASSERT_TRUE(find<QWidget>("recipePanel")->isVisible());
    }

    const QWidget& pageAt(int page) {
        return *qobject_cast<QScrollArea*>(find<QStackedWidget>("pages")->widget(page))->widget();
    }
};

// Catches: a translation longer than its place, a column too narrow, a row of buttons pushed together.
TEST_F(LegibleTest, NoTextIsCutOffInAnyLanguage) {
    openWindow(kSmall);
    ASSERT_NO_FATAL_FAILURE(holdARunAndOpenIt());
    int looked = 0;
    for (const char* language : {"en", "fr", "zh_CN", "zh_TW"}) {
        window->setLanguage(QLatin1String(language));
        onEachPage([&](int page) {
            waitFor([this] { return Cut(window.get()).found().isEmpty(); }, 2000); // layouts settle
            const Cut cut(window.get());
            looked += cut.looked();
            const bool isLow =
                page == static_cast<int>(Page::Objects) || page == static_cast<int>(Page::Review);
            EXPECT_FALSE(isScrolled(pageAt(page), Qt::Horizontal) && page != static_cast<int>(Page::Objects))
                << language << ", page " << page << " of " << pageAt(page).minimumSizeHint().width();
            EXPECT_FALSE(isScrolled(pageAt(page), Qt::Vertical) && !isLow) << language << ", page " << page;
            EXPECT_TRUE(cut.found().isEmpty()) << language << ", page " << page << "\n  "
                                               << cut.found().join(QStringLiteral("\n  ")).toStdString();
        });
    }
    EXPECT_GT(looked, 1000);
}

// Catches: a width or height in pixels that larger text does not fit, and parts that a page which scrolls
// presses together. A screen whose scale is 150 or 200 % has the room of a smaller one.
TEST_F(LegibleTest, NoTextIsCutOffWhateverTheScreenAndTheTextAre) {
    struct Screens {
        double text;
        std::vector<QSize> sizes;
    };
    const Screens all[] = {
        {1.0, {{640, 360}, {683, 467}, {853, 533}, {1920, 1080}}},
        {1.5, {{1280, 800}}},
        {2.0, {{1920, 1080}}},
    };
    const QFont before = QApplication::font();
    for (const Screens& screens : all) {
        QFont font = before;
        font.setPointSizeF(before.pointSizeF() * screens.text);
        QApplication::setFont(font);
        openWindow(screens.sizes.front());
        ASSERT_NO_FATAL_FAILURE(holdARunAndOpenIt());
        for (const QSize& size : screens.sizes) {
            window->resize(size);
            for (const char* language : {"en", "fr", "zh_CN", "zh_TW"}) {
                window->setLanguage(QLatin1String(language));
                onEachPage([&](int page) {
                    waitFor([this] { return Cut(window.get(), Cut::Room::Scarce).found().isEmpty(); },
                            2000); // layouts settle
                    const Cut cut(window.get(), Cut::Room::Scarce);
                    EXPECT_TRUE(cut.found().isEmpty())
                        << language << ", page " << page << ", " << size.width() << " x " << size.height()
                        << ", text " << screens.text << "\n  "
                        << cut.found().join(QStringLiteral("\n  ")).toStdString();
                });
            }
        }
        closeWindow();
    }
    QApplication::setFont(before);
}

// Catches: buttons of the recipe that a small window cuts off.
TEST_F(LegibleTest, TheRecipeIsNotCutOffInAnyLanguage) {
    openWindow(kSmall);
    window->pages().show(Page::Run);
    for (const char* language : {"en", "fr", "zh_CN", "zh_TW"}) {
        window->setLanguage(QLatin1String(language));
        ASSERT_NO_FATAL_FAILURE(showRecipe());
        waitFor([this] { return Cut(window.get()).found().isEmpty(); }, 2000);
        const Cut cut(window.get());
        EXPECT_TRUE(cut.found().isEmpty())
            << language << ", recipe\n  " << cut.found().join(QStringLiteral("\n  ")).toStdString();
    }
}

// Catches: a control that a screen reader cannot name.
TEST_F(LegibleTest, EveryControlHasAName) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(showRecipe());
    int looked = 0;
    onEachPage([&](int page) {
        for (QWidget* widget : window->findChildren<QWidget*>()) {
            if (!widget->isVisible() || !isControl(widget))
                continue;
            ++looked;
            const QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
            EXPECT_FALSE(told == nullptr || told->text(QAccessible::Name).isEmpty())
                << "page " << page << ": " << nameOf(widget).toStdString();
        }
    });
    EXPECT_GT(looked, 100);
}

// Catches: a control that only the mouse reaches, and a table that Tab never leaves.
TEST_F(LegibleTest, EveryControlIsReachedByKeyboard) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(showRecipe());
    onEachPage([&](int page) {
        for (const QWidget* widget : window->findChildren<QWidget*>()) {
            if (!widget->isVisible() || !isControl(widget))
                continue;
            const auto where = [&] {
                return QStringLiteral("page %1: %2").arg(page).arg(nameOf(widget)).toStdString();
            };
            EXPECT_TRUE((widget->focusPolicy() & Qt::TabFocus) != 0 || hasShortcut(widget)) << where();
            const auto* view = qobject_cast<const QAbstractItemView*>(widget);
            EXPECT_FALSE(view != nullptr && view->tabKeyNavigation()) << where();
        }
    });
}

} // namespace
} // namespace bask::test
