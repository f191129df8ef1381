#include "widgets/targets/picked_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextDocument>

namespace bask {

PickedPanel::PickedPanel(QWidget* parent)
    : QWidget(parent), m_words(new QLabel(this)), m_startHere(new QPushButton(this)) {
    m_words->setObjectName("picked");
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText); // names are the user's
    m_startHere->setObjectName("startHere");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_words, 1);
    row->addWidget(m_startHere, 0, Qt::AlignTop);
    connect(m_startHere, &QPushButton::clicked, this, [this] { emit startWanted(m_pose); });
    retranslate();
    hide();
}

void PickedPanel::setPicked(const Vector6d& pose, const QStringList& lines, const QString& refusal) {
    m_pose = pose;
    m_refusal = refusal;
    showStart();
    m_words->setText(lines.join(QLatin1Char('\n')));
    show();
}

void PickedPanel::clear() {
    hide();
}

void PickedPanel::setStartable(bool startable, const QString& why) {
    m_startable = startable;
    m_why = why;
    showStart();
}

void PickedPanel::showStart() {
    m_startHere->setEnabled(m_startable && m_refusal.isEmpty());
    const QString tip = !m_startable           ? m_why
                        : !m_refusal.isEmpty() ? tr("Runs cannot start at this point: %1.").arg(m_refusal)
                                               : tr("Runs start at this point.");
    m_startHere->setToolTip(Qt::mightBeRichText(tip) ? tip.toHtmlEscaped() : tip); // it may have a name in it
}

void PickedPanel::retranslate() {
    m_words->setToolTip(tr("For each object at this point: its view factor, the temperature that it "
                           "settles at, and how fast that rises along its arrow."));
    m_startHere->setText(tr("Start here"));
    showStart();
}

void PickedPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
