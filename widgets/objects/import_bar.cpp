#include "widgets/objects/import_bar.h"

#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace bask {
namespace {
constexpr int kUnitFromHeader = -1;
}

ImportBar::ImportBar(QWidget* parent)
    : QFrame(parent), m_file(new QLabel(this)), m_question(new QLabel(this)), m_unit(new QComboBox(this)),
      m_scale(new QDoubleSpinBox(this)), m_accept(new QPushButton(this)), m_cancel(new QPushButton(this)) {
    m_file->setObjectName("importFile");
    m_unit->setObjectName("importUnit");
    m_scale->setObjectName("importScale");
    m_accept->setObjectName("importAccept");
    m_cancel->setObjectName("importCancel");
    QFont bold = m_file->font();
    bold.setBold(true);
    m_file->setFont(bold);
    m_scale->setRange(0.001, 100000.0);
    m_scale->setDecimals(3);
    m_scale->setValue(15.0);
    for (const int unit :
         {kUnitFromHeader, static_cast<int>(LengthUnit::Millimetre), static_cast<int>(LengthUnit::Centimetre),
          static_cast<int>(LengthUnit::Metre), static_cast<int>(LengthUnit::Inch)})
        m_unit->addItem(QString(), unit);
    m_question->setWordWrap(true);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 8, 10, 8);
    layout->addWidget(m_file);
    layout->addWidget(m_question, 1);
    layout->addWidget(m_unit);
    layout->addWidget(m_scale);
    layout->addWidget(m_accept);
    layout->addWidget(m_cancel);
    connect(m_accept, &QPushButton::clicked, this, &ImportBar::accept);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        hide();
        emit cancelled();
    });
    retranslate();
    hide();
}

bool ImportBar::isImage(const QString& path) {
    static const QStringList extensions{"png", "jpg", "jpeg", "bmp", "tif", "tiff"};
    return extensions.contains(QFileInfo(path).suffix().toLower());
}

void ImportBar::offer(const QString& path) {
    m_path = path;
    const bool image = isImage(path);
    m_unit->setVisible(!image);
    m_scale->setVisible(image);
    retranslate();
    show();
    (image ? static_cast<QWidget*>(m_scale) : m_unit)->setFocus();
}

void ImportBar::accept() {
    ContourImportOptions options;
    if (isImage(m_path))
        options.scale_px_per_mm = m_scale->value();
    else if (const int unit = m_unit->currentData().toInt(); unit != kUnitFromHeader)
        options.unit = static_cast<LengthUnit>(unit);
    hide();
    emit accepted(m_path, options);
}

void ImportBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        m_accept->click();
    else if (event->key() == Qt::Key_Escape)
        m_cancel->click();
    else
        QFrame::keyPressEvent(event);
}

void ImportBar::retranslate() {
    m_file->setText(QFileInfo(m_path).fileName());
    m_file->setToolTip(m_path);
    m_question->setText(isImage(m_path) ? tr("How many pixels are one millimetre?")
                                        : tr("In which unit are its coordinates?"));
    for (int i = 0; i < m_unit->count(); ++i) {
        const int unit = m_unit->itemData(i).toInt();
        m_unit->setItemText(i, unit == kUnitFromHeader
                                   ? tr("as its header says")
                                   : QString::fromLatin1(lengthUnitName(static_cast<LengthUnit>(unit))));
    }
    m_scale->setSuffix(tr(" px/mm"));
    m_accept->setText(tr("Import"));
    m_cancel->setText(tr("Cancel"));
    m_unit->setAccessibleName(tr("Unit of the coordinates"));
    m_scale->setAccessibleName(tr("Scale of the picture, pixels per millimetre"));
    setAccessibleName(tr("Import an outline"));
}

void ImportBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        update();
    QFrame::changeEvent(event);
}

void ImportBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool dark = isDark(this);
    painter.setPen(accentColor(dark));
    painter.setBrush(mixed(accentColor(dark), palette().color(QPalette::Window), 0.10));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

} // namespace bask
