#pragma once
// A window with what goes over the links to the devices, from which a person may send, too.

#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <QDialog>

#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QTimer;

namespace bask {

class TrafficFilter;
class TrafficModel;

/// Not modal. Object names: "consoleTable", "consoleLink", "consoleDirection", "consoleText", "consolePause",
/// "consoleCopy", "sendLink", "sendText", "sendEnd", "sendByHand", "sendNote".
class DeviceConsole : public QDialog {
    Q_OBJECT

public:
    explicit DeviceConsole(QWidget* parent = nullptr);

    /// `maySend`: no run is armed or on, and the robot stands.
    void apply(const Snapshot& snapshot, bool maySend);

signals:
    void sendWanted(const bask::SendByHand& send);

protected:
    void changeEvent(QEvent* event) override;

private:
    /// What is added to the text that is sent.
    enum class End { LineFeed, CarriageReturn, Both, Nothing, Hexadecimal };

    void build();
    void takeNew();
    void offerLinks(const std::vector<std::string>& links);
    void filter();
    void copy();
    void send();
    /// Returns the bytes to send; empty if there are none, or too many.
    std::optional<std::string> typedBytes() const;
    std::optional<std::string> typed() const;
    void showSending();
    void retranslate();

    std::shared_ptr<const TrafficLog> m_log;
    bool m_maySend = false, m_isAnyOpen = false, m_isChosenOpen = false;
    QTimer* m_typed; ///< filters when nothing has been typed for a moment
    TrafficModel* m_model;
    TrafficFilter* m_filter;
    QTableView* m_table;
    QComboBox *m_link, *m_direction, *m_sendLink, *m_end;
    QLineEdit *m_text, *m_sendText;
    QPushButton *m_pause, *m_copy, *m_send;
    QLabel* m_note;
};

} // namespace bask
