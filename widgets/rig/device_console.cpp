#include "widgets/rig/device_console.h"

#include "engine/drivers/traffic_log.h"
#include "widgets/common/labels.h"
#include "widgets/rig/traffic_model.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>

namespace bask {
namespace {

constexpr qsizetype kMaxCopied = 8 << 20; ///< characters
constexpr int kTyped_ms = 300;
constexpr std::size_t kMaxSent = 256; ///< bytes, as LoggedLink takes them

void addLink(QComboBox& box, const std::string& link) {
    const QString name = QString::fromStdString(link);
    if (box.findData(name) < 0)
        box.addItem(name, name);
}

bool hasLink(const std::vector<std::string>& links, const QString& link) {
    return std::ranges::find(links, link.toStdString()) != links.end();
}

} // namespace

DeviceConsole::DeviceConsole(QWidget* parent)
    : QDialog(parent), m_typed(new QTimer(this)), m_model(new TrafficModel(this)),
      m_filter(new TrafficFilter(this)), m_table(new QTableView(this)), m_link(new QComboBox(this)),
      m_direction(new QComboBox(this)), m_sendLink(new QComboBox(this)), m_end(new QComboBox(this)),
      m_text(new QLineEdit(this)), m_sendText(new QLineEdit(this)), m_pause(new QPushButton(this)),
      m_copy(new QPushButton(this)), m_send(new QPushButton(this)), m_note(new QLabel(this)) {
    setObjectName("deviceConsole");
    setModal(false);
    setWindowFlag(Qt::WindowMinMaxButtonsHint);
    build();
    retranslate();
    resize(860, 520);
}

void DeviceConsole::build() {
    m_table->setObjectName("consoleTable");
    m_link->setObjectName("consoleLink");
    m_direction->setObjectName("consoleDirection");
    m_text->setObjectName("consoleText");
    m_pause->setObjectName("consolePause");
    m_copy->setObjectName("consoleCopy");
    m_sendLink->setObjectName("sendLink");
    m_sendText->setObjectName("sendText");
    m_end->setObjectName("sendEnd");
    m_send->setObjectName("sendByHand");
    m_note->setObjectName("sendNote");
    m_note->setWordWrap(true);
    m_pause->setCheckable(true);
    for (QPushButton* button : {m_pause, m_copy, m_send})
        button->setAutoDefault(false);
    for (QComboBox* box : {m_link, m_sendLink}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(18);
    }
    m_text->setClearButtonEnabled(true);
    m_link->addItem({}, QString());
    for (int i = 0; i < 3; ++i)
        m_direction->addItem({});
    for (int i = 0; i < 5; ++i)
        m_end->addItem({});

    m_filter->setSourceModel(m_model);
    m_table->setModel(m_filter);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const QFontMetrics& metrics = m_table->fontMetrics();
    m_table->setColumnWidth(TrafficModel::kTime,
                            metrics.horizontalAdvance(QStringLiteral("00:00:00.000")) + 48);
    m_table->setColumnWidth(TrafficModel::kLink, metrics.horizontalAdvance(QString(20, u'x')));
    m_table->setColumnWidth(TrafficModel::kDirection, metrics.horizontalAdvance(QString(14, u'x')));

    auto* top = new QHBoxLayout;
    top->addWidget(m_link);
    top->addWidget(m_direction);
    top->addWidget(m_text, 1);
    top->addWidget(m_pause);
    top->addWidget(m_copy);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_sendLink);
    bottom->addWidget(m_sendText, 1);
    bottom->addWidget(m_end);
    bottom->addWidget(m_send);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_table, 1);
    layout->addLayout(bottom);
    layout->addWidget(m_note);
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing()); // nothing moves when it changes
    m_note->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    QWidget* before = m_link;
    for (QWidget* next : std::initializer_list<QWidget*>{m_direction, m_text, m_pause, m_copy, m_table,
                                                         m_sendLink, m_sendText, m_end, m_send}) {
        setTabOrder(before, next);
        before = next;
    }
    m_text->setFocus();

    connect(m_link, &QComboBox::currentIndexChanged, this, &DeviceConsole::filter);
    connect(m_direction, &QComboBox::currentIndexChanged, this, &DeviceConsole::filter);
    m_typed->setSingleShot(true);
    m_typed->setInterval(kTyped_ms);
    connect(m_typed, &QTimer::timeout, this, &DeviceConsole::filter);
    connect(m_text, &QLineEdit::textChanged, m_typed, qOverload<>(&QTimer::start));
    connect(m_sendLink, &QComboBox::activated, this, [this] {
        if (m_log)
            offerLinks(m_log->openLinks());
        showSending();
    });
    connect(m_pause, &QPushButton::toggled, this, &DeviceConsole::takeNew);
    connect(m_copy, &QPushButton::clicked, this, &DeviceConsole::copy);
    connect(m_send, &QPushButton::clicked, this, &DeviceConsole::send);
    connect(m_sendText, &QLineEdit::returnPressed, this, &DeviceConsole::send);
    connect(m_sendText, &QLineEdit::textChanged, this, &DeviceConsole::showSending);
    connect(m_end, &QComboBox::currentIndexChanged, this, &DeviceConsole::showSending);
}

void DeviceConsole::apply(const Snapshot& snapshot, bool maySend) {
    m_log = snapshot.traffic;
    m_maySend = maySend;
    takeNew();
    if (m_log)
        offerLinks(m_log->openLinks());
    showSending();
}

/// Nothing is chosen for a person, and a choice stays while its link is closed.
void DeviceConsole::offerLinks(const std::vector<std::string>& links) {
    for (const std::string& link : links)
        if (m_sendLink->findData(QString::fromStdString(link)) < 0) {
            const int chosen = m_sendLink->currentIndex();
            addLink(*m_sendLink, link);
            m_sendLink->setCurrentIndex(chosen);
        }
    for (int i = m_sendLink->count() - 1; i >= 0; --i)
        if (i != m_sendLink->currentIndex() && !hasLink(links, m_sendLink->itemData(i).toString()))
            m_sendLink->removeItem(i);
    m_isAnyOpen = !links.empty();
    m_isChosenOpen = hasLink(links, m_sendLink->currentData().toString());
}

void DeviceConsole::takeNew() {
    if (!m_log || m_pause->isChecked())
        return;
    const QScrollBar& bar = *m_table->verticalScrollBar();
    const bool isAtEnd = bar.value() >= bar.maximum();
    const int rows = m_model->take(*m_log);
    for (int row = m_model->rowCount() - rows; row < m_model->rowCount(); ++row)
        addLink(*m_link, m_model->line(row).link);
    if (isAtEnd)
        m_table->scrollToBottom();
}

void DeviceConsole::filter() {
    m_filter->setFilter(m_link->currentData().toString(),
                        static_cast<TrafficDirection>(m_direction->currentIndex()), m_text->text());
    m_table->scrollToBottom();
}

/// The selected rows, or all that are shown.
void DeviceConsole::copy() {
    QModelIndexList rows = m_table->selectionModel()->selectedRows();
    if (rows.isEmpty())
        for (int row = 0; row < m_filter->rowCount(); ++row)
            rows << m_filter->index(row, 0);
    std::ranges::sort(rows, std::greater(), &QModelIndex::row);
    QStringList lines; // the newest first
    qsizetype size = 0;
    for (const QModelIndex& row : rows) {
        lines << m_model->rowText(m_filter->mapToSource(row).row()) + u'\n';
        size += lines.back().size();
        if (size > kMaxCopied)
            break;
    }
    std::ranges::reverse(lines);
    const QString text = lines.join(QString());
    QApplication::clipboard()->setText(text);
}

std::optional<std::string> DeviceConsole::typedBytes() const {
    auto bytes = typed();
    return bytes && bytes->size() <= kMaxSent ? bytes : std::nullopt;
}

std::optional<std::string> DeviceConsole::typed() const {
    const QString text = m_sendText->text();
    switch (static_cast<End>(m_end->currentIndex())) {
    case End::LineFeed:
        return text.toStdString() + '\n';
    case End::CarriageReturn:
        return text.toStdString() + '\r';
    case End::Both:
        return text.toStdString() + "\r\n";
    case End::Nothing:
        return text.isEmpty() ? std::nullopt : std::optional(text.toStdString());
    case End::Hexadecimal:
        return bytesOfDigits(text);
    }
    return std::nullopt;
}

void DeviceConsole::send() {
    const auto bytes = typedBytes();
    if (!m_send->isEnabled() || !bytes)
        return;
    emit sendWanted(SendByHand{m_sendLink->currentData().toString().toStdString(), *bytes});
    m_sendText->selectAll();
}

void DeviceConsole::showSending() {
    for (QWidget* part : std::initializer_list<QWidget*>{m_sendLink, m_sendText, m_end})
        part->setEnabled(m_maySend && m_isAnyOpen);
    m_send->setEnabled(m_maySend && m_isChosenOpen && typedBytes());
    m_note->setText(
        !m_maySend    ? tr("Nothing is sent by hand while a run is armed or on, the heat is on or the "
                              "robot moves.")
        : m_isAnyOpen ? tr("Bask sends this as it is and checks no limit: the robot can move and the source "
                           "can heat. Bask lets the device go meanwhile, and takes it back 3 s later.")
                      : tr("No link to a device is open."));
}

void DeviceConsole::retranslate() {
    setWindowTitle(tr("Device console"));
    m_model->retranslate();
    m_table->setAccessibleName(tr("Traffic of the links"));
    m_link->setItemText(0, tr("All links"));
    nameChoice(m_link, tr("Link"));
    m_direction->setItemText(0, tr("Both directions"));
    m_direction->setItemText(1, tr("Sent"));
    m_direction->setItemText(2, tr("Received"));
    nameChoice(m_direction, tr("Direction"));
    m_text->setPlaceholderText(tr("Show only rows with this text"));
    m_text->setAccessibleName(tr("Filter"));
    m_pause->setText(tr("Pause"));
    m_pause->setToolTip(tr("The traffic of the last 10 minutes is kept meanwhile"));
    m_copy->setText(tr("Copy"));
    m_copy->setToolTip(
        tr("Copies the selected rows, or all that are shown: the newest 8 million characters"));
    nameChoice(m_sendLink, tr("Link to send to"));
    m_sendText->setPlaceholderText(tr("Text to send"));
    m_sendText->setAccessibleName(tr("Text to send"));
    m_end->setItemText(static_cast<int>(End::LineFeed), tr("ends with \\n"));
    m_end->setItemText(static_cast<int>(End::CarriageReturn), tr("ends with \\r"));
    m_end->setItemText(static_cast<int>(End::Both), tr("ends with \\r\\n"));
    m_end->setItemText(static_cast<int>(End::Nothing), tr("as it is"));
    m_end->setItemText(static_cast<int>(End::Hexadecimal), tr("hexadecimal"));
    nameChoice(m_end, tr("End of the text"));
    m_send->setText(tr("Send"));
    showSending();
}

void DeviceConsole::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
