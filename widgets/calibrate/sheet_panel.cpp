#include "widgets/calibrate/sheet_panel.h"

#include "engine/base/units.h"
#include "engine/base/whole_file.h"
#include "widgets/calibrate/board_form.h"
#include "widgets/calibrate/sheet_preview.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/number_field.h"
#include "widgets/common/theme.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <optional>

namespace bask {
namespace {

// Printers that fit a page to the paper stay within this; A3 on A4 is 71 %.
constexpr double kMinMeasured_mm = 60.0, kMaxMeasured_mm = 150.0;

void setLabel(QFormLayout* form, QWidget* field, const QString& text) {
    static_cast<QLabel*>(form->labelForField(field))->setText(text);
}

} // namespace

SheetPanel::SheetPanel(QWidget* parent)
    : QWidget(parent), m_preview(new SheetPreview(this)), m_pages(new QLabel(this)), m_form(new QFormLayout),
      m_kind(new QComboBox(this)), m_board(new BoardForm(this)), m_dictionary(new QComboBox(this)),
      m_ids(new QLineEdit(this)), m_side(new NumberField(this)), m_paper(new QComboBox(this)),
      m_problem(new QLabel(this)), m_save(new QPushButton(this)), m_measured(new NumberField(this)),
      m_true(new QLabel(this)), m_use(new QPushButton(this)) {
    m_preview->setObjectName("sheetPreview");
    m_pages->setObjectName("sheetPages");
    m_pages->setAlignment(Qt::AlignHCenter);
    m_kind->setObjectName("sheetKind");
    m_kind->addItems({QString(), QString()});
    m_dictionary->setObjectName("sheetDictionary");
    m_dictionary->addItems(QString::fromStdString(markerDictionaries()).split(QStringLiteral(", ")));
    m_dictionary->setCurrentText(QStringLiteral("6X6_250"));
    m_ids->setObjectName("sheetIds");
    m_ids->setText(QStringLiteral("1-4"));
    m_side->setObjectName("sheetSide");
    m_side->setRange(5.0, 1000.0);
    m_side->setDecimals(2);
    m_side->setSuffix(QStringLiteral("\u00a0mm"));
    m_side->setValue(50.0);
    m_paper->setObjectName("sheetPaper");
    m_paper->addItem(QStringLiteral("A4"), QPageSize::A4);
    m_paper->addItem(QStringLiteral("A3"), QPageSize::A3);
    m_paper->addItem(QStringLiteral("Letter"), QPageSize::Letter);
    m_problem->setObjectName("sheetProblem");
    m_problem->setWordWrap(true);
    m_save->setObjectName("sheetSave");
    m_measured->setObjectName("sheetMeasured");
    m_measured->setRange(kMinMeasured_mm, kMaxMeasured_mm);
    m_measured->setSpecialValueText(kNoValue);
    m_measured->setDecimals(2);
    m_measured->setSingleStep(0.1);
    m_measured->setSuffix(QStringLiteral("\u00a0mm"));
    m_true->setObjectName("sheetTrue");
    m_true->setWordWrap(true);
    m_use->setObjectName("sheetUse");

    auto* paper = new QVBoxLayout;
    paper->addWidget(m_preview, 1);
    paper->addWidget(m_pages);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    layout->addWidget(buildForm());
    layout->addLayout(paper, 1);
    connectAll();
    retranslate();
}

QWidget* SheetPanel::buildForm() {
    auto* form = new QWidget(this);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->addRow(QStringLiteral(" "), m_kind);
    m_form->addRow(m_board);
    for (QWidget* field : std::initializer_list<QWidget*>{m_dictionary, m_ids, m_side, m_paper})
        m_form->addRow(QStringLiteral(" "), field);
    m_form->addRow(m_problem);
    m_form->addRow(m_save);
    m_form->addRow(QStringLiteral(" "), m_measured);
    m_form->addRow(m_true);
    m_form->addRow(m_use);
    auto* layout = new QVBoxLayout(form);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(m_form);
    return form;
}

void SheetPanel::connectAll() {
    for (QComboBox* box : {m_kind, m_dictionary, m_paper})
        connect(box, &QComboBox::currentIndexChanged, this, &SheetPanel::refresh);
    connect(m_board, &BoardForm::changed, this, &SheetPanel::refresh);
    connect(m_ids, &QLineEdit::textChanged, this, &SheetPanel::refresh);
    connect(m_side, &QDoubleSpinBox::valueChanged, this, &SheetPanel::refresh);
    connect(m_measured, &QDoubleSpinBox::valueChanged, this, &SheetPanel::showTrueLength);
    connect(m_use, &QPushButton::clicked, this, &SheetPanel::use);
    connect(m_save, &QPushButton::clicked, this, [this] {
        const QString name = isMarkers() ? QStringLiteral("markers.pdf") : QStringLiteral("board.pdf");
        const QString path =
            askFileToSave(this, tr("Save the sheet"), name, QStringLiteral("*.pdf"), FileFolder::Exports);
        if (!path.isEmpty())
            saveTo(path);
    });
}

bool SheetPanel::isMarkers() const {
    return m_kind->currentIndex() == 1;
}

void SheetPanel::setBoard(const Board& board) {
    const QSignalBlocker quiet(m_kind);
    m_kind->setCurrentIndex(0);
    m_board->setBoard(board);
    refresh();
}

void SheetPanel::setMarkers(const std::string& dictionary, const std::vector<int>& ids, double side_m) {
    const QSignalBlocker quietKind(m_kind), quietDictionary(m_dictionary), quietIds(m_ids), quietSide(m_side);
    m_kind->setCurrentIndex(1);
    m_dictionary->setCurrentText(QString::fromStdString(dictionary));
    m_ids->setText(QString::fromStdString(idRanges(ids)));
    m_side->setValue(side_m * kMmPerM);
    refresh();
}

std::string SheetPanel::ids() const {
    return m_ids->text().remove(QLatin1Char(' ')).toStdString();
}

std::string SheetPanel::setting() const {
    return "marker:" + m_dictionary->currentText().toStdString() + ":" + ids() + ":" +
           formatNumber(m_side->value() / kMmPerM, 6);
}

void SheetPanel::refresh() {
    m_form->setRowVisible(m_board, !isMarkers());
    for (QWidget* field : std::initializer_list<QWidget*>{m_dictionary, m_ids, m_side})
        m_form->setRowVisible(field, isMarkers());
    const auto paper = static_cast<QPageSize::PageSizeId>(m_paper->currentData().toInt());
    const auto board = m_board->board();
    auto sheets = isMarkers() ? boardSheets(setting(), paper)
                  : board     ? boardSheets(boardText(*board), paper)
                              : Result<std::vector<BoardSheet>>(board.error());
    m_sheets = sheets ? std::move(*sheets) : std::vector<BoardSheet>{};
    m_preview->setSheet(m_sheets.empty() ? std::nullopt : std::optional(m_sheets.front()));
    m_pages->setText(m_sheets.size() > 1 ? tr("The first of %1 pages").arg(m_sheets.size()) : QString());
    m_save->setEnabled(!m_sheets.empty());
    say(sheets                            ? QString()
        : isMarkers() && !parseIds(ids()) ? tr("Give the markers' numbers such as 1-4, 11.")
                                          : messageText(sheets.error().message),
        !sheets);
    showTrueLength();
}

void SheetPanel::say(const QString& sentence, bool isProblem) {
    QPalette colours = palette();
    if (isProblem)
        colours.setColor(QPalette::WindowText, alarmColor(2, isDark(this)));
    m_problem->setPalette(colours);
    m_problem->setText(sentence);
    m_problem->setVisible(!sentence.isEmpty());
}

void SheetPanel::saveTo(const QString& path) {
    const auto saved = writeWholeFile(path.toStdString(), sheetPdf(m_sheets).toStdString());
    say(saved ? tr("Saved. Print it at 100 % (actual size) and measure its ruler.")
              : messageText(saved.error().message),
        !saved.ok());
    if (saved)
        emit exported(tr("The sheet was saved as %1.").arg(QFileInfo(path).fileName()), {path});
}

double SheetPanel::scale() const {
    return m_measured->value() > kMinMeasured_mm && !m_sheets.empty() ? m_measured->value() / kRuler_mm : 0.0;
}

void SheetPanel::showTrueLength() {
    m_use->setEnabled(scale() > 0.0);
    if (scale() == 0.0)
        return m_true->setText(tr("Printers scale, and no picture tells how large a square is: measure the "
                                  "ruler on the print, from 0 to 100 mm."));
    if (isMarkers())
        return m_true->setText(
            tr("A marker's side is truly %1.").arg(formatLength_mm(scale() * m_side->value() / kMmPerM, 2)));
    m_true->setText(
        tr("A square's side is truly %1.").arg(formatLength_mm(scale() * m_board->board()->square_m, 2)));
}

void SheetPanel::use() {
    if (isMarkers()) {
        emit markersMeasured(m_dictionary->currentText().toStdString(), *parseIds(ids()),
                             scale() * m_side->value() / kMmPerM);
        return;
    }
    Board board = *m_board->board();
    board.square_m *= scale();
    board.marker_m *= scale();
    emit boardMeasured(board);
}

void SheetPanel::retranslate() {
    setWindowTitle(tr("Print"));
    m_kind->setItemText(0, tr("Calibration board"));
    m_kind->setItemText(1, tr("Markers"));
    setLabel(m_form, m_kind, tr("Sheet"));
    setLabel(m_form, m_dictionary, tr("&Dictionary"));
    setLabel(m_form, m_ids, tr("&Numbers"));
    m_ids->setToolTip(tr("Such as 1-4, 11"));
    setLabel(m_form, m_side, tr("&Side of a marker"));
    m_side->setToolTip(tr("With its black border."));
    setLabel(m_form, m_paper, tr("&Paper"));
    m_save->setText(tr("Save as PDF…"));
    setLabel(m_form, m_measured, tr("Measured &length"));
    m_measured->setToolTip(tr("Of the ruler on the print, which is 100 mm long."));
    m_use->setText(tr("Use the true lengths"));
    m_preview->setAccessibleName(tr("The sheet as it is printed"));
    setAccessibleName(tr("Sheets to be printed"));
    refresh();
}

void SheetPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}

} // namespace bask
