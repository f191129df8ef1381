// Switches the language while the program runs and reads everything that is on the screen.

#include "tests/app/mnemonics.h"
#include "tests/app/translation_file.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/language.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/plots/trace_plot.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTableView>
#include <QTreeView>

#include <algorithm>

namespace bask::test {
namespace {

QString bare(QString text) {
    const auto tab = text.indexOf(u'\t');
    return (tab < 0 ? text : text.left(tab)).remove(u'&').trimmed();
}

/// Sentences of one language that must not be seen while the other is on.
class Sentences {
public:
    void add(const QString& text) {
        if (!text.contains(u'%')) {
            m_exact << bare(text);
            return;
        }
        static const QRegularExpression kPlaceholder(QStringLiteral("%L?[1-9n]"));
        QStringList parts = bare(text).split(kPlaceholder);
        QString letters = parts.join(QString());
        letters.remove(QRegularExpression(QStringLiteral("[^a-zA-Z\\x{4e00}-\\x{9fff}]")));
        const bool isChinese = !letters.isEmpty() && letters[0].unicode() >= 0x4e00;
        if (letters.size() < (isChinese ? 2 : 4))
            return;
        const QString longest = *std::ranges::max_element(parts, {}, &QString::size);
        for (QString& part : parts)
            part = QRegularExpression::escape(part);
        m_patterns << qMakePair(longest, QRegularExpression(QRegularExpression::anchoredPattern(
                                             parts.join(QStringLiteral(".*")))));
    }
    bool has(const QString& text) const {
        if (m_exact.contains(text))
            return true;
        const auto known = m_known.constFind(text); // most of them stand on every page
        if (known != m_known.constEnd())
            return *known;
        const bool isOne = std::ranges::any_of(m_patterns, [&](const auto& pattern) {
            return text.contains(pattern.first) && pattern.second.match(text).hasMatch();
        });
        return m_known[text] = isOne;
    }

private:
    QSet<QString> m_exact;
    QList<QPair<QString, QRegularExpression>>
        m_patterns; ///< each with its longest part, which is soon looked for
    mutable QHash<QString, bool> m_known;
};

/// What a person or a screen reader can read of a widget, each with where it stands.
class Reader {
public:
    QList<QPair<QString, QString>> read(QWidget* window) {
        one(window);
        for (QWidget* widget : window->findChildren<QWidget*>())
            if (!widget->objectName().startsWith(QLatin1String("qt_dockwidget_"))) // the dock shows no title
                one(widget);
        for (QAction* action : window->findChildren<QAction*>()) {
            const QString where = QStringLiteral("action ") + action->objectName();
            take(where, action->text());
            take(where, action->toolTip());
            take(where, action->statusTip());
        }
        return m_texts;
    }

private:
    void take(const QString& where, const QString& text) {
        if (!text.trimmed().isEmpty())
            m_texts << qMakePair(where, bare(text));
    }

    void one(QWidget* widget) {
        const QString where = QLatin1String(widget->metaObject()->className()) + u' ' + widget->objectName();
        take(where, widget->toolTip());
        take(where, widget->accessibleName());
        take(where, widget->accessibleDescription());
        if (auto* label = qobject_cast<QLabel*>(widget))
            take(where, label->text());
        if (auto* button = qobject_cast<QAbstractButton*>(widget))
            take(where, button->text());
        if (auto* box = qobject_cast<QGroupBox*>(widget))
            take(where, box->title());
        if (auto* menu = qobject_cast<QMenu*>(widget))
            take(where, menu->title());
        if (auto* edit = qobject_cast<QLineEdit*>(widget))
            take(where, edit->placeholderText());
        if (auto* dock = qobject_cast<QDockWidget*>(widget))
            take(where, dock->windowTitle());
        if (auto* plot = qobject_cast<TracePlot*>(widget)) {
            take(where, plot->valueAxisLabel());
            for (const QString& text : plot->markerTexts())
                take(where, text);
        }
        if (auto* chip = qobject_cast<RunStateChip*>(widget))
            for (const QString& reason : chip->reasons())
                take(where, reason);
        if (auto* combo = qobject_cast<QComboBox*>(widget))
            for (int i = 0; i < combo->count(); ++i)
                take(where, combo->itemText(i));
        if (auto* tabs = qobject_cast<QTabWidget*>(widget))
            for (int i = 0; i < tabs->count(); ++i) {
                take(where, tabs->tabText(i));
                take(where, tabs->tabToolTip(i));
            }
        if (const QVariant suffix = widget->property("suffix"); suffix.isValid())
            take(where, suffix.toString());
        if (auto* view = qobject_cast<QAbstractItemView*>(widget);
            view != nullptr && view->model() != nullptr)
            model(where, *view->model());
    }

    void model(const QString& where, const QAbstractItemModel& items) {
        for (int column = 0; column < items.columnCount(); ++column) {
            take(where, items.headerData(column, Qt::Horizontal).toString());
            for (int row = 0; row < items.rowCount(); ++row) {
                take(where, items.index(row, column).data().toString());
                take(where, items.index(row, column).data(Qt::ToolTipRole).toString());
            }
        }
    }

    QList<QPair<QString, QString>> m_texts;
};

class LanguageSwitchTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        for (const QString& code : Language::codes())
            for (const auto& entry :
                 readTranslations(QStringLiteral(BASK_TRANSLATIONS "/bask_%1.ts")
                                      .arg(code == QLatin1String("en") ? QStringLiteral("fr") : code)))
                m_texts[code] << (code == QLatin1String("en") ? entry.source : entry.translation);
    }

    /// Sentences of the other languages. A word that is also right in this one somewhere ("Source",
    /// "Position") proves nothing.
    Sentences foreignTo(const QString& language) const {
        QSet<QString> own;
        for (const QString& text : m_texts[language])
            own << bare(text);
        Sentences foreign;
        for (const QString& code : Language::codes())
            for (const QString& text : code == language ? QStringList() : m_texts[code])
                if (!own.contains(bare(text)))
                    foreign.add(text);
        return foreign;
    }

    void expectOnly(const QString& language) {
        const Sentences unwanted = foreignTo(language);
        int read = 0;
        for (int page = 0; page < kPages; ++page) {
            window->pages().show(static_cast<Page>(page));
            QCoreApplication::processEvents();
            for (const auto& [where, text] : Reader().read(window.get())) {
                ++read;
                EXPECT_FALSE(unwanted.has(text)) << language.toStdString() << ", page " << page << ", "
                                                 << where.toStdString() << ": " << text.toStdString();
            }
            if (HasFailure())
                return;
        }
        EXPECT_GT(read, 400); // the reader itself works
    }

    void fillEverything() {
        ASSERT_NO_FATAL_FAILURE(startRun(6));
        click("holdButton");
        ASSERT_TRUE(waitForState(RunState::Holding));
        const QString recording = QString::fromStdString(window->lastSnapshot().recordingPath);
        click("stopRunButton");
        ASSERT_TRUE(waitForState(RunState::Stopped));
        openRecording(recording);
    }

    QMap<QString, QStringList> m_texts; ///< by the language's code
};

// Catches: a text made once in a constructor, a string outside tr(), a translation that is missing or not
// loaded, and a mnemonic that two entries of a menu have.
TEST_F(LanguageSwitchTest, NothingIsLeftOfAnotherLanguage) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(fillEverything());
    for (const char* language : {"fr", "zh_CN", "zh_TW", "en"}) {
        window->setLanguage(QLatin1String(language));
        expectOnly(QLatin1String(language));
        for (const QMenu* menu : window->findChildren<QMenu*>()) {
            const QStringList twice = mnemonicsTwice(menu->actions());
            EXPECT_TRUE(twice.isEmpty())
                << language << ": " << twice.join(QStringLiteral("; ")).toStdString();
        }
        keepPictures(QLatin1String(language));
    }
}

// Catches: sentences of the engine and of late-made widgets that miss the language in force.
TEST_F(LanguageSwitchTest, AWholeRunInFrench) {
    SettingsStore().setLanguage(QStringLiteral("fr"));
    openWindow();
    ASSERT_NO_FATAL_FAILURE(fillEverything());
    expectOnly(QStringLiteral("fr"));
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(waitForState(RunState::Fault));
    expectOnly(QStringLiteral("fr"));
    keepPictures(QStringLiteral("french"));
}

} // namespace
} // namespace bask::test
