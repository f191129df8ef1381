#include "widgets/rig/zero_panel.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"

#include <QDateTime>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kLarge_K = 1.0; ///< a good sensor and its wiring are better

void setOrHide(QLabel* label, const QString& text) {
    if (label->text() != text)
        label->setText(text);
    label->setVisible(!text.isEmpty());
}

} // namespace

ZeroPanel::ZeroPanel(QWidget* parent)
    : QWidget(parent), m_title(boldLabel(this)), m_state(new QLabel(this)), m_offsets(new QLabel(this)),
      m_why(new QLabel(this)), m_zero(new QPushButton(this)) {
    m_state->setObjectName("zeroState");
    m_offsets->setObjectName("zeroOffsets");
    m_why->setObjectName("zeroProblem");
    m_zero->setObjectName("zeroSensors");
    for (QLabel* label : {m_state, m_offsets, m_why}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText); // names are as they are
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    auto* head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addStretch(1);
    head->addWidget(m_zero);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(head);
    for (QLabel* label : {m_state, m_offsets, m_why})
        layout->addWidget(label);
    connect(m_zero, &QPushButton::clicked, this, &ZeroPanel::zeroWanted);
    retranslate();
}

void ZeroPanel::setObjects(const std::vector<ObjectSpec>& objects) {
    m_names.clear();
    for (const ObjectSpec& object : objects)
        m_names.push_back(object.name);
    refresh();
}

void ZeroPanel::apply(const Snapshot& snapshot) {
    m_zeroing = snapshot.zeroing;
    m_problem = snapshot.zeroProblem;
    m_isHeatOn = snapshot.heatOn;
    refresh();
}

void ZeroPanel::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    refresh();
}

QString ZeroPanel::offsetsText() const {
    if (!m_zeroing || m_zeroing->offsets_K.size() != m_names.size())
        return {};
    QStringList all, large;
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const QString name = QString::fromStdString(m_names[i]);
        all << name + u' ' + formatDifference(m_zeroing->offsets_K[i], m_unit, 2);
        if (std::abs(m_zeroing->offsets_K[i]) > kLarge_K)
            large << name;
    }
    QString text = tr("Offsets: %1.").arg(all.join(listSeparator()));
    if (!large.isEmpty())
        text += u' ' + tr("That of %1 is large: check the sensor and its wiring.").arg(large.join(", "));
    return text;
}

QString ZeroPanel::problemText() const {
    if (m_problem.code == MessageCode::None)
        return {};
    if (m_problem.code == MessageCode::ReasonNotAtAmbient && m_isHeatOn)
        return tr("Not while the heat is on.");
    return sentenceText(m_problem, m_unit);
}

void ZeroPanel::refresh() {
    QString state;
    if (m_zeroing) {
        const auto when = QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(1000.0 * m_zeroing->utc_s));
        state = tr("Zeroed on %1 with the room at %2.")
                    .arg(formatDate(when), formatTemperature(m_zeroing->environment_K, m_unit, 2));
    } else {
        state = tr("Not zeroed yet: Arm does it, if all objects are at the room's temperature then.");
    }
    setOrHide(m_state, state);
    setOrHide(m_offsets, offsetsText());
    setOrHide(m_why, problemText());
    m_zero->setEnabled(m_problem.code == MessageCode::None);
}

void ZeroPanel::retranslate() {
    m_title->setText(tr("Sensors at rest"));
    m_zero->setText(tr("Zero the sensors"));
    m_zero->setToolTip(tr("Make all sensors agree while the objects are at the room's temperature"));
    refresh();
}

void ZeroPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
