#pragma once
// Help > Manual: the files of docs/ inside the program, in the window's language if they are translated.

#include "app/desktop_files.h"

#include <QWidget>

class QLineEdit;
class QPushButton;
class QTextBrowser;
class QTextDocument;

namespace bask {

class Language;

/// A separate window, so that it can be placed beside the rig's window. Object names: "manual", its text
/// "manualText", "manualBack", "manualContents", "manualFind".
class ManualWindow : public QWidget {
    Q_OBJECT

public:
    /// The manual stays above `parent`'s window and closes with it. `language` is that of the pages, now and
    /// after each LanguageChange; it must outlive this object.
    ManualWindow(const Language& language, QWidget* parent);

    /// Opens "safety.md", "../safety.md" or "manual.md#keys"; an unknown name shows the contents. Headings
    /// are found in the page's own language or in English.
    void open(const QString& page);

    /// What opens links into the web.
    DesktopFiles& desktop() { return m_desktop; }

    /// Returns the names of all pages; each of them exists in English.
    static QStringList pages();
    /// Returns the link name of a heading: "The first five minutes" becomes "the-first-five-minutes".
    static QString anchorOf(const QString& heading);

signals:
    void problem(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow(const QString& link);
    /// Returns the shown text in Markdown.
    QString shownText(const QString& page) const;
    void show(const QString& page, const QString& anchor);
    void showAgain();
    void toHeading(const QString& anchor);
    void back();
    void find();
    void retranslate();

    const Language& m_language;
    DesktopFiles m_desktop;
    QTextBrowser* m_text;
    QTextDocument* m_document = nullptr; ///< the page; null before the first
    QPushButton *m_back, *m_contents;
    QLineEdit* m_find;
    QString m_page;
    QStringList m_before; ///< pages with their anchors
};

} // namespace bask
