// What a screen reader is told: the name of whatever Tab reaches, and beside names the numbers and words that
// are shown.

#include "tests/app/window_fixture.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableView>
#include <QTreeView>

#include <functional>

namespace bask::test {
namespace {

/// All that is said of a widget, or of a cell, by itself.
QString said(const QAccessibleInterface* told) {
    if (told == nullptr)
        return {};
    QStringList words;
    for (const QAccessible::Text kind : {QAccessible::Name, QAccessible::Value, QAccessible::Description})
        words << told->text(kind);
    return words.join(u'\n');
}

QString saidOf(QWidget* widget) {
    return said(QAccessible::queryAccessibleInterface(widget));
}

QString nameSaidOf(QWidget* widget) {
    const QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
    return told == nullptr ? QString() : told->text(QAccessible::Name).trimmed();
}

/// What is said of it beside what it shows: on this system a choice's name is what is chosen.
QString nameBesideValue(QWidget* widget) {
    const auto* choice = qobject_cast<QComboBox*>(widget);
    if (choice == nullptr)
        return nameSaidOf(widget);
    const QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
    QString words = told->text(QAccessible::Description).remove(choice->currentText());
    for (const auto& [label, relation] : told->relations(QAccessible::Label))
        words += label->text(QAccessible::Name);
    return words.trimmed();
}

std::string placeOf(const QWidget* widget) {
    QStringList path;
    for (const QWidget* w = widget; w != nullptr && path.size() < 3; w = w->parentWidget())
        path << QLatin1String(w->metaObject()->className()) + u' ' + w->objectName();
    return path.join(QStringLiteral(" in ")).toStdString();
}

/// Whether Tab stops here, once it is enabled; what only scrolls, or hands the keyboard to a part of it, says
/// nothing itself.
bool isStop(const QWidget* widget) {
    const QWidget* parent = widget->parentWidget();
    return (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->focusProxy() == nullptr &&
           qobject_cast<const QScrollArea*>(widget) == nullptr &&
           !(parent != nullptr && parent->focusProxy() == widget);
}

class ScreenReaderTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        QAccessible::setActive(true);
    }
    void TearDown() override {
        QAccessible::setActive(false);
        WindowTest::TearDown();
    }

    /// Every page with each of its tabs, and each part of what Review shows of a run.
    void onEachView(const std::function<void(const std::string&)>& look) {
        for (int page = 0; page < kPages; ++page) {
            window->pages().show(static_cast<Page>(page));
            const std::string where = "page " + std::to_string(page);
            waitForLayouts();
            look(where);
            for (QTabBar* tabs : visible<QTabBar>())
                for (int i = 0, before = tabs->currentIndex(); i <= tabs->count(); ++i) {
                    if (i < tabs->count() && (i == before || !tabs->isTabVisible(i)))
                        continue;
                    tabs->setCurrentIndex(i < tabs->count() ? i : before);
                    waitForLayouts();
                    look(where + ", " + tabs->tabText(tabs->currentIndex()).toStdString());
                }
        }
        auto* details = find<QComboBox>("reviewDetails");
        ASSERT_TRUE(details->isVisible()) << "no run is open";
        for (int i = 0; i < details->count(); ++i) {
            details->setCurrentIndex(i);
            waitForLayouts();
            look(details->currentText().toStdString());
        }
    }

    template <class Widget> QList<Widget*> visible() {
        QList<Widget*> shown;
        for (Widget* widget : window->findChildren<Widget*>())
            if (widget->isVisible())
                shown << widget;
        return shown;
    }

    QWidget* shown(const QString& name) {
        for (QWidget* widget : visible<QWidget>())
            if (widget->objectName() == name)
                return widget;
        return nullptr;
    }
};

/// A tree that is unfolded as it is, a table or a list.
void lookAtCells(QAbstractItemView& view, const QModelIndex& parent, const std::string& where, int& looked) {
    const QAbstractItemModel& model = *view.model();
    const auto* table = qobject_cast<const QTableView*>(&view);
    const auto* tree = qobject_cast<const QTreeView*>(&view);
    for (int row = 0; row < model.rowCount(parent); ++row) {
        QString wholeRow;
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex cell = model.index(row, column, parent);
            if ((table != nullptr && table->isColumnHidden(column)) ||
                (tree != nullptr && tree->isColumnHidden(column)))
                continue;
            const QString told = cell.data(Qt::AccessibleTextRole).toString();
            const QString shown = cell.data().toString();
            const QString words =
                (told.isEmpty() ? shown : told) + cell.data(Qt::AccessibleDescriptionRole).toString();
            wholeRow += words;
            EXPECT_TRUE(words.contains(shown)) << where << ": " << shown.toStdString();
            EXPECT_FALSE(words.isEmpty() && cell.data(Qt::DecorationRole).isValid())
                << where << ": a picture without words in cell " << row << ", " << column;
            ++looked;
        }
        EXPECT_FALSE(wholeRow.isEmpty()) << where << ": row " << row;
        const QModelIndex first = model.index(row, 0, parent);
        if (tree != nullptr && tree->isExpanded(first))
            lookAtCells(view, first, where, looked);
    }
}

/// What the view itself tells of its columns and of its first cell: not only its model's roles.
void lookAtTable(QAbstractItemView& view, const std::string& where) {
    QAccessibleInterface* told = QAccessible::queryAccessibleInterface(&view);
    ASSERT_NE(told, nullptr) << where;
    QAccessibleTableInterface* table = told->tableInterface();
    ASSERT_NE(table, nullptr) << where;
    if (table->rowCount() == 0 || table->columnCount() == 0)
        return;
    const auto* columns = qobject_cast<const QTableView*>(&view);
    for (int column = 0; column < table->columnCount(); ++column) {
        const bool isTitled = columns != nullptr && columns->horizontalHeader()->isVisible() &&
                              !columns->isColumnHidden(column);
        EXPECT_FALSE(isTitled && table->columnDescription(column).isEmpty()) << where << ": " << column;
    }
    const QString first = view.model()->index(0, 0).data().toString();
    EXPECT_TRUE(said(table->cellAt(0, 0)).contains(first)) << where << ": " << first.toStdString();
}

// Catches: a control, a plot or a view that Tab reaches and nobody can tell what it is.
TEST_F(ScreenReaderTest, WhateverTabReachesHasAName) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(holdARunAndOpenIt());
    int looked = 0;
    onEachView([&](const std::string& where) {
        for (QWidget* widget : visible<QWidget>()) {
            if (!isStop(widget))
                continue;
            ++looked;
            EXPECT_FALSE(nameBesideValue(widget).isEmpty()) << where << ": " << placeOf(widget);
        }
    });
    EXPECT_GT(looked, 200);
}

// Catches: a value whose name is all that is said of it.
TEST_F(ScreenReaderTest, WhateverALabelShowsIsSaid) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(holdARunAndOpenIt());
    int looked = 0;
    onEachView([&](const std::string& where) {
        for (QLabel* label : visible<QLabel>()) {
            const QString text = label->text();
            if (text.isEmpty() || Qt::mightBeRichText(text) || text.contains(u'&'))
                continue;
            ++looked;
            EXPECT_TRUE(saidOf(label).contains(text))
                << where << ": " << placeOf(label) << " shows " << text.toStdString() << ", says "
                << saidOf(label).toStdString();
        }
    });
    EXPECT_GT(looked, 200);
}

// Catches: a tile or a chip that is named and keeps its number to itself.
TEST_F(ScreenReaderTest, TilesAndChipsSayTheirNumbersAndWords) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(holdARunAndOpenIt());
    window->pages().show(Page::Run);
    QCoreApplication::processEvents();
    const Experiment& experiment = window->document().experiment();
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        QWidget* tile = shown(QStringLiteral("objectTile.%1").arg(i));
        ASSERT_NE(tile, nullptr) << i;
        EXPECT_TRUE(nameSaidOf(tile).contains(QString::fromStdString(experiment.objects[i].name)));
        for (const char* part : {"tileTemperature", "tileState"}) {
            const QString text = tile->findChild<QLabel*>(QLatin1String(part))->text();
            EXPECT_FALSE(text.isEmpty()) << part;
            EXPECT_TRUE(saidOf(tile).contains(text)) << part << ' ' << text.toStdString();
        }
    }
    QWidget* source = shown(QStringLiteral("sourceTile"));
    ASSERT_NE(source, nullptr);
    EXPECT_FALSE(nameSaidOf(source).isEmpty());
    EXPECT_TRUE(saidOf(source).contains(source->findChild<QLabel*>("sourceTileTemperature")->text()));
    auto* chip = find<QAbstractButton>("runStateChip");
    EXPECT_TRUE(nameSaidOf(chip).contains(QStringLiteral("Holding"))) << nameSaidOf(chip).toStdString();
    EXPECT_TRUE(nameSaidOf(find<QWidget>("rigTag")).contains(QStringLiteral("SIMULATED")));
    EXPECT_TRUE(nameSaidOf(find<QWidget>("stopButton")).contains(QStringLiteral("STOP")));
    click("stopRunButton");
    ASSERT_TRUE(waitForState(RunState::Stopped));
    EXPECT_TRUE(waitFor([&] { return nameSaidOf(chip).contains(QStringLiteral("Stopped")); }))
        << "it follows: " << nameSaidOf(chip).toStdString();
}

// Catches: a page that a screen reader cannot turn to, since it toggles the button and not its action, and
// one that it would leave for none.
TEST_F(ScreenReaderTest, TurnsThePages) {
    openWindow();
    for (const int page : {0, 3, 3, 4}) {
        const QByteArray name = QStringLiteral("page.%1").arg(page).toLatin1();
        QAccessibleInterface* told = QAccessible::queryAccessibleInterface(find<QAbstractButton>(name));
        const QStringList can = told->actionInterface()->actionNames();
        ASSERT_FALSE(can.isEmpty());
        told->actionInterface()->doAction(can.front());
        QCoreApplication::processEvents();
        EXPECT_EQ(window->pages().page(), static_cast<Page>(page));
        EXPECT_TRUE(told->state().checked) << page;
    }
}

// Catches: two turns of the page at once, each of which brings its page back when the other has.
TEST_F(ScreenReaderTest, PagesTurnedAtOnceStay) {
    openWindow();
    QSignalSpy turned(&window->pages(), &PageHost::pageChanged);
    window->pages().show(Page::Targets);
    window->pages().show(Page::Rig);
    for (int i = 0; i < 20; ++i)
        QCoreApplication::processEvents();
    EXPECT_EQ(window->pages().page(), Page::Rig);
    EXPECT_EQ(turned.count(), 2);
}

// Catches: a bar of reachable temperatures that only the eye can read.
TEST_F(ScreenReaderTest, BarsOfTargetsSayTheTarget) {
    openWindow();
    window->pages().show(Page::Targets);
    int bars = 0;
    for (QWidget* widget : visible<QWidget>())
        if (widget->inherits("bask::ReachBar")) {
            ++bars;
            EXPECT_FALSE(nameSaidOf(widget).isEmpty());
            EXPECT_TRUE(waitFor([&] { return saidOf(widget).contains(QStringLiteral("40.0")); }))
                << saidOf(widget).toStdString();
        }
    EXPECT_EQ(bars, 3);
}

// Catches: a field of a dialog whose caption belongs to the box around it.
TEST_F(ScreenReaderTest, FieldsOfDialogsHaveNames) {
    openWindow();
    for (const char* action : {"labels", "monitoring"}) {
        window->findChild<QAction*>(QLatin1String(action))->trigger();
        QDialog* dialog = nullptr;
        ASSERT_TRUE(waitFor([&] {
            const QList<QDialog*> open = visible<QDialog>();
            dialog = open.isEmpty() ? nullptr : open.front();
            return dialog != nullptr;
        })) << action;
        int stops = 0;
        for (QWidget* widget : dialog->findChildren<QWidget*>())
            if (widget->isVisible() && isStop(widget)) {
                ++stops;
                EXPECT_FALSE(nameBesideValue(widget).isEmpty()) << placeOf(widget);
            }
        EXPECT_GE(stops, 4) << action;
        dialog->reject();
        ASSERT_TRUE(waitFor([&] { return visible<QDialog>().isEmpty(); })) << action;
    }
}

// Catches: a cell that shows a picture only, a table without a name or without its columns' names.
TEST_F(ScreenReaderTest, TablesSayTheirCells) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(holdARunAndOpenIt());
    int cells = 0;
    onEachView([&](const std::string& where) {
        for (QAbstractItemView* view : visible<QAbstractItemView>()) {
            if (qobject_cast<QHeaderView*>(view) != nullptr || view->model() == nullptr)
                continue;
            const std::string place = where + ": " + placeOf(view);
            EXPECT_FALSE(nameSaidOf(view).isEmpty()) << place;
            lookAtCells(*view, {}, place, cells);
            lookAtTable(*view, place);
        }
    });
    EXPECT_GT(cells, 60);
}

} // namespace
} // namespace bask::test
