#include "widgets/objects/import_panel.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/model/experiment.h"
#include "engine/shape/outline_formats.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/theme.h"
#include "widgets/objects/import_questions.h"
#include "widgets/objects/outline_painting.h"
#include "widgets/objects/outline_picker.h"

#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTreeWidget>

#include <Eigen/Geometry>

#include <algorithm>

namespace bask {
namespace {

QImage imageOf(const std::string& path) {
    const auto picture = readPicture(path);
    if (!picture)
        return {}; // reading its outlines says why
    return QImage(picture->rgb.data(), picture->width, picture->height, 3 * qsizetype{picture->width},
                  QImage::Format_RGB888)
        .copy();
}

/// The outlines of a file, which may be one of the program's own (":/...").
Result<OutlineFile> outlinesOf(const QString& path, const ContourImportOptions& options) {
    if (!path.startsWith(QLatin1Char(':')))
        return readOutlines(path.toStdString(), options);
    const auto folder = HiddenFolder::temporary();
    if (!folder)
        return folder.error();
    const std::string copy = folder->place(QFileInfo(path).fileName().toStdString());
    if (QFile own(path); !own.copy(QString::fromStdString(copy)))
        return Error{MessageCode::FileUnwritable, copy, {own.errorString().toStdString()}};
    return readOutlines(copy, options);
}

/// Whether another answer could make something of the file.
bool canBeMended(MessageCode code, const QString& path) {
    using enum MessageCode;
    const auto lost = {FileNotFound, FileUnreadable, FileEmpty, FileTooLarge, ImageUnreadable};
    return ImportQuestions::isImage(path) && std::ranges::find(lost, code) == lost.end();
}

/// Whether all outlines, of which there is one, but the first are holes in it.
bool isOneFace(const OutlineFile& file) {
    return std::all_of(file.outlines.begin() + 1, file.outlines.end(),
                       [](const FileOutline& outline) { return outline.holeIn == std::size_t{0}; });
}

Eigen::AlignedBox2d boxOf(const FileOutline& outline) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : outline.points_m)
        box.extend(p);
    return box;
}

QString lengthPair(const FileOutline& outline, const QString& unit) {
    const Eigen::Vector2d size = kMmPerM * boxOf(outline).sizes();
    return QStringLiteral("%1 \u00d7 %2 %3")
        .arg(QLocale().toString(size.x(), 'f', 1), QLocale().toString(size.y(), 'f', 1), unit);
}

} // namespace

ImportPanel::ImportPanel(QWidget* parent)
    : QWidget(parent), m_picker(new OutlinePicker(this)), m_title(new QLabel(this)),
      m_progress(new QProgressBar(this)), m_questions(new ImportQuestions(this)),
      m_listTitle(new QLabel(this)), m_list(new QTreeWidget(this)), m_chosenText(new QLabel(this)),
      m_warnings(new QLabel(this)), m_problem(new MessageBar(this)), m_accept(new QPushButton(this)),
      m_cancel(new QPushButton(this)) {
    m_title->setObjectName("importFile");
    m_picker->setObjectName("importPicker");
    m_list->setObjectName("importOutlines");
    m_chosenText->setObjectName("importChosen");
    m_warnings->setObjectName("importWarnings");
    m_problem->setObjectName("importProblem");
    m_accept->setObjectName("importAccept");
    m_cancel->setObjectName("importCancel");
    makeBold(m_title);
    m_progress->setRange(0, 0);
    m_progress->setTextVisible(false);
    m_progress->setMaximumHeight(6);
    QSizePolicy keep = m_progress->sizePolicy();
    keep.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keep);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setColumnCount(3);
    m_list->setMinimumHeight(120);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_listTitle->setBuddy(m_list);
    m_chosenText->setWordWrap(true);
    m_warnings->setWordWrap(true);
    m_accept->setDefault(true);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    layout->addWidget(m_picker, 1);
    layout->addWidget(buildForm());
    connectAll();
    retranslate();
}

QWidget* ImportPanel::buildForm() {
    auto* form = new QWidget(this);
    form->setFixedWidth(340);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_accept, 1);
    buttons->addWidget(m_cancel, 1);
    auto* layout = new QVBoxLayout(form);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_progress);
    layout->addWidget(m_problem);
    layout->addWidget(m_questions);
    layout->addWidget(m_listTitle);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_chosenText);
    layout->addWidget(m_warnings);
    layout->addLayout(buttons);
    return form;
}

void ImportPanel::connectAll() {
    connect(m_questions, &ImportQuestions::changed, this, &ImportPanel::read);
    connect(m_questions, &ImportQuestions::toolChanged, m_picker, &OutlinePicker::setTool);
    connect(m_picker, &OutlinePicker::rulerMoved, m_questions, &ImportQuestions::setRuler);
    connect(m_picker, &OutlinePicker::measured, m_questions, &ImportQuestions::releaseTools);
    connect(m_picker, &OutlinePicker::colourPicked, m_questions, &ImportQuestions::setColour);
    connect(m_picker, &OutlinePicker::outlineClicked, this, &ImportPanel::choose);
    connect(m_list, &QTreeWidget::currentItemChanged, this,
            [this](QTreeWidgetItem* item) { choose(m_list->indexOfTopLevelItem(item)); });
    connect(m_list, &QTreeWidget::itemActivated, this, &ImportPanel::accept);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (m_list->selectedItems().isEmpty() && m_chosen >= 0) // a click beside the rows
            choose(m_chosen);
    });
    connect(m_accept, &QPushButton::clicked, this, &ImportPanel::accept);
    auto* escape = new QShortcut(Qt::Key_Escape, this); // wherever the focus is
    connect(escape, &QShortcut::activated, this, [this] {
        if (m_picker->tool() != OutlinePicker::Tool::Pick)
            m_questions->releaseTools();
        else
            m_cancel->click();
    });
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        cancel();
        emit cancelled();
    });
}

bool ImportPanel::isReadable(const QString& path) {
    return outlineFormatOf(path.toStdString()) != nullptr;
}

void ImportPanel::open(const QString& path) {
    cancel();
    m_path = path;
    m_questions->setFile(path);
    retranslate();
    if (ImportQuestions::isImage(path)) {
        m_asking = true;
        emit attentionWanted();
        m_loading.run([file = path.toStdString()] { return imageOf(file); },
                      [this](const QImage& image) {
                          m_picker->setPicture(image);
                          read();
                      });
    }
    read();
}

void ImportPanel::cancel() {
    m_reading.forget();
    m_loading.forget();
    m_path.clear();
    m_asking = false;
    m_file = {};
    m_error.reset();
    m_chosen = -1;
    m_picked.reset();
    m_accept->setEnabled(false); // a key that imports goes on to the panel, which imports, too
    m_picker->clear();
    showOutlines();
}

void ImportPanel::read() {
    if (!isOpen())
        return;
    m_progress->show();
    m_accept->setEnabled(false);
    if (ImportQuestions::isImage(m_path) && m_loading.busy())
        return; // outlines are clicked on the picture; and both at once would take half as much memory again
    m_reading.run([path = m_path, options = m_questions->options()] { return outlinesOf(path, options); },
                  [this](Result<OutlineFile> file) { take(std::move(file)); });
}

void ImportPanel::take(Result<OutlineFile> file) {
    m_progress->hide();
    if (!file && file.error().code() == MessageCode::ContourUnitMissing && m_questions->lengthsKnown()) {
        m_asking = true;
        emit attentionWanted();
        m_questions->setUnitMissing();
        return read();
    }
    if (!file && !canBeMended(file.error().code(), m_path)) {
        const QString path = m_path;
        cancel();
        emit refused(path, file.error());
        return;
    }
    const int wanted = file && file->outlines.size() == m_file.outlines.size() ? m_chosen : 0;
    m_error = file ? std::nullopt : std::optional(file.error());
    m_file = file ? std::move(*file) : OutlineFile{};
    m_picker->setOutlines(m_file);
    m_picker->setRulerShown(m_questions->usesRuler());
    showOutlines();
    choose(m_file.outlines.empty() ? -1 : wanted);
    if (m_asking)
        return;
    const bool nothingToAsk = m_picked && *m_picked && (*m_picked)->warnings.empty() && isOneFace(m_file);
    if (nothingToAsk) {
        accept();
    } else {
        m_asking = true;
        emit attentionWanted();
    }
}

void ImportPanel::choose(int index) {
    m_chosen = index;
    m_picked.reset();
    if (index >= 0)
        m_picked = pickOutline(m_file, static_cast<std::size_t>(index), {});
    m_picker->setSelected(index);
    if (index >= 0)
        m_questions->setWidth_m(boxOf(m_file.outlines[static_cast<std::size_t>(index)]).sizes().x());
    const QSignalBlocker quiet(m_list);
    m_list->setCurrentItem(m_list->topLevelItem(index));
    showChosen();
}

void ImportPanel::accept() {
    if (!m_accept->isEnabled())
        return;
    const QString path = m_path;
    const PickedOutline picked = **m_picked;
    cancel();
    emit accepted(path, picked);
}

void ImportPanel::showOutlines() {
    const QString unit = m_questions->lengthsKnown()        ? tr("mm")
                         : ImportQuestions::isImage(m_path) ? tr("px")
                                                            : tr("units");
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    QList<QTreeWidgetItem*> rows;
    for (std::size_t i = 0; i < m_file.outlines.size(); ++i) {
        const FileOutline& outline = m_file.outlines[i];
        auto* row = new QTreeWidgetItem;
        const QString number = QString::number(i + 1);
        row->setText(0, !outline.closed  ? tr("%1, open").arg(number)
                        : outline.holeIn ? tr("%1, hole in %2").arg(number).arg(*outline.holeIn + 1)
                                         : number);
        row->setText(1, lengthPair(outline, unit));
        row->setText(2,
                     outline.closed
                         ? QStringLiteral("%1 %2\u00b2")
                               .arg(QLocale().toString(outline.area_m2() * kMmPerM * kMmPerM, 'f', 0), unit)
                         : kNoValue);
        rows << row;
    }
    m_list->addTopLevelItems(rows);
}

QString ImportPanel::chosenText(const PickedOutline& picked, int number) {
    const QString text = tr("Outline %1: %2 points, %3 around.")
                             .arg(number)
                             .arg(picked.contour.points_m.size())
                             .arg(formatLength_mm(contourPerimeter(picked.contour)));
    return picked.holes.empty()
               ? text
               : text + QLatin1Char(' ') + tr("%1 counted off.").arg(holesText(picked.holes.size()));
}

void ImportPanel::showChosen() {
    const bool usable = m_picked && *m_picked;
    const bool known = m_questions->lengthsKnown();
    const double radius_m = usable ? shapeRadius(centred((*m_picked)->contour)) : 0.0;
    const bool tooLarge = usable && known && radius_m > kMaxObjectRadius_m;
    if (m_error)
        m_problem->say(MessageBar::Kind::Problem, messageText(m_error->message), {}, false);
    else if (m_picked && !*m_picked)
        m_problem->say(MessageBar::Kind::Problem, messageText(m_picked->error().message), {}, false);
    else if (tooLarge)
        m_problem->say(
            MessageBar::Kind::Problem,
            tr("The outline is %1 across; an object may be %2 at most. Correct its size.")
                .arg(formatLength_mm(2.0 * radius_m, 0), formatLength_mm(2.0 * kMaxObjectRadius_m, 0)),
            {}, false);
    else
        m_problem->clear();
    QStringList remarks;
    for (const Message& warning : usable ? (*m_picked)->warnings : m_file.warnings)
        remarks << messageText(warning);
    m_warnings->setText(remarks.join(QLatin1Char('\n')));
    m_warnings->setVisible(!remarks.isEmpty());
    m_chosenText->setText(!usable ? QString()
                          : known ? chosenText(**m_picked, m_chosen + 1)
                                  : m_questions->missingText());
    m_chosenText->setVisible(usable);
    m_accept->setEnabled(usable && known && !tooLarge &&
                         !m_reading.busy()); // busy: these lengths are of the answer before
}

void ImportPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        accept();
    else
        QWidget::keyPressEvent(event);
}

void ImportPanel::retranslate() {
    m_title->setText(QFileInfo(m_path).fileName());
    m_title->setToolTip(m_path);
    m_listTitle->setText(tr("&Outlines"));
    m_list->setHeaderLabels({tr("Outline"), tr("Size"), tr("Area")});
    m_list->setAccessibleName(tr("Outlines of the file"));
    m_progress->setAccessibleName(tr("Reading the file"));
    m_accept->setText(tr("Import"));
    m_cancel->setText(tr("Cancel"));
    setAccessibleName(tr("Import an outline"));
}

void ImportPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showOutlines();
        choose(m_chosen);
    }
    QWidget::changeEvent(event);
}

} // namespace bask
