#pragma once
// Help > Manual: the files of docs/, as they are in the program.

#include <QWidget>

class QLineEdit;
class QPushButton;
class QTextBrowser;

namespace bask {

/// A window of its own, so that it can stand beside the rig's. Object names: "manual", its text
/// "manualText", "manualBack", "manualContents", "manualFind".
class ManualWindow : public QWidget {
    Q_OBJECT

public:
    /// `parent`'s window is stayed above and closed with.
    explicit ManualWindow(QWidget* parent);

    /// "safety.md", "manual.md#keys"; a name that is not there shows the contents.
    void open(const QString& page);

    static QStringList pages();
    /// The text of a page's headings as a link names them: "The first five minutes" is
    /// "the-first-five-minutes".
    static QString anchorOf(const QString& heading);

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow(const QString& link);
    void show(const QString& page, const QString& anchor);
    void toHeading(const QString& anchor);
    void back();
    void find();
    void retranslate();

    QTextBrowser* m_text;
    QPushButton *m_back, *m_contents;
    QLineEdit* m_find;
    QString m_page;
    QStringList m_before; ///< pages with their anchors
};

} // namespace bask
