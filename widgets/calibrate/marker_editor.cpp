#include "widgets/calibrate/marker_editor.h"

#include "engine/base/units.h"
#include "engine/model/coordinate_range.h"
#include "engine/model/experiment_parameters.h"
#include "widgets/common/coordinate_field.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

#include <algorithm>
#include <utility>

namespace bask {
namespace {

constexpr int kRows = 5;
enum MarkerColumn { kPart, kId, kSide, kSeen };

QString partName(Part part) {
    switch (part) {
    case Part::Source:
        return MarkerEditor::tr("Source");
    case Part::EndEffector:
        return MarkerEditor::tr("End-effector");
    case Part::Base:
        return MarkerEditor::tr("Base");
    }
    return {};
}

} // namespace

MarkerEditor::MarkerEditor(QWidget* parent)
    : QWidget(parent), m_dictionaryLabel(new QLabel(this)), m_dictionary(new QComboBox(this)),
      m_list(new QTreeWidget(this)), m_add(new QPushButton(this)), m_remove(new QPushButton(this)),
      m_part(new QComboBox(this)), m_id(new WholeNumberField(this)),
      m_side(number(QStringLiteral("markerSide"))) {
    const ValidRange& side_mm = parameterOf(markerParameters(), &MarkerSpec::side_m).range;
    m_side->setRange(side_mm.min, side_mm.max);
    m_dictionary->setObjectName("markerDictionary");
    m_dictionaryLabel->setBuddy(m_dictionary);
    for (const QString& name : QString::fromStdString(markerDictionaries()).split(QStringLiteral(", ")))
        if (isMarkerDictionary(name.toStdString()))
            m_dictionary->addItem(name);
    m_list->setObjectName("markerList");
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFixedHeight((kRows + 1) * (fontMetrics().height() + 8));
    m_list->setColumnCount(4);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
    m_add->setObjectName("markerAdd");
    m_remove->setObjectName("markerRemove");
    m_part->setObjectName("markerPart");
    for (const Part part : {Part::Source, Part::EndEffector, Part::Base})
        m_part->addItem({}, static_cast<int>(part));
    m_id->setObjectName("markerId");
    m_id->setKeyboardTracking(false);

    auto* top = new QHBoxLayout;
    top->addWidget(m_dictionaryLabel);
    top->addWidget(m_dictionary);
    top->addStretch(1);
    top->addWidget(m_add);
    top->addWidget(m_remove);
    auto* form = new QGridLayout;
    buildForm(form);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(top);
    layout->addWidget(m_list);
    layout->addLayout(form);

    connect(m_dictionary, &QComboBox::activated, this, [this] {
        VisionSpec changed = m_vision;
        changed.dictionary = m_dictionary->currentText().toStdString();
        emit visionEdited(changed);
    });
    connect(m_list, &QTreeWidget::currentItemChanged, this, &MarkerEditor::showForm);
    connect(m_add, &QPushButton::clicked, this, &MarkerEditor::add);
    connect(m_remove, &QPushButton::clicked, this, &MarkerEditor::remove);
    connect(m_part, &QComboBox::activated, this, [this](int row) {
        edit([part = static_cast<Part>(m_part->itemData(row).toInt())](MarkerSpec& m) { m.part = part; });
    });
    connect(m_id, &QDoubleSpinBox::valueChanged, this,
            [this] { edit([id = m_id->whole()](MarkerSpec& m) { m.id = id; }); });
    connect(m_side, &QDoubleSpinBox::valueChanged, this,
            [this](double side) { edit([side](MarkerSpec& m) { m.side_m = side / kMmPerM; }); });
    QWidget* before = m_dictionary; // as it is read
    for (QWidget* next : std::initializer_list<QWidget*>{m_add, m_remove, m_list, m_part})
        setTabOrder(std::exchange(before, next), next);
    retranslate();
}

QDoubleSpinBox* MarkerEditor::number(const QString& name) {
    auto* field = new NumberField(this);
    field->setObjectName(name);
    field->setDecimals(2);
    field->setSingleStep(1.0);
    field->setKeyboardTracking(false);
    field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return field;
}

void MarkerEditor::buildForm(QGridLayout* form) {
    form->setHorizontalSpacing(10);
    form->setVerticalSpacing(3);
    const auto place = [&](std::size_t index, QWidget* field) {
        m_captions[index] = new QLabel(this);
        m_captions[index]->setBuddy(field);
        const int row = 2 * static_cast<int>(index / 3), column = static_cast<int>(index % 3);
        form->addWidget(m_captions[index], row, column, Qt::AlignBottom);
        form->addWidget(field, row + 1, column);
        form->setColumnStretch(column, 1);
    };
    place(0, m_part);
    place(1, m_id);
    place(2, m_side);
    for (int k = 0; k < 6; ++k) {
        const auto index = static_cast<std::size_t>(k);
        const QString name = QStringLiteral("marker.") + QLatin1String(kCoordinateNames[index]);
        m_pose[index] = number(name);
        setCoordinateRange(*m_pose[index], k, coordinateRange(k, kMaxPlace_cm, true));
        place(3 + index, m_pose[index]);
        connect(m_pose[index], &QDoubleSpinBox::valueChanged, this, [this, k](double value) {
            edit(
                [k, value](MarkerSpec& m) { m.pose[k] = k < kThetaX ? value / kMmPerM : radFromDeg(value); });
        });
    }
}

int MarkerEditor::selected() const {
    return m_list->indexOfTopLevelItem(m_list->currentItem());
}

void MarkerEditor::edit(const std::function<void(MarkerSpec&)>& change) {
    const int index = selected();
    if (m_showing || index < 0)
        return;
    VisionSpec changed = m_vision;
    change(changed.markers[static_cast<std::size_t>(index)]);
    emit visionEdited(changed);
}

int MarkerEditor::freeId() const {
    const auto isListed = [this](int id) {
        return std::ranges::find(m_vision.markers, id, &MarkerSpec::id) != m_vision.markers.end();
    };
    for (const ViewedMarker& seen : m_seen)
        if (!isListed(seen.marker.id))
            return seen.marker.id;
    int id = 0;
    while (isListed(id))
        ++id;
    return id;
}

void MarkerEditor::add() {
    VisionSpec changed = m_vision;
    MarkerSpec marker = changed.markers.empty() ? MarkerSpec() : changed.markers.back();
    marker.id = freeId();
    changed.markers.push_back(marker);
    emit visionEdited(changed);
    if (m_list->topLevelItemCount() > 0)
        m_list->setCurrentItem(m_list->topLevelItem(m_list->topLevelItemCount() - 1));
}

void MarkerEditor::remove() {
    const int index = selected();
    if (index < 0)
        return;
    VisionSpec changed = m_vision;
    changed.markers.erase(changed.markers.begin() + index);
    emit visionEdited(changed);
}

void MarkerEditor::setVision(const VisionSpec& vision) {
    const bool isSame = vision.markers == m_vision.markers && vision.dictionary == m_vision.dictionary;
    m_vision = vision;
    if (!isSame)
        return showList();
    m_dictionary->setCurrentText(QString::fromStdString(vision.dictionary)); // what was refused is taken back
    showForm();
}

void MarkerEditor::setView(const VisionView& view) {
    m_seen = view.markers;
    showSeen();
}

void MarkerEditor::showList() {
    const int before = std::max(selected(), 0);
    {
        const QSignalBlocker block(m_list);
        m_list->clear();
        for (const MarkerSpec& marker : m_vision.markers)
            new QTreeWidgetItem(m_list, {partName(marker.part), QString::number(marker.id),
                                         formatLength_mm(marker.side_m, 1), QString()});
        if (m_list->topLevelItemCount() > 0)
            m_list->setCurrentItem(m_list->topLevelItem(std::min(before, m_list->topLevelItemCount() - 1)));
    }
    m_dictionary->setCurrentText(QString::fromStdString(m_vision.dictionary));
    {
        const QSignalBlocker block(m_id); // a smaller one must not become an edit
        m_id->setMaximum(std::max(0, markerCount({m_vision.dictionary}) - 1));
    }
    showSeen();
    showForm();
}

void MarkerEditor::showSeen() {
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        const int id = m_vision.markers[static_cast<std::size_t>(i)].id;
        const auto seen =
            std::ranges::find_if(m_seen, [id](const ViewedMarker& m) { return m.marker.id == id; });
        QString text = seen == m_seen.end() ? tr("not seen") : tr("seen");
        if (seen != m_seen.end() && seen->poses)
            text = seen->poses->isAmbiguous
                       ? tr("two poses fit")
                       : tr("%1 px off").arg(QLocale().toString(seen->poses->best.rms_px, 'f', 1));
        if (m_list->topLevelItem(i)->text(kSeen) != text)
            m_list->topLevelItem(i)->setText(kSeen, text);
    }
}

void MarkerEditor::showForm() {
    const int index = selected();
    const bool any = index >= 0;
    m_remove->setEnabled(any);
    std::vector<QWidget*> fields{m_part, m_id, m_side};
    fields.insert(fields.end(), m_pose.begin(), m_pose.end());
    for (QWidget* field : fields)
        field->setEnabled(any);
    if (!any)
        return;
    const MarkerSpec& marker = m_vision.markers[static_cast<std::size_t>(index)];
    m_showing = true;
    m_part->setCurrentIndex(m_part->findData(static_cast<int>(marker.part)));
    m_id->setValue(marker.id);
    m_side->setValue(marker.side_m * kMmPerM);
    for (int k = 0; k < 6; ++k)
        m_pose[static_cast<std::size_t>(k)]->setValue(k < kThetaX ? marker.pose[k] * kMmPerM
                                                                  : degFromRad(marker.pose[k]));
    m_showing = false;
}

void MarkerEditor::retranslate() {
    m_dictionaryLabel->setText(tr("Dictionary"));
    nameChoice(m_dictionary, m_dictionaryLabel->text());
    m_list->setHeaderLabels({tr("On"), tr("Id"), tr("Side"), tr("Camera")});
    m_list->setAccessibleName(tr("Markers of the rig"));
    m_add->setText(tr("Add"));
    m_add->setToolTip(tr("Lists another marker: one that the camera sees and that is not listed, if there is "
                         "one"));
    m_remove->setText(tr("Remove"));
    for (int i = 0; i < m_part->count(); ++i)
        m_part->setItemText(i, partName(static_cast<Part>(m_part->itemData(i).toInt())));
    const std::array captions{tr("Sits on"),
                              tr("Id"),
                              tr("Side, mm"),
                              tr("x, mm"),
                              tr("y, mm"),
                              tr("z, mm"),
                              tr("turned about x, \u00b0"),
                              tr("about y, \u00b0"),
                              tr("about z, \u00b0")};
    for (std::size_t i = 0; i < m_captions.size(); ++i)
        m_captions[i]->setText(captions[i]);
    nameChoice(m_part, captions[0]);
    m_id->setAccessibleName(captions[1]);
    m_side->setAccessibleName(captions[2]);
    m_side->setToolTip(tr("With the black border, as measured on the print"));
    for (std::size_t k = 0; k < 6; ++k) {
        m_pose[k]->setAccessibleName(captions[3 + k]);
        m_pose[k]->setToolTip(tr("Where the marker's middle is on its part, and how its axes (x right, y up, "
                                 "z out of it) are turned there"));
    }
    showList();
}

void MarkerEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
