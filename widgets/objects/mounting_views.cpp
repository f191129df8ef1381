#include "widgets/objects/mounting_views.h"

#include "widgets/common/labels.h"
#include "widgets/objects/mounting_plan.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
namespace {

constexpr int kPlanShare = 3, kSideShare = 2;
constexpr int kFrontTab = 0, kSideTab = 1;

} // namespace

MountingViews::MountingViews(QWidget* parent)
    : QWidget(parent), m_plan(new MountingPlan(this)), m_side(new MountingPlan(this)),
      m_title(boldLabel(this)), m_from(new QTabBar(this)) {
    m_plan->setObjectName("mountingPlan");
    m_side->setObjectName("mountingSide");
    m_side->setView(MountingView::Front);
    m_from->setObjectName("mountingFrom");
    m_from->setExpanding(false);
    m_from->setDrawBase(false);
    m_from->addTab({});
    m_from->addTab({});
    connect(m_from, &QTabBar::currentChanged, this, [this](int tab) {
        m_side->setView(tab == kSideTab ? MountingView::Side : MountingView::Front);
        shareScale();
    });
    connectView(m_plan, m_side);
    connectView(m_side, m_plan);

    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_from, 0, Qt::AlignBottom);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_plan, kPlanShare);
    layout->addSpacing(6);
    layout->addLayout(head);
    layout->addWidget(m_side, kSideShare);
    retranslate();
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
    m_from->setTabText(kFrontTab, tr("Front"));
    m_from->setTabToolTip(kFrontTab, tr("Seen along y: x to the right, z up"));
    m_from->setTabText(kSideTab, tr("Side"));
    m_from->setTabToolTip(kSideTab, tr("Seen against x: y to the right, z up"));
}

void MountingViews::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
