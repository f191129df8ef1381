#pragma once
// The settings of a serial line: speed, data bits, parity, stop bits.

#include "widgets/common/device_words.h"

#include <QWidget>

class QComboBox;

namespace bask {

/// Object names: "baud", "dataBits", "parity", "stopBits".
class SerialForm : public QWidget {
    Q_OBJECT

public:
    explicit SerialForm(QWidget* parent = nullptr);

    void setLine(const SerialSettings& line);
    SerialSettings line() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QComboBox *m_baud, *m_dataBits, *m_parity, *m_stopBits;
};

} // namespace bask
