#include "widgets/calibrate/board_form.h"

#include "engine/base/units.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace bask {
namespace {

constexpr double kShortest_mm = 0.01; // that the field can show; a marker is smaller than its square, no more

QDoubleSpinBox* lengthBox(QWidget* parent, const char* name, double min_mm, double value_mm) {
    auto* box = new NumberField(parent);
    box->setObjectName(QString::fromLatin1(name));
    box->setDecimals(2);
    box->setRange(min_mm, kMmPerM * kMaxSquare_m);
    box->setSuffix(QStringLiteral("\u00a0mm"));
    box->setValue(value_mm);
    return box;
}

} // namespace

BoardForm::BoardForm(QWidget* parent)
    : QWidget(parent), m_kindLabel(new QLabel(this)), m_kind(new QComboBox(this)),
      m_countsLabel(new QLabel(this)), m_columns(new WholeNumberField(this)),
      m_rows(new WholeNumberField(this)), m_squareLabel(new QLabel(this)),
      m_square(lengthBox(this, "boardSquare", kMmPerM * kMinSquare_m, 25.0)), m_markerLabel(new QLabel(this)),
      m_marker(lengthBox(this, "boardMarker", kShortest_mm, 18.0)), m_dictionaryLabel(new QLabel(this)),
      m_dictionary(new QComboBox(this)), m_legacy(new QCheckBox(this)) {
    m_kind->setObjectName("boardKind");
    m_kind->addItems({QString(), QString()});
    m_columns->setObjectName("boardColumns");
    m_rows->setObjectName("boardRows");
    for (WholeNumberField* box : {m_columns, m_rows})
        box->setRange(kMinBoardSide, kMaxBoardSide);
    m_columns->setValue(9);
    m_rows->setValue(6);
    m_dictionary->setObjectName("boardDictionary");
    m_dictionary->addItems(QString::fromStdString(markerDictionaries()).split(QStringLiteral(", ")));
    m_dictionary->setCurrentText(QStringLiteral("6X6_250"));
    m_legacy->setObjectName("boardLegacy");

    auto* counts = new QHBoxLayout;
    counts->addWidget(m_columns, 1);
    counts->addWidget(new QLabel(QStringLiteral("\u00d7"), this));
    counts->addWidget(m_rows, 1);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_kindLabel, 0, 0);
    grid->addWidget(m_kind, 0, 1);
    grid->addWidget(m_countsLabel, 1, 0);
    grid->addLayout(counts, 1, 1);
    grid->addWidget(m_squareLabel, 2, 0);
    grid->addWidget(m_square, 2, 1);
    grid->addWidget(m_markerLabel, 3, 0);
    grid->addWidget(m_marker, 3, 1);
    grid->addWidget(m_dictionaryLabel, 4, 0);
    grid->addWidget(m_dictionary, 4, 1);
    grid->addWidget(m_legacy, 5, 1);
    m_kindLabel->setBuddy(m_kind);
    m_countsLabel->setBuddy(m_columns);
    m_squareLabel->setBuddy(m_square);
    m_markerLabel->setBuddy(m_marker);
    m_dictionaryLabel->setBuddy(m_dictionary);

    for (QComboBox* box : {m_kind, m_dictionary})
        connect(box, &QComboBox::currentIndexChanged, this, &BoardForm::changed);
    for (WholeNumberField* box : {m_columns, m_rows})
        connect(box, &QDoubleSpinBox::valueChanged, this, &BoardForm::changed);
    for (QDoubleSpinBox* box : {m_square, m_marker})
        connect(box, &QDoubleSpinBox::valueChanged, this, &BoardForm::changed);
    connect(m_legacy, &QCheckBox::toggled, this, &BoardForm::changed);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &BoardForm::showKind);
    retranslate();
}

bool BoardForm::isCharuco() const {
    return m_kind->currentIndex() == static_cast<int>(BoardKind::Charuco);
}

Result<Board> BoardForm::board() const {
    Board board;
    board.columns = m_columns->whole();
    board.rows = m_rows->whole();
    board.square_m = m_square->value() / kMmPerM;
    if (isCharuco()) {
        board.kind = BoardKind::Charuco;
        board.marker_m = m_marker->value() / kMmPerM;
        board.dictionary = m_dictionary->currentText().toStdString();
        board.isLegacy = m_legacy->isChecked();
    }
    return parseBoard(boardText(board));
}

void BoardForm::setBoard(const Board& board) {
    const QSignalBlocker quiet(this);
    m_kind->setCurrentIndex(static_cast<int>(board.kind));
    m_columns->setValue(board.columns);
    m_rows->setValue(board.rows);
    m_square->setValue(board.square_m * kMmPerM);
    if (board.kind == BoardKind::Charuco) {
        m_marker->setValue(board.marker_m * kMmPerM);
        m_dictionary->setCurrentText(QString::fromStdString(board.dictionary));
        m_legacy->setChecked(board.isLegacy);
    }
}

void BoardForm::showKind() {
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_markerLabel, m_marker, m_dictionaryLabel, m_dictionary, m_legacy})
        widget->setVisible(isCharuco());
    m_countsLabel->setText(isCharuco() ? tr("S&quares") : tr("Inner cor&ners"));
    m_columns->setAccessibleName(isCharuco() ? tr("Squares across") : tr("Inner corners across"));
    m_rows->setAccessibleName(isCharuco() ? tr("Squares down") : tr("Inner corners down"));
}

void BoardForm::retranslate() {
    m_kindLabel->setText(tr("&Board"));
    m_kind->setItemText(static_cast<int>(BoardKind::Chessboard), tr("Chessboard"));
    m_kind->setItemText(static_cast<int>(BoardKind::Charuco), tr("ChArUco board"));
    m_squareLabel->setText(tr("S&ide of a square"));
    m_square->setToolTip(tr("As measured on the print: over ten squares, divided by ten."));
    m_markerLabel->setText(tr("Side of a &marker"));
    m_marker->setToolTip(tr("With its black border, as measured on the print."));
    m_dictionaryLabel->setText(tr("&Dictionary"));
    nameChoice(m_kind, tr("Kind of board"));
    m_square->setAccessibleName(tr("Side of a square"));
    m_marker->setAccessibleName(tr("Side of a marker"));
    nameChoice(m_dictionary, tr("Dictionary of the markers"));
    m_legacy->setText(tr("Lower left square is black"));
    m_legacy->setToolTip(tr("Boards made by OpenCV before 4.6 with an even number of rows."));
    showKind();
}

void BoardForm::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
