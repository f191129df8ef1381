#include "app/manual_window.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>

namespace bask {
namespace {

const QString kFolder = QStringLiteral(":/manual/");
const QString kContents = QStringLiteral("manual.md");

/// Markdown leaves tables without lines and code without a ground.
void dress(QTextDocument& document, const QPalette& palette) {
    QTextCursor cursor(&document);
    cursor.beginEditBlock(); // or each change is laid out by itself
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table)
            continue;
        QTextTableFormat format = table->format();
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(palette.mid());
        format.setCellPadding(5);
        format.setMargin(8);
        table->setFormat(format);
    }
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        if (format.hasProperty(QTextFormat::BlockCodeFence) || format.nonBreakableLines())
            format.setBackground(palette.alternateBase());
        else if (format.headingLevel() > 1)
            format.setTopMargin(18);
        cursor.setPosition(block.position());
        cursor.setBlockFormat(format);
    }
    cursor.endEditBlock();
}

} // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), m_text(new QTextBrowser), m_back(new QPushButton),
      m_contents(new QPushButton), m_find(new QLineEdit) {
    setObjectName(QStringLiteral("manual"));
    m_text->setObjectName(QStringLiteral("manualText"));
    m_back->setObjectName(QStringLiteral("manualBack"));
    m_contents->setObjectName(QStringLiteral("manualContents"));
    m_find->setObjectName(QStringLiteral("manualFind"));
    m_find->setClearButtonEnabled(true);
    m_text->setOpenLinks(false);
    m_text->document()->setDocumentMargin(16);

    auto* bar = new QHBoxLayout;
    bar->addWidget(m_back);
    bar->addWidget(m_contents);
    bar->addStretch();
    bar->addWidget(m_find);
    auto* column = new QVBoxLayout(this);
    column->addLayout(bar);
    column->addWidget(m_text, 1);

    connect(m_text, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& link) { follow(link.toString()); });
    connect(m_back, &QPushButton::clicked, this, &ManualWindow::back);
    connect(m_contents, &QPushButton::clicked, this, [this] { open(kContents); });
    connect(m_find, &QLineEdit::returnPressed, this, &ManualWindow::find);
    new QShortcut(QKeySequence::Back, this, [this] { back(); });
    new QShortcut(QKeySequence::Find, this, [this] { m_find->setFocus(); });
    new QShortcut(Qt::Key_Escape, this, [this] { close(); });
    resize(860, 720);
    retranslate();
    show(kContents, {});
}

QStringList ManualWindow::pages() {
    return QDir(kFolder).entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name);
}

QString ManualWindow::anchorOf(const QString& heading) {
    static const QRegularExpression kDropped(QStringLiteral("[^\\w\\- ]"));
    return heading.toLower().remove(kDropped).replace(u' ', u'-');
}

void ManualWindow::open(const QString& page) {
    const QString name = page.section(u'#', 0, 0);
    if (isVisible())
        m_before.append(m_page);
    show(pages().contains(name) ? name : kContents, page.section(u'#', 1));
    QWidget::show();
    raise();
    activateWindow();
}

void ManualWindow::follow(const QString& link) {
    if (link.startsWith(QLatin1String("http"))) {
        QDesktopServices::openUrl(QUrl(link));
        return;
    }
    open(link.startsWith(u'#') ? m_page + link : link);
}

void ManualWindow::show(const QString& page, const QString& anchor) {
    QFile file(kFolder + page);
    if (!file.open(QIODevice::ReadOnly))
        return;
    m_page = page;
    m_text->setMarkdown(QString::fromUtf8(file.readAll()));
    dress(*m_text->document(), palette());
    m_text->moveCursor(QTextCursor::Start);
    m_back->setEnabled(!m_before.isEmpty());
    if (!anchor.isEmpty())
        toHeading(anchor);
}

void ManualWindow::toHeading(const QString& anchor) {
    for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || anchorOf(block.text()) != anchor)
            continue;
        m_text->moveCursor(QTextCursor::End); // so that the heading comes to the top
        m_text->setTextCursor(QTextCursor(block));
        m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->value() +
                                              m_text->cursorRect().top());
        return;
    }
}

void ManualWindow::back() {
    if (!m_before.isEmpty())
        show(m_before.takeLast(), {});
}

/// The next one on this page, then on those after it, round and round.
void ManualWindow::find() {
    const QString wanted = m_find->text();
    if (wanted.isEmpty() || m_text->find(wanted))
        return;
    const QStringList names = pages();
    const auto at = names.indexOf(m_page);
    const QString from = m_page;
    for (qsizetype i = 1; i <= names.size(); ++i) {
        show(names[(at + i) % names.size()], {});
        if (m_text->find(wanted)) {
            if (m_page != from)
                m_before.append(from);
            m_back->setEnabled(!m_before.isEmpty());
            return;
        }
    }
}

void ManualWindow::retranslate() {
    setWindowTitle(tr("Bask: manual"));
    m_back->setText(tr("Back"));
    m_contents->setText(tr("Contents"));
    m_find->setPlaceholderText(tr("Find in the manual"));
    m_find->setAccessibleName(m_find->placeholderText());
    m_text->setAccessibleName(tr("Text of the manual"));
}

void ManualWindow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange && !m_page.isEmpty())
        show(m_page, {});
}

} // namespace bask
