#include "widgets/rig/serial_form.h"

#include "widgets/common/labels.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QIntValidator>

namespace bask {
namespace {

constexpr std::array kSpeeds{9600, 19200, 38400, 57600, 115200, 230400, 250000, 500000, 1000000};
constexpr std::array kParities{'N', 'E', 'O'};

} // namespace

SerialForm::SerialForm(QWidget* parent)
    : QWidget(parent), m_baud(new QComboBox(this)), m_dataBits(new QComboBox(this)),
      m_parity(new QComboBox(this)), m_stopBits(new QComboBox(this)) {
    m_baud->setObjectName("baud");
    m_dataBits->setObjectName("dataBits");
    m_parity->setObjectName("parity");
    m_stopBits->setObjectName("stopBits");
    m_baud->setEditable(true);
    m_baud->setInsertPolicy(QComboBox::NoInsert);
    const ValidRange& speeds = serialParameters().front().range;
    m_baud->setValidator(new QIntValidator(static_cast<int>(speeds.min), static_cast<int>(speeds.max), this));
    for (const int speed : kSpeeds)
        m_baud->addItem(QString::number(speed));
    for (const int bits : {7, 8})
        m_dataBits->addItem(QString::number(bits), bits);
    for (const char parity : kParities)
        m_parity->addItem(QString(), parity);
    for (const int bits : {1, 2})
        m_stopBits->addItem(QString::number(bits), bits);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget* field : {m_baud, m_dataBits, m_parity, m_stopBits})
        row->addWidget(field);
    row->addStretch(1);
    retranslate();
    setLine({});
}

void SerialForm::setLine(const SerialSettings& line) {
    m_baud->setEditText(QString::number(line.baud));
    m_dataBits->setCurrentIndex(m_dataBits->findData(line.dataBits));
    m_parity->setCurrentIndex(m_parity->findData(line.parity));
    m_stopBits->setCurrentIndex(m_stopBits->findData(line.stopBits));
}

SerialSettings SerialForm::line() const {
    SerialSettings line;
    line.baud = m_baud->currentText().toInt();
    line.dataBits = m_dataBits->currentData().toInt();
    line.parity = kParities[static_cast<std::size_t>(m_parity->currentIndex())];
    line.stopBits = m_stopBits->currentData().toInt();
    return line;
}

void SerialForm::retranslate() {
    const std::array parities{tr("no parity"), tr("even parity"), tr("odd parity")};
    for (std::size_t i = 0; i < parities.size(); ++i)
        m_parity->setItemText(static_cast<int>(i), parities[i]);
    const auto say = [](QComboBox* field, const QString& text) {
        field->setToolTip(text);
        nameChoice(field, text);
    };
    say(m_baud, tr("Speed of the line, baud"));
    say(m_dataBits, tr("Data bits"));
    say(m_parity, tr("Parity"));
    say(m_stopBits, tr("Stop bits"));
}

void SerialForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
