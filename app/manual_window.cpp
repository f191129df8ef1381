#include "app/manual_window.h"

#include "widgets/common/language.h"
#include "widgets/common/theme.h"

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

#include <algorithm>
#include <utility>

namespace bask {
namespace {

const QString kFolder = QStringLiteral(":/manual/");
const QString kContents = QStringLiteral("manual.md");

/// Markdown leaves tables without lines and code without a ground.
void dress(QTextDocument& document, const QPalette& palette) {
    QTextCursor cursor(&document);
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table)
            continue;
        QTextTableFormat format = table->format();
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(hairline(isDark(palette)));
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
}

QString textOf(const QString& path) {
    QFile file(kFolder + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QList<QTextBlock> headingsOf(const QTextDocument& document) {
    QList<QTextBlock> out;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0)
            out << block;
    return out;
}

/// -1 where none is called so.
qsizetype headingNumber(const QTextDocument& document, const QString& anchor) {
    const QList<QTextBlock> headings = headingsOf(document);
    const auto found = std::ranges::find(
        headings, anchor, [](const QTextBlock& heading) { return ManualWindow::anchorOf(heading.text()); });
    return found == headings.end() ? -1 : found - headings.begin();
}

} // namespace

ManualWindow::ManualWindow(const Language& language, QWidget* parent)
    : QWidget(parent, Qt::Window), m_language(language), m_text(new QTextBrowser), m_back(new QPushButton),
      m_contents(new QPushButton), m_find(new QLineEdit) {
    setObjectName(QStringLiteral("manual"));
    m_text->setObjectName(QStringLiteral("manualText"));
    m_back->setObjectName(QStringLiteral("manualBack"));
    m_contents->setObjectName(QStringLiteral("manualContents"));
    m_find->setObjectName(QStringLiteral("manualFind"));
    m_find->setClearButtonEnabled(true);
    m_text->setOpenLinks(false);

    auto* bar = new QHBoxLayout;
    bar->addWidget(m_back);
    bar->addWidget(m_contents);
    bar->addStretch();
    bar->addWidget(m_find);
    auto* column = new QVBoxLayout(this);
    column->addLayout(bar);
    column->addWidget(m_text, 1);

    connect(&m_desktop, &DesktopFiles::problem, this, &ManualWindow::problem);
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
    static const QRegularExpression kDropped(QStringLiteral("[^\\w\\- ]"),
                                             QRegularExpression::UseUnicodePropertiesOption);
    return heading.toLower().remove(kDropped).replace(u' ', u'-');
}

void ManualWindow::open(const QString& page) {
    const QString name = page.section(u'#', 0, 0).section(u'/', -1); // "../" leads out of a language's folder
    if (isVisible())
        m_before.append(m_page);
    show(pages().contains(name) ? name : kContents, page.section(u'#', 1));
    QWidget::show();
    raise();
    activateWindow();
}

void ManualWindow::follow(const QString& link) {
    if (link.startsWith(QLatin1String("http")))
        return m_desktop.openAddress(QUrl(link));
    open(link.startsWith(u'#') ? m_page + link : link);
}

QString ManualWindow::shownText(const QString& page) const {
    if (const QString own = textOf(m_language.current() + u'/' + page); !own.isEmpty())
        return own;
    if (m_language.current() == QLatin1String("en"))
        return textOf(page);
    return u'*' + tr("This page is in English only.") + QStringLiteral("*\n\n") + textOf(page);
}

void ManualWindow::show(const QString& page, const QString& anchor) {
    m_page = page;
    auto* document = new QTextDocument(m_text);
    document->setDefaultFont(m_text->font());
    document->setDocumentMargin(16);
    document->setMarkdown(shownText(page));
    dress(*document, palette());
    m_text->setDocument(document); // once it is whole, or each piece is laid out by itself
    delete std::exchange(m_document, document);
    m_text->moveCursor(QTextCursor::Start);
    m_back->setEnabled(!m_before.isEmpty());
    if (!anchor.isEmpty())
        toHeading(anchor);
}

/// In other colours or another language, at about the same place.
void ManualWindow::showAgain() {
    QScrollBar& bar = *m_text->verticalScrollBar();
    const double part = double(bar.value()) / qMax(1, bar.maximum());
    show(m_page, {});
    bar.setValue(qRound(part * bar.maximum()));
}

/// A translated page has the headings of the English one in the same order.
void ManualWindow::toHeading(const QString& anchor) {
    qsizetype number = headingNumber(*m_text->document(), anchor);
    if (number < 0) {
        QTextDocument english;
        english.setMarkdown(textOf(m_page));
        number = headingNumber(english, anchor);
    }
    const QList<QTextBlock> headings = headingsOf(*m_text->document());
    if (number < 0 || number >= headings.size())
        return;
    m_text->moveCursor(QTextCursor::End); // so that the heading comes to the top
    m_text->setTextCursor(QTextCursor(headings[number]));
    m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->value() + m_text->cursorRect().top());
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
    for (qsizetype i = 1; i <= names.size(); ++i) {
        const QString& name = names[(at + i) % names.size()];
        QTextDocument document; // a page is only drawn when it is the one
        document.setMarkdown(shownText(name));
        if (document.find(wanted).isNull())
            continue;
        if (name != m_page)
            m_before.append(m_page);
        show(name, {});
        m_text->find(wanted);
        return;
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
    const bool isNewLanguage = event->type() == QEvent::LanguageChange;
    if (isNewLanguage)
        retranslate();
    if ((isNewLanguage || event->type() == QEvent::PaletteChange) && !m_page.isEmpty())
        showAgain();
}

} // namespace bask
