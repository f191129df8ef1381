#pragma once
// Help > Manual: the files of docs/, as they are in the program, in the window's language where they are
// translated.

#include <QWidget>

class QLineEdit;
class QPushButton;
class QTextBrowser;
class QTextDocument;

namespace bask {

class Language;

/// A window of its own, so that it can stand beside the rig's. Object names: "manual", its text
/// "manualText", "manualBack", "manualContents", "manualFind".
class ManualWindow : public QWidget {
    Q_OBJECT

public:
    /// `parent`'s window is stayed above and closed with. `language` is that of the pages, now and after each
    /// LanguageChange; it has to outlive this.
    ManualWindow(const Language& language, QWidget* parent);

    /// "safety.md", "../safety.md", "manual.md#keys"; a name that is not there shows the contents. Headings
    /// go by the page's own language or by English.
    void open(const QString& page);

    /// The names of all pages, each of which is there in English.
    static QStringList pages();
    /// The text of a page's headings as a link names them: "The first five minutes" is
    /// "the-first-five-minutes".
    static QString anchorOf(const QString& heading);

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow(const QString& link);
    /// In Markdown.
    QString shownText(const QString& page) const;
    void show(const QString& page, const QString& anchor);
    void showAgain();
    void toHeading(const QString& anchor);
    void back();
    void find();
    void retranslate();

    const Language& m_language;
    QTextBrowser* m_text;
    QTextDocument* m_document = nullptr; ///< the page, once there is one
    QPushButton *m_back, *m_contents;
    QLineEdit* m_find;
    QString m_page;
    QStringList m_before; ///< pages with their anchors
};

} // namespace bask
