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
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QStackedWidget>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <string>

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

    /// What its parents leave of it; what is scrolled is seen in time, but nothing brings what is beside a
    /// part that is scrolled up and down only.
    static QSize seenOf(const QWidget* widget) {
        QRect seen = widget->rect();
        QPoint offset;
        for (const QWidget* w = widget; !w->isWindow(); w = w->parentWidget()) {
            const QWidget* part = w->parentWidget()->parentWidget();
            if (part != nullptr && part->objectName() == QLatin1String("partScroll"))
                break; // a whole page
            if (const auto* area = qobject_cast<const QAbstractScrollArea*>(w->parentWidget())) {
                if (area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff)
                    return widget->size();
                const int left = widget->mapTo(w, QPoint(0, 0)).x();
                return {std::min(left + widget->width(), w->width()) - std::max(left, 0), widget->height()};
            }
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

class EverySizeTest : public LegibleTest {}; // takes minutes

/// Of the window at a size: what is always told in words, the way to each page, the plots of Review.
QStringList wrongAt(MainWindow& window, QSize size) {
    QStringList wrong;
    const auto expect = [&](bool holds, const QString& what) {
        if (!holds)
            wrong << what;
    };
    const auto words = [](QSize of) { return QStringLiteral("%1 x %2").arg(of.width()).arg(of.height()); };
    const QSize least = window.minimumSizeHint();
    expect(least.width() <= size.width() && least.height() <= size.height(),
           QStringLiteral("wants ") + words(least));
    expect(window.size() == size, QStringLiteral("is ") + words(window.size()));
    const auto seen = [&](const char* name) {
        const auto* part = window.findChild<QWidget*>(QLatin1String(name));
        const bool isWhole = part != nullptr && part->isVisible() &&
                             part->visibleRegion().boundingRect() == part->rect() &&
                             window.rect().contains(QRect(part->mapTo(&window, QPoint(0, 0)), part->size()));
        const QSize wanted = part != nullptr ? part->sizeHint() : QSize();
        expect(isWhole && part->width() >= wanted.width(),
               QStringLiteral("%1 is not seen whole").arg(QLatin1String(name)));
    };
    for (const char* name : {"tagWord", "runStateChip", "stopButton"})
        seen(name);
    expect(!window.findChild<QLabel*>(QStringLiteral("tagWord"))->text().isEmpty(),
           QStringLiteral("no SIMULATED"));
    for (int page = 0; page < kPages; ++page)
        seen(("page." + std::to_string(page)).c_str());
    if (window.pages().page() == Page::Review) {
        int plots = 0;
        for (const TracePlot* plot : window.findChildren<TracePlot*>())
            if (plot->isVisible()) {
                ++plots;
                expect(plot->height() >= 180, QStringLiteral("a plot of %1 px").arg(plot->height()));
            }
        expect(plots == 2, QStringLiteral("%1 plots").arg(plots));
    }
    return wrong;
}

// Catches: a window that wants more than the screen has, a width or height in pixels that larger text does
// not fit, parts that a page which scrolls presses together, a page without its button, SIMULATED, the state
// or STOP without words, and plots too low to read. A screen whose scale, or Bask's own text size, is 150 or
// 200 % has the room of a smaller one; larger letters alone are those of a desktop.
TEST_F(EverySizeTest, EachPageIsRightWhateverTheScreenAndTheTextAre) {
    struct Screens {
        double text;
        std::vector<QSize> sizes;
    };
    const bool isDense = QApplication::primaryScreen()->devicePixelRatio() > 1.0;
    std::vector<Screens> all{{1.0, {}}, {1.5, {}}, {2.0, {}}};
    for (const QSize screen : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)})
        for (Screens& of : all) {
            all[0].sizes.push_back((QSizeF(screen) / of.text).toSize());
            if (of.text > 1.0)
                of.sizes.push_back(screen);
        }
    if (isDense) { // where nothing but the pixels differ
        all.resize(1);
        std::erase_if(all[0].sizes, [](QSize size) { return size.width() > 1280; });
    }
    const QFont before = QApplication::font();
    for (const Screens& of : all) {
        QFont font = before;
        font.setPointSizeF(before.pointSizeF() * of.text);
        QApplication::setFont(font);
        openWindow(of.sizes.back());
        ASSERT_NO_FATAL_FAILURE(holdARunAndOpenIt());
        for (const QSize& size : of.sizes) {
            window->resize(size);
            for (const char* language : {"en", "fr", "zh_CN", "zh_TW"}) {
                window->setLanguage(QLatin1String(language));
                onEachPage([&](int page) {
                    const auto wrong = [&] {
                        return wrongAt(*window, size) + Cut(window.get(), Cut::Room::Scarce).found();
                    };
                    waitFor([&] { return wrong().isEmpty(); }, 2000); // layouts settle
                    EXPECT_TRUE(wrong().isEmpty()) << language << ", page " << page << ", " << size.width()
                                                   << " x " << size.height() << ", text " << of.text << "\n  "
                                                   << wrong().join(QStringLiteral("\n  ")).toStdString();
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
        for (const auto* scroll : find<QWidget>("recipePanel")->findChildren<QScrollArea*>())
            EXPECT_FALSE(scroll->horizontalScrollBar()->isVisible()) << language;
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
