#pragma once
// What was picked in the scene, in words.

#include "engine/base/pose.h"

#include <QStringList>
#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace bask {

/// Hidden while nothing is picked. Object names: "picked" (words), "startHere".
class PickedPanel : public QWidget {
    Q_OBJECT

public:
    explicit PickedPanel(QWidget* parent = nullptr);

    /// `refusal`: why runs cannot start there; empty if they can.
    void setPicked(const Vector6d& pose, const QStringList& lines, const QString& refusal);
    void clear();
    /// Sets whether the start may be edited now; `why`: why not.
    void setStartable(bool startable, const QString& why);

signals:
    /// The point was chosen as the start of runs.
    void startWanted(const bask::Vector6d& pose);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showStart();
    void retranslate();

    Vector6d m_pose = Vector6d::Zero();
    QString m_refusal;
    bool m_startable = true;
    QString m_why; ///< why it cannot be a start
    QLabel* m_words;
    QPushButton* m_startHere;
};

} // namespace bask
