#pragma once
// What a calibration found, with its verdict, and the button that puts it to use.

#include "engine/calibration/verdict.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace bask {

/// Object names: "placeVerdict", "placeText", "placeUse" if its name is "place".
class VerdictBox : public QWidget {
    Q_OBJECT

public:
    explicit VerdictBox(const QString& name, QWidget* parent = nullptr);

    /// Shows a state such as "Not measured" without a verdict.
    void showState(const QString& state, const QString& text);
    void showVerdict(Verdict verdict, bool isUsed, const QStringList& lines);

    QPushButton* useButton() const { return m_use; }
    QLabel* textLabel() const { return m_text; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void showText(const QString& text);
    void showIcon();

    std::optional<Verdict> m_judged;
    QLabel *m_icon, *m_verdict, *m_text;
    QPushButton* m_use;
};

} // namespace bask
