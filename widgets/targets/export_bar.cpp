#include "widgets/targets/export_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace bask {

ExportBar::ExportBar(QWidget* parent)
    : QWidget(parent), m_word(new QLabel(this)), m_progress(new QProgressBar(this)),
      m_cancel(new QPushButton(this)) {
    m_word->setObjectName("exportWord");
    m_progress->setObjectName("exportProgress");
    m_progress->setTextVisible(false);
    m_cancel->setObjectName("exportCancel");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_word);
    row->addWidget(m_progress, 1);
    row->addWidget(m_cancel);
    connect(m_cancel, &QPushButton::clicked, this, &ExportBar::cancelled);
    retranslate();
    hide();
}

void ExportBar::showProgress(int done, int of) {
    m_done = done;
    m_of = of;
    m_progress->setRange(0, of);
    m_progress->setValue(done);
    retranslate();
    show();
}

void ExportBar::retranslate() {
    m_word->setText(m_done == 0 ? tr("Computing\u2026") : tr("Picture %1 of %2").arg(m_done).arg(m_of));
    m_progress->setAccessibleName(tr("Progress of the export"));
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel the export"));
}

void ExportBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
