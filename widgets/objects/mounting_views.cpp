#include "widgets/objects/mounting_views.h"

#include "widgets/common/labels.h"
#include "widgets/objects/mounting_plan.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

constexpr int kPlanShare = 3, kSideShare = 2;

} // namespace

MountingViews::MountingViews(QWidget* parent)
    : QWidget(parent), m_plan(new MountingPlan(this)), m_side(new MountingPlan(this)),
      m_title(boldLabel(this)), m_fromFront(viewButton("viewFront")), m_fromSide(viewButton("viewSide")) {
    m_plan->setObjectName("mountingPlan");
    m_side->setObjectName("mountingSide");
    m_side->setView(MountingView::Front);
    m_fromFront->setChecked(true);
    connect(m_fromSide, &QToolButton::toggled, this, [this](bool isFromSide) {
        m_side->setView(isFromSide ? MountingView::Side : MountingView::Front);
        shareScale();
    });
    connectView(m_plan, m_side);
    connectView(m_side, m_plan);

    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_fromFront);
    head->addWidget(m_fromSide);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_plan, kPlanShare);
    layout->addLayout(head);
    layout->addWidget(m_side, kSideShare);
    retranslate();
}

QToolButton* MountingViews::viewButton(const char* name) {
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromLatin1(name));
    button->setCheckable(true);
    button->setAutoExclusive(true);
    return button;
}

void MountingViews::connectView(MountingPlan* view, MountingPlan* other) {
    view->installEventFilter(this);
    connect(view, &MountingPlan::objectClicked, this, &MountingViews::objectClicked);
    connect(view, &MountingPlan::objectMoved, this, &MountingViews::objectMoved);
    connect(view, &MountingPlan::objectDragged, other, &MountingPlan::showDragged);
    connect(view, &MountingPlan::objectDragged, this, &MountingViews::objectDragged);
}

void MountingViews::setObjects(const std::vector<ObjectSpec>& objects, int selected, double reach_m) {
    for (MountingPlan* view : {m_plan, m_side})
        view->setObjects(objects, selected, {}, reach_m);
    shareScale();
}

void MountingViews::setRemarked(const std::set<int>& remarked) {
    for (MountingPlan* view : {m_plan, m_side})
        view->setRemarked(remarked);
}

void MountingViews::setReadOnly(bool readOnly) {
    for (MountingPlan* view : {m_plan, m_side})
        view->setReadOnly(readOnly);
}

void MountingViews::shareScale() {
    const double scale = std::min(m_plan->fittedScale(), m_side->fittedScale());
    for (MountingPlan* view : {m_plan, m_side})
        view->setMaxScale(scale);
}

bool MountingViews::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize)
        shareScale();
    return QWidget::eventFilter(watched, event);
}

void MountingViews::retranslate() {
    m_title->setText(tr("Heights and tilts"));
    m_fromFront->setText(tr("Front"));
    m_fromFront->setToolTip(tr("Seen along y: x to the right, z up"));
    m_fromSide->setText(tr("Side"));
    m_fromSide->setToolTip(tr("Seen against x: y to the right, z up"));
}

void MountingViews::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
