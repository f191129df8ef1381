#include "widgets/objects/objects_page.h"

#include "engine/model/experiment_rig.h"
#include "engine/shape/outline_formats.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/folding_splitter.h"
#include "widgets/common/labels.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/theme.h"
#include "widgets/common/upright_scroll.h"
#include "widgets/objects/air_form.h"
#include "widgets/objects/harmonics_panel.h"
#include "widgets/objects/import_panel.h"
#include "widgets/objects/material_presets.h"
#include "widgets/objects/mounting_views.h"
#include "widgets/objects/object_list.h"
#include "widgets/objects/object_properties.h"
#include "widgets/objects/outline_preview.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace bask {
namespace {

constexpr int kImportHarmonics = 20;
constexpr double kNewDiskRadius_m = 0.015;
constexpr double kMountingGap_m = 0.005;
constexpr int kRemarkLines = 5, kListLines = 9;
constexpr int kForm = 310; // px, at least
constexpr int kOutlineTab = 0, kMountingTab = 1;

QString fileSentence(const QString& path, const Error& error) {
    return QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(), messageText(error.message));
}

bool crossesItself(const Shape& shape) {
    const auto* fitted = outlineAs<FourierContour>(shape);
    return fitted != nullptr && (!(fitted->area() > 0.0) || findCrossing(*fitted));
}

/// A Fourier contour that does not cross itself and leaves the holes whole, of more harmonics or else of
/// fewer than usual; one that crosses itself where all do; else the outline itself.
Result<OriginalShape> firstShape(const PickedOutline& picked) {
    std::vector<int> numbers;
    for (int harmonics = kImportHarmonics; harmonics <= kMaxHarmonics; ++harmonics)
        numbers.push_back(harmonics);
    for (int harmonics = kImportHarmonics - 1; harmonics >= 1; --harmonics)
        numbers.push_back(harmonics);
    std::optional<OriginalShape> crossing;
    for (const int harmonics : numbers) {
        auto made = shapeFromOutline(picked.contour, picked.holes, harmonics);
        if (made && !crossesItself(made->shape))
            return made;
        if (made && !crossing)
            crossing = std::move(*made);
    }
    if (crossing)
        return std::move(*crossing);
    return shapeFromOutline(picked.contour, picked.holes, 0);
}

QString droppedFile(const QMimeData* data) {
    const QList<QUrl> urls = data->urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

} // namespace

Contour rawOutline(const ObjectSpec& object) {
    if (!object.origin.outline.points_m.empty())
        return object.origin.outline;
    const auto* polygon = outlineAs<Contour>(object.shape);
    return polygon != nullptr ? *polygon : Contour{};
}

/// The holes in it.
static const std::vector<Contour>& rawHoles(const ObjectSpec& object) {
    return object.origin.outline.points_m.empty() ? holesOf(object.shape) : object.origin.holes;
}

ObjectsPage::ObjectsPage(QWidget* parent) : QWidget(parent) {
    setAcceptDrops(true);
    m_note = new MessageBar(this);
    m_note->setObjectName("editNote");
    m_message = new MessageBar(this);
    m_message->setObjectName("pageMessage");
    m_importPanel = new ImportPanel(this);
    m_importPanel->setObjectName("importPanel");

    auto* outlines = new FoldingSplitter(this);
    outlines->addWidget(buildLeft());
    outlines->addWidget(buildCentre());
    outlines->setStretchFactor(1, 1);
    outlines->setSizes({300, 560});
    auto* splitter = new FoldingSplitter(this);
    splitter->addWidget(outlines);
    splitter->addWidget(buildRight());
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({860, 340});

    m_stack = new QStackedWidget(this);
    m_stack->addWidget(splitter);
    m_stack->addWidget(m_importPanel);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 10, 10, 10);
    layout->addWidget(m_stack, 1);
    new FloatingPlace(*m_note, *this);
    connectAll();
    refreshTexts();
    showAll();
}

ObjectsPage::~ObjectsPage() = default;

QWidget* ObjectsPage::buildLeft() {
    auto* box = new QWidget(this);
    m_listTitle = boldLabel(box);
    m_list = new ObjectList(box);
    m_list->setObjectName("objectList");
    m_list->setMinimumHeight(kListLines * fontMetrics().lineSpacing());
    m_listTitle->setBuddy(m_list);
    m_remarks = new QLabel(box);
    m_remarks->setObjectName("mountingRemarks");
    m_remarks->setWordWrap(true);
    m_remarks->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* remarks = new QScrollArea(box); // always of one height: what comes and goes would move the buttons
    remarks->setWidget(m_remarks);
    remarks->setWidgetResizable(true);
    remarks->setFrameShape(QFrame::NoFrame);
    remarks->setFixedHeight(kRemarkLines * fontMetrics().lineSpacing());
    m_count = new QLabel(box);
    m_count->setObjectName("objectCount");
    m_count->setWordWrap(true);
    const auto button = [box](const char* name) {
        auto* made = new QPushButton(box);
        made->setObjectName(QString::fromLatin1(name));
        return made;
    };
    m_addDisk = button("addDisk");
    m_import = button("importOutline");
    m_samples = button("sampleShapes");
    m_samples->setMenu(new QMenu(m_samples));
    m_duplicate = button("duplicateObject");
    m_remove = button("removeObject");
    m_undoButton = button("undo");
    m_redoButton = button("redo");

    auto* layout = new QGridLayout(box);
    layout->setContentsMargins(0, 0, 6, 0);
    layout->setVerticalSpacing(6);
    layout->addWidget(m_listTitle, 0, 0, 1, 2);
    layout->addWidget(m_list, 1, 0, 1, 2);
    layout->addWidget(m_count, 2, 0, 1, 2);
    layout->addWidget(m_import, 3, 0, 1, 2);
    layout->addWidget(m_addDisk, 4, 0);
    layout->addWidget(m_samples, 4, 1);
    layout->addWidget(m_duplicate, 5, 0);
    layout->addWidget(m_remove, 5, 1);
    layout->addWidget(m_undoButton, 6, 0);
    layout->addWidget(m_redoButton, 6, 1);
    layout->addWidget(remarks, 7, 0, 1, 2);
    layout->setRowStretch(1, 1);
    return box;
}

QWidget* ObjectsPage::buildCentre() {
    auto* box = new QWidget(this);
    m_tabs = new QTabBar(box);
    m_tabs->setObjectName("objectTabs");
    m_tabs->setExpanding(false);
    m_tabs->setDrawBase(false);
    m_tabs->addTab({});
    m_tabs->addTab({});
    m_centre = new QStackedWidget(box);
    auto* outline = new QWidget(m_centre);
    m_preview = new OutlinePreview(outline);
    m_preview->setObjectName("outlinePreview");
    m_harmonics = new HarmonicsPanel(outline);
    auto* rows = new QVBoxLayout(outline);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(m_preview, 1);
    rows->addWidget(m_harmonics);
    m_mounting = new MountingViews(m_centre);
    m_centre->addWidget(outline);
    m_centre->addWidget(m_mounting);

    auto* layout = new QGridLayout(box);
    layout->setContentsMargins(6, 0, 6, 0);
    layout->setVerticalSpacing(0);
    layout->setRowStretch(1, 1);
    layout->addWidget(m_tabs, 0, 0);
    layout->addWidget(m_centre, 1, 0);
    layout->addWidget(m_message, 1, 0, Qt::AlignTop); // over the drawings, so that it moves nothing
    m_message->raise();
    return box;
}

QWidget* ObjectsPage::buildRight() {
    auto* content = new QWidget(this);
    m_properties = new ObjectProperties(content);
    m_air = new AirForm(content);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(6, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_properties);
    layout->addWidget(m_air);
    layout->addStretch(1);

    m_form = new UprightScroll(content, this, kForm);
    return m_form;
}

void ObjectsPage::connectAll() {
    connect(m_list, &ObjectList::objectSelected, this, &ObjectsPage::selectObject);
    connect(m_list, &ObjectList::objectRenamed, this, [this](int index, const QString& name) {
        auto objects = m_experiment.objects;
        objects[static_cast<std::size_t>(index)].name = name.trimmed().toStdString();
        commit(std::move(objects), index);
    });
    connect(m_addDisk, &QPushButton::clicked, this, &ObjectsPage::addDisk);
    connect(m_import, &QPushButton::clicked, this, &ObjectsPage::chooseFile);
    connect(m_duplicate, &QPushButton::clicked, this, &ObjectsPage::duplicateSelected);
    connect(m_remove, &QPushButton::clicked, this, &ObjectsPage::removeSelected);
    connect(m_message, &MessageBar::actionClicked, this, [this] {
        if (m_importing)
            endImport();
        else
            m_undoButton->click();
    });
    connect(m_harmonics, &HarmonicsPanel::fitChanged, this, &ObjectsPage::previewFit);
    connect(m_harmonics, &HarmonicsPanel::fitCommitted, this, &ObjectsPage::commitFit);
    connect(m_harmonics, &HarmonicsPanel::outlineCommitted, this, &ObjectsPage::commitOutline);
    connect(m_harmonics, &HarmonicsPanel::distancesReady, m_preview, &OutlinePreview::setDistances);
    connect(m_properties, &ObjectProperties::objectEdited, this,
            [this](const ObjectSpec& object) { editSelected([&object](ObjectSpec& o) { o = object; }); });
    connect(m_properties, &ObjectProperties::saveMaterialWanted, this, &ObjectsPage::saveMaterialWanted);
    connect(m_properties, &ObjectProperties::materialsWanted, this, &ObjectsPage::materialsWanted);
    connect(m_air, &AirForm::airEdited, this, [this](const Air& air) {
        m_experiment.air = air;
        emitEdited();
    });
    connect(m_tabs, &QTabBar::currentChanged, m_centre, &QStackedWidget::setCurrentIndex);
    connect(m_mounting, &MountingViews::objectClicked, this, &ObjectsPage::selectObject);
    connect(m_mounting, &MountingViews::objectDragged, this, &ObjectsPage::showDragged);
    connect(m_mounting, &MountingViews::objectMoved, this, [this](int index, const Vector6d& mounting) {
        selectObject(index);
        editSelected([&mounting](ObjectSpec& o) { o.mounting = mounting; });
    });
    connect(m_importPanel, &ImportPanel::attentionWanted, this, [this] { showPanel(true); });
    connect(m_importPanel, &ImportPanel::cancelled, this, [this] { showPanel(false); });
    connect(m_importPanel, &ImportPanel::accepted, this, &ObjectsPage::addImported);
    connect(m_importPanel, &ImportPanel::refused, this, [this](const QString& path, const Error& error) {
        showPanel(false);
        showError(fileSentence(path, error));
    });
}

bool ObjectsPage::hasSelection() const {
    return m_selected >= 0 && m_selected < static_cast<int>(m_experiment.objects.size());
}

void ObjectsPage::setExperiment(const Experiment& experiment) {
    if (experiment == m_experiment)
        return;
    if (!m_committing && experiment.objects != m_experiment.objects)
        endImport(); // it was for others
    if (!m_committing && !m_importing)
        m_message->clear(); // its Undo would take back something else
    m_experiment = experiment;
    m_selected = std::clamp(m_selected, experiment.objects.empty() ? -1 : 0,
                            static_cast<int>(experiment.objects.size()) - 1);
    showAll();
}

void ObjectsPage::setEditable(bool editable, const QString& why) {
    m_editable = editable;
    if (!editable)
        endImport();
    m_why = why;
    refreshTexts();
    updateEnabled();
}

void ObjectsPage::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_properties->setTemperatureUnit(unit);
    m_air->setTemperatureUnit(unit);
    m_list->setObjects(m_experiment.objects, m_selected, unit);
}

void ObjectsPage::selectObject(int index) {
    if (index == m_selected || index < -1 || index >= static_cast<int>(m_experiment.objects.size()))
        return;
    m_selected = index;
    showAll();
}

void ObjectsPage::setUndoActions(QAction* undo, QAction* redo) {
    const auto mirror = [this](QPushButton* button, QAction* action) {
        const auto show = [button, action] {
            button->setEnabled(action->isEnabled());
            button->setToolTip(action->toolTip());
        };
        connect(action, &QAction::changed, button, show);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        show();
    };
    mirror(m_undoButton, undo);
    mirror(m_redoButton, redo);
}

bool ObjectsPage::isReadable(const QString& path) {
    return ImportPanel::isReadable(path);
}

void ObjectsPage::commit(std::vector<ObjectSpec> objects, int select) {
    if (objects == m_experiment.objects) {
        showAll();
        return;
    }
    m_experiment.objects = std::move(objects);
    if (select >= 0)
        m_selected = select;
    m_selected = std::min(m_selected, static_cast<int>(m_experiment.objects.size()) - 1);
    emitEdited();
}

void ObjectsPage::emitEdited() {
    if (!m_importing) // then it is the message that offers to cancel
        m_message->clear();
    showAll();
    m_committing = true;
    const Experiment edited = m_experiment; // a receiver may set another one
    emit experimentEdited(edited);
    m_committing = false;
}

void ObjectsPage::editSelected(const std::function<void(ObjectSpec&)>& change) {
    if (!hasSelection() || !m_editable)
        return;
    auto objects = m_experiment.objects;
    change(objects[static_cast<std::size_t>(m_selected)]);
    commit(std::move(objects));
}

std::string ObjectsPage::uniqueName(const QString& wish) const {
    const auto taken = [this](const QString& name) {
        return std::ranges::any_of(m_experiment.objects,
                                   [&](const ObjectSpec& o) { return o.name == name.toStdString(); });
    };
    QString name = wish;
    for (int i = 2; taken(name); ++i)
        name = QStringLiteral("%1 %2").arg(wish).arg(i);
    return name.toStdString();
}

Eigen::Vector2d ObjectsPage::freePlace(const Shape& shape) const {
    const double radius = shapeRadius(shape);
    const auto isFree = [&](const Eigen::Vector2d& place) {
        return std::ranges::all_of(m_experiment.objects, [&](const ObjectSpec& o) {
            const double gap = (o.mounting.head<2>() - place).norm() - shapeRadius(o.shape) - radius;
            return gap >= kMountingGap_m;
        });
    };
    for (int ring = 0; ring <= 8; ++ring) {
        for (int k = 0; k < (ring == 0 ? 1 : 12); ++k) {
            const double angle = radFromDeg(90.0 + 30.0 * k);
            Eigen::Vector2d place = 0.025 * ring * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            if (isFree(place))
                return place;
        }
    }
    return Eigen::Vector2d::Zero();
}

void ObjectsPage::addObject(ObjectSpec object) {
    object.mounting.head<2>() = freePlace(object.shape); // a copy keeps its height and its angles
    auto objects = m_experiment.objects;
    objects.push_back(std::move(object));
    const int index = static_cast<int>(objects.size()) - 1;
    commit(std::move(objects), index);
}

void ObjectsPage::setMaterialLibrary(const MaterialLibrary& library) {
    m_properties->setMaterialLibrary(library);
}

void ObjectsPage::nameMaterial(const Material& saved) {
    if (!m_editable || !hasSelection() || !areOneMaterial(selected().material, saved))
        return;
    editSelected([&saved](ObjectSpec& object) {
        object.material.name = saved.name;
        object.material.source = saved.source;
        object.material.date = saved.date;
        object.material.uncertainties = saved.uncertainties;
    });
}

void ObjectsPage::addDisk() {
    ObjectSpec object;
    object.name = uniqueName(tr("disk"));
    object.shape = Disk{kNewDiskRadius_m};
    object.material = materialPresets().front().material;
    addObject(std::move(object));
}

void ObjectsPage::duplicateSelected() {
    if (!hasSelection())
        return;
    ObjectSpec object = selected();
    object.name = uniqueName(QString::fromStdString(object.name));
    addObject(std::move(object));
}

void ObjectsPage::removeSelected() {
    if (!hasSelection())
        return;
    const QString name = QString::fromStdString(selected().name);
    auto objects = m_experiment.objects;
    objects.erase(objects.begin() + m_selected);
    commit(std::move(objects));
    if (m_message->isHidden())
        m_message->say(MessageBar::Kind::Note, tr("\u201c%1\u201d was removed.").arg(name), tr("Undo"));
}

void ObjectsPage::addImported(const QString& path, const PickedOutline& picked) {
    showPanel(false);
    sayReading(path);
    // The first fit of an outline of many thousand points takes longer than a frame may.
    m_fitting.run([picked] { return firstShape(picked); },
                  [this, path](const Result<OriginalShape>& made) {
                      m_importing = false;
                      m_message->clear();
                      if (!made) {
                          showError(fileSentence(path, made.error()));
                          return;
                      }
                      if (!m_import->isEnabled()) { // a disk was added meanwhile, and all axes are used
                          showError(m_import->toolTip());
                          return;
                      }
                      ObjectSpec object;
                      object.name = uniqueName(QFileInfo(path).completeBaseName().trimmed());
                      object.shape = made->shape;
                      object.origin = made->origin;
                      object.origin.file = QFileInfo(path).fileName().toStdString();
                      object.material = materialPresets().front().material;
                      addObject(std::move(object));
                      focusImported();
                  });
}

/// The name is what one edits next; else the keyboard could be on Remove, since a button that is greyed or
/// hidden hands it on. Nothing is taken from who types meanwhile, or is elsewhere.
void ObjectsPage::focusImported() {
    const QWidget* now = window()->focusWidget();
    const bool isTyping = qobject_cast<const QLineEdit*>(now) != nullptr ||
                          qobject_cast<const QAbstractSpinBox*>(now) != nullptr;
    if (!isVisible() || isTyping || (now != nullptr && now != this && !isAncestorOf(now)))
        return;
    m_form->verticalScrollBar()->setValue(0);
    m_properties->focusName();
}

void ObjectsPage::showPanel(bool shown) {
    const bool hadFocus = m_importPanel->isAncestorOf(window()->focusWidget());
    m_importing = false;
    m_message->clear();
    m_stack->setCurrentIndex(shown ? 1 : 0);
    if (!shown && hadFocus) // not to whom Qt hands it on
        m_import->isEnabled() ? m_import->setFocus() : m_list->setFocus();
}

void ObjectsPage::endImport() {
    if (!m_importing && !m_importPanel->isOpen())
        return;
    m_importPanel->cancel();
    m_fitting.forget();
    showPanel(false);
}

void ObjectsPage::sayReading(const QString& path) {
    m_importing = true;
    m_message->say(MessageBar::Kind::Note, tr("Reading %1\u2026").arg(QFileInfo(path).fileName()),
                   tr("Cancel"), false);
}

void ObjectsPage::showError(const QString& sentence) {
    m_message->say(MessageBar::Kind::Problem, sentence);
}

void ObjectsPage::offerFile(const QString& path) {
    if (!m_import->isEnabled())
        return showError(m_import->toolTip());
    endImport();
    if (ImportPanel::isReadable(path)) {
        sayReading(path);
        m_importPanel->open(path);
        return;
    }
    const auto names = [](OutlineKind kind) { return QString::fromStdString(outlineFormatNames(kind)); };
    showError(
        tr("%1 is not a kind of file that can be imported. Use a drawing (%2), a list of x, y points (%3) "
           "or a picture of a silhouette (%4).")
            .arg(QFileInfo(path).fileName(), names(OutlineKind::Drawing), names(OutlineKind::List),
                 names(OutlineKind::Picture)));
}

void ObjectsPage::chooseFile() {
    const QString path = askFileToOpen(
        this, tr("Import an outline"),
        tr("Outlines (%1);;All files (*)").arg(QString::fromStdString(outlineEndings("*.", " "))),
        FileFolder::Imports);
    if (!path.isEmpty())
        offerFile(path);
}

/// What is no outline is the window's to take or to refuse.
void ObjectsPage::dragEnterEvent(QDragEnterEvent* event) {
    if (isReadable(droppedFile(event->mimeData())))
        event->acceptProposedAction();
}

void ObjectsPage::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    offerFile(droppedFile(event->mimeData()));
}

void ObjectsPage::previewFit(const FourierFit& fit) {
    if (hasSelection())
        m_preview->setObject(QString::fromStdString(selected().name), shapeOfFit(fit, rawHoles(selected())),
                             rawOutline(selected()), seriesColor(m_selected, isDark(this)));
}

void ObjectsPage::commitFit(const FourierFit& fit) {
    const Contour raw = hasSelection() ? rawOutline(selected()) : Contour{};
    editSelected([&](ObjectSpec& object) {
        object.origin.holes = rawHoles(object);
        object.shape = shapeOfFit(fit, object.origin.holes);
        object.origin.outline = raw;
        object.origin.harmonics = fit.contour.harmonics();
    });
}

void ObjectsPage::commitOutline(const Contour& polygon) {
    if (!hasSelection())
        return;
    const Contour raw = rawOutline(selected());
    const std::vector<Contour>& holes = rawHoles(selected());
    std::size_t corners = kMaxCorners; // of outline and holes together
    for (const Contour& hole : holes)
        corners -= std::min(corners, hole.points_m.size());
    const auto made = shapeFromOutline(simplifiedTo(polygon, std::max<std::size_t>(corners, 3)), holes, 0);
    if (!made) {
        showError(messageText(made.error().message));
        return;
    }
    editSelected([&](ObjectSpec& object) {
        object.origin.holes = rawHoles(object);
        object.shape = made->shape;
        object.origin.outline = raw;
        object.origin.harmonics = 0;
    });
}

void ObjectsPage::showAll() {
    m_list->setObjects(m_experiment.objects, m_selected, m_unit);
    showMounting();
    showSelected();
    refreshTexts();
    updateEnabled();
}

void ObjectsPage::showMounting() {
    m_mounting->setObjects(m_experiment.objects, m_selected, m_experiment.robot.maxMountingRadius_m);
    findRemarks(m_experiment);
}

void ObjectsPage::showDragged(int index, const Vector6d& mounting) {
    Experiment dragged = m_experiment;
    dragged.objects[static_cast<std::size_t>(index)].mounting = mounting;
    m_properties->setObject(dragged.objects[static_cast<std::size_t>(index)]);
    findRemarks(dragged);
}

void ObjectsPage::findRemarks(const Experiment& experiment) {
    m_mountingRemarks = mountingRemarks(experiment);
    m_shading.run([experiment] { return shadeRemarks(experiment, experiment.start, ShadedPose::Start); },
                  [this, count = experiment.objects.size()](std::vector<MountingRemark> shade) {
                      if (count != m_experiment.objects.size())
                          return;
                      m_shade = std::move(shade);
                      showRemarks();
                  });
    const auto isGone = [this](int i) { return i >= static_cast<int>(m_experiment.objects.size()); };
    std::erase_if(m_shade,
                  [&](const MountingRemark& remark) { return std::ranges::any_of(remark.objects, isGone); });
    showRemarks();
}

void ObjectsPage::showRemarks() {
    std::set<int> remarked;
    QStringList sentences;
    for (const auto* remarks : {&m_mountingRemarks, &m_shade})
        for (const MountingRemark& remark : *remarks) {
            sentences << QStringLiteral("\u2022 ") + messageText(remark.message);
            remarked.insert(remark.objects.begin(), remark.objects.end());
        }
    m_remarks->setText(sentences.join(QLatin1Char('\n')));
    m_mounting->setRemarked(remarked);
}

void ObjectsPage::showSelected() {
    const bool some = hasSelection();
    m_properties->setVisible(some);
    m_air->setExperiment(m_experiment, m_selected);
    if (!some) {
        m_preview->clear();
        m_harmonics->setOutline({}, 0, Qt::gray, QString());
        return;
    }
    const QColor color = seriesColor(m_selected, isDark(this));
    const Contour raw = rawOutline(selected());
    const auto* series = outlineAs<FourierContour>(selected().shape);
    const bool disk = outlineAs<Disk>(selected().shape) != nullptr;
    m_preview->setObject(QString::fromStdString(selected().name), selected().shape, raw, color);
    m_harmonics->setHoles(rawHoles(selected()));
    m_harmonics->setOutline(
        raw, series != nullptr ? series->harmonics() : 0, color,
        disk ? tr("A disk is used as it is; it needs no fit.")
             : tr("No imported outline is kept with this object, so it cannot be fitted again."));
    m_properties->setSurroundings(surroundingsOf(m_experiment));
    m_properties->setObject(selected());
}

void ObjectsPage::updateEnabled() {
    const bool room = static_cast<int>(m_experiment.objects.size()) < m_experiment.robot.degreesOfFreedom();
    const bool some = hasSelection();
    m_addDisk->setEnabled(m_editable && room);
    m_import->setEnabled(m_editable && room);
    m_samples->setEnabled(m_editable && room);
    m_duplicate->setEnabled(m_editable && room && some);
    m_remove->setEnabled(m_editable && some);
    m_list->setRenamable(m_editable);
    m_properties->setReadOnly(!m_editable);
    m_air->setReadOnly(!m_editable);
    m_mounting->setReadOnly(!m_editable);
    m_harmonics->setEnabled(m_editable);
    const QString full =
        room ? QString()
             : tr("Each object needs a free axis of the robot of its own; all are used. Remove an "
                  "object first.");
    for (QPushButton* button : {m_addDisk, m_import, m_samples, m_duplicate})
        button->setToolTip(m_editable ? full : m_why);
}

void ObjectsPage::refreshTexts() {
    m_listTitle->setText(tr("&Objects"));
    m_addDisk->setText(tr("Add &disk"));
    m_import->setText(tr("&Import outline\u2026"));
    m_samples->setText(tr("&Sample shapes"));
    m_samples->menu()->clear();
    for (const auto& [file, name] : {std::pair("bunny.csv", tr("Bunny")),
                                     std::pair("circle.svg", tr("Circle")), std::pair("gear.svg", tr("Gear")),
                                     std::pair("hand.csv", tr("Hand")), std::pair("leaf.svg", tr("Leaf"))})
        m_samples->menu()->addAction(name, this,
                                     [this, path = QStringLiteral(":/samples/") + file] { offerFile(path); });
    m_duplicate->setText(tr("Du&plicate"));
    m_remove->setText(tr("&Remove"));
    m_undoButton->setText(tr("&Undo"));
    m_redoButton->setText(tr("Redo"));
    m_tabs->setTabText(kOutlineTab, tr("Outline"));
    m_tabs->setTabText(kMountingTab, tr("Mounting"));
    m_count->setText(tr("%1 of %2 degrees of freedom used")
                         .arg(m_experiment.objects.size())
                         .arg(m_experiment.robot.degreesOfFreedom()));
    m_count->setPalette(captionPalette(palette()));
    if (m_editable)
        m_note->clear();
    else
        m_note->say(MessageBar::Kind::Note, m_why, {}, false);
}

void ObjectsPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        m_message->clear(); // its sentence is in the language before
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showAll();
    QWidget::changeEvent(event);
}

} // namespace bask
