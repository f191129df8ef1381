#pragma once
// The plan of the end-effector and, under it, its view from the front or the side: one drawing to one scale.

#include "engine/model/experiment.h"

#include <QWidget>

#include <set>

class QLabel;
class QTabBar;

namespace bask {

class MountingPlan;

/// What is dragged in one view is followed by the other. Object names: "mountingPlan", "mountingSide",
/// "mountingFrom" (QTabBar).
class MountingViews : public QWidget {
    Q_OBJECT

public:
    explicit MountingViews(QWidget* parent = nullptr);

    /// As MountingPlan::setObjects.
    void setObjects(const std::vector<ObjectSpec>& objects, int selected, double reach_m);
    void setRemarked(const std::set<int>& remarked);
    void setReadOnly(bool readOnly);

signals:
    /// As those of MountingPlan.
    void objectClicked(int index);
    void objectDragged(int index, const bask::Vector6d& mounting);
    void objectMoved(int index, const bask::Vector6d& mounting);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectView(MountingPlan* view, MountingPlan* other);
    void shareScale();
    void retranslate();

    MountingPlan* m_plan;
    MountingPlan* m_side;
    QLabel* m_title;
    QTabBar* m_from; ///< the front or the side
};

} // namespace bask
