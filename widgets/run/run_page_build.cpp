// How the Run page is put together: its parts, their arrangement and their texts.

#include "widgets/common/elided_label.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/folding_splitter.h"
#include "widgets/common/theme.h"
#include "widgets/common/tile_grid.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/run/controller_panel.h"
#include "widgets/run/run_page.h"
#include "widgets/run/source_tile.h"
#include "widgets/scene/scene_view.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace bask {
namespace {

constexpr double kSpeeds[] = {1.0, 2.0, 5.0, 10.0, 20.0};
constexpr double kWindows_s[] = {0.0, 60.0, 300.0, 1800.0};
constexpr int kGap = 8, kMinSide_px = 300;

QToolButton* viewButton(QWidget* parent, const char* name) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

RunPage::RunPage(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("runPage"));
    setFocusPolicy(Qt::ClickFocus);
    m_tiles = new TileGrid(this);
    m_tiles->setObjectName(QStringLiteral("runTiles"));
    m_source = new SourceTile(this);
    m_source->setProperty(kKeptFree_px, kWholeWidget_px);

    auto* splitter = new FoldingSplitter(this);
    splitter->setObjectName(QStringLiteral("runSplitter"));
    splitter->setHandleWidth(kGap);
    splitter->addWidget(makePlots());
    splitter->addWidget(makeSide());
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 0);
    splitter->setSizes({900, 380});

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kGap, kGap, kGap, kGap);
    layout->setSpacing(kGap);
    layout->addWidget(m_tiles);
    layout->addWidget(m_source);
    layout->addWidget(splitter, 1);

    connectPlots();
    auto* noteKey = new QShortcut(QKeySequence(Qt::Key_N), this);
    connect(noteKey, &QShortcut::activated, m_note, [this] { m_note->setFocus(Qt::ShortcutFocusReason); });
    retranslateUi();
    restyle();
    setFollow(true);
}

RunPage::~RunPage() = default;

PlotPlace* RunPage::makePlot(Quantity quantity) {
    auto* plot = new TracePlot(quantity, this);
    plot->setObjectName(QStringLiteral("plot.") + quantityKey(quantity));
    plot->setStore(m_traces);
    plot->setMarkerTextsVisible(quantity == Quantity::Temperature);
    m_plots.push_back(plot);
    m_places.push_back(new PlotPlace(plot, this));
    return m_places.back();
}

QWidget* RunPage::makePlots() {
    auto* side = new QWidget(this);
    m_follow = new QCheckBox(side);
    m_follow->setObjectName(QStringLiteral("followLive"));
    m_windowLabel = new QLabel(side);
    m_window = new QComboBox(side);
    m_window->setObjectName(QStringLiteral("followWindow"));
    for (double window_s : kWindows_s)
        m_window->addItem(QString(), window_s);
    m_windowLabel->setBuddy(m_window);
    m_showPrediction = new QCheckBox(side);
    m_showPrediction->setObjectName(QStringLiteral("showPrediction"));
    m_showPrediction->setChecked(true);
    m_jump = new QPushButton(side);
    m_jump->setObjectName(QStringLiteral("jumpToLive"));
    auto* bar = new QHBoxLayout;
    bar->setSpacing(kGap);
    bar->addWidget(m_follow);
    bar->addWidget(m_windowLabel);
    bar->addWidget(m_window);
    bar->addWidget(m_showPrediction);
    bar->addStretch(1);
    bar->addWidget(m_jump);

    auto* stack = new QSplitter(Qt::Vertical, side);
    stack->setObjectName(QStringLiteral("plotSplitter"));
    stack->setChildrenCollapsible(false);
    stack->setHandleWidth(kGap);
    stack->addWidget(makePlot(Quantity::Temperature));
    m_tabs = new QTabWidget(stack);
    m_tabs->setObjectName(QStringLiteral("plotTabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->setUsesScrollButtons(true);
    for (const Quantity quantity : furtherQuantities()) {
        const int tab = m_tabs->addTab(makePlot(quantity), QString());
        if (quantity == Quantity::Shade)
            m_shadeTab = tab;
    }
    m_thermal = new ThermalPictureView(m_tabs);
    m_thermal->installEventFilter(this);
    m_thermal->hide();
    stack->addWidget(m_tabs);
    stack->setSizes({330, 230});
    stack->setStretchFactor(0, 3);
    stack->setStretchFactor(1, 2);

    m_noteLabel = new QLabel(side);
    m_note = new QLineEdit(side);
    m_note->setObjectName(QStringLiteral("noteEdit"));
    m_note->setMaxLength(500);
    m_note->setClearButtonEnabled(true);
    m_noteLabel->setBuddy(m_note);
    m_noteAdd = new QPushButton(side);
    m_noteAdd->setObjectName(QStringLiteral("noteAdd"));
    m_noteAdd->setEnabled(false);
    for (QWidget* part : std::initializer_list<QWidget*>{m_note, m_noteAdd})
        part->setProperty(kKeptFree_px, kWholeWidget_px);
    connect(m_note, &QLineEdit::textChanged, m_noteAdd,
            [this](const QString& text) { m_noteAdd->setEnabled(!text.trimmed().isEmpty()); });
    connect(m_note, &QLineEdit::returnPressed, this, &RunPage::addNote);
    connect(m_noteAdd, &QPushButton::clicked, this, &RunPage::addNote);
    auto* noteRow = new QHBoxLayout;
    noteRow->setSpacing(kGap);
    noteRow->addWidget(m_noteLabel);
    noteRow->addWidget(m_note, 1);
    noteRow->addWidget(m_noteAdd);

    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addLayout(bar);
    layout->addWidget(stack, 1);
    layout->addLayout(noteRow);
    return side;
}

QWidget* RunPage::makeSide() {
    auto* side = new QWidget(this);
    m_sceneLabel = new QLabel(side);
    m_viewTop = viewButton(side, "viewTop");
    m_viewSide = viewButton(side, "viewSide");
    m_viewIsometric = viewButton(side, "viewIsometric");
    m_scene = new SceneView(side);
    m_scene->setObjectName(QStringLiteral("runScene"));
    m_scene->setMinimumHeight(56);
    connect(m_viewTop, &QToolButton::clicked, m_scene, [this] { m_scene->viewAlongMinusZ(); });
    connect(m_viewSide, &QToolButton::clicked, m_scene, [this] { m_scene->viewAlongX(); });
    connect(m_viewIsometric, &QToolButton::clicked, m_scene, [this] { m_scene->viewIsometric(); });
    auto* bar = new QHBoxLayout;
    bar->setSpacing(4);
    bar->addWidget(m_sceneLabel);
    bar->addStretch(1);
    bar->addWidget(m_viewTop);
    bar->addWidget(m_viewSide);
    bar->addWidget(m_viewIsometric);

    m_placeMark = new QLabel(side);
    m_limits = new ElidedLabel(side);
    m_limits->setObjectName(QStringLiteral("activeLimits"));
    m_limits->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_shade = new QLabel(side);
    m_shade->setObjectName(QStringLiteral("shade"));
    m_controller = new ControllerPanel(side);
    connect(m_controller, &ControllerPanel::controllerApplied, this, &RunPage::controllerApplied);

    m_speedRow = new QWidget(side);
    m_speedLabel = new QLabel(m_speedRow);
    m_speed = new QComboBox(m_speedRow);
    m_speed->setObjectName(QStringLiteral("simulationSpeed"));
    for (double speed : kSpeeds)
        m_speed->addItem(QStringLiteral("%1\u00d7").arg(speed), speed);
    m_speedLabel->setBuddy(m_speed);
    connect(m_speed, &QComboBox::activated, this,
            [this](int index) { emit simulationSpeedChosen(m_speed->itemData(index).toDouble()); });
    auto* speedLayout = new QHBoxLayout(m_speedRow);
    speedLayout->setContentsMargins(0, 0, 0, 0);
    speedLayout->addWidget(m_speedLabel, 1);
    speedLayout->addWidget(m_speed);

    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addLayout(bar);
    layout->addWidget(m_scene, 1);
    auto* limits = new QHBoxLayout;
    limits->setSpacing(6);
    limits->addWidget(m_placeMark);
    limits->addWidget(m_limits, 1);
    limits->addWidget(m_shade);
    layout->addLayout(limits);
    layout->addWidget(m_controller);
    layout->addWidget(m_speedRow);
    layout->addStrut(kMinSide_px); // wider where the words need it
    return side;
}

void RunPage::connectPlots() {
    connect(m_follow, &QCheckBox::clicked, this, [this](bool on) { setFollow(on); });
    connect(m_jump, &QPushButton::clicked, this, [this] { setFollow(true); });
    connect(m_window, &QComboBox::activated, this, [this](int index) {
        for (TracePlot* plot : m_plots)
            plot->setFollowWindow_s(m_window->itemData(index).toDouble());
        setFollow(true);
    });
    connect(m_showPrediction, &QCheckBox::toggled, this, [this](bool on) {
        for (TracePlot* plot : m_plots)
            plot->setPredictionVisible(on);
        showPlan();
    });
    for (TracePlot* plot : m_plots) {
        connect(plot, &TracePlot::followLiveChanged, this, [this](bool follow) {
            if (m_follow->isChecked() != follow)
                setFollow(follow);
        });
        connect(plot, &TracePlot::timeRangeChosen, this, [this, plot](double from_s, double to_s) {
            for (TracePlot* other : m_plots)
                if (other != plot)
                    other->setTimeRange(from_s, to_s);
            showBehind();
        });
    }
}

void RunPage::retranslateUi() {
    for (TracePlot* plot : m_plots)
        plot->clearMarkers();
    addMarkers(m_events, m_notes);
    m_follow->setText(tr("Follow live"));
    m_follow->setToolTip(
        tr("Keep the newest samples in view. Zooming or dragging a plot turns it off; no sample is lost."));
    m_windowLabel->setText(tr("Show"));
    const QString windows[] = {tr("whole run"), tr("last minute"), tr("last 5 minutes"),
                               tr("last 30 minutes")};
    for (int i = 0; i < m_window->count(); ++i)
        m_window->setItemText(i, windows[i]);
    m_window->setMinimumWidth(m_window->sizeHint().width()); // Qt keeps the minimum of the old words
    m_window->setAccessibleName(tr("Stretch of time shown while following"));
    m_showPrediction->setText(tr("Predicted"));
    m_showPrediction->setToolTip(
        tr("The run as the simulated rig predicts it from where it starts: dotted behind the traces, dashed "
           "in the scene. Its band: %1 runs with other sensor noise; not material, air or source, which are "
           "as the experiment has them. It is kept with the recording.")
            .arg(PredictedRun::kDraws));
    m_jump->setText(tr("Jump to live"));
    m_jump->setAccessibleName(m_jump->text());
    m_jump->setToolTip(tr("Show the newest samples again and follow them."));
    for (std::size_t i = 1; i < m_plots.size(); ++i)
        m_tabs->setTabText(static_cast<int>(i) - 1, quantityTitle(m_plots[i]->quantity()));
    if (const int tab = m_tabs->indexOf(m_thermal); tab >= 0)
        m_tabs->setTabText(tab, tr("Thermal picture"));
    m_tabs->setAccessibleName(tr("Further traces"));
    nameRun();

    m_sceneLabel->setText(tr("Scene"));
    m_viewTop->setText(tr("Top"));
    m_viewTop->setToolTip(tr("Look along \u2212z of the source, from above."));
    m_viewSide->setText(tr("Side"));
    m_viewSide->setToolTip(tr("Look along x of the source, from the side."));
    m_viewIsometric->setText(tr("Isometric"));
    m_viewIsometric->setToolTip(tr("Look from above at an angle."));
    for (QToolButton* button : {m_viewTop, m_viewSide, m_viewIsometric})
        button->setAccessibleName(tr("View: %1").arg(button->text()));
    m_scene->setAccessibleName(tr("3-D scene: source, objects and their paths"));

    m_noteLabel->setText(tr("Note"));
    m_note->setPlaceholderText(tr("Press N, type, Enter: noted at this moment of the run"));
    m_note->setAccessibleName(tr("Note at this moment of the run"));
    m_noteAdd->setText(tr("Add"));
    m_noteAdd->setToolTip(tr("Record the note with the present time."));
    m_noteAdd->setAccessibleName(tr("Add the note"));
    m_speedLabel->setText(tr("Simulation speed"));
    m_speed->setAccessibleName(tr("Simulation speed"));
    m_speed->setToolTip(tr("Simulated seconds a second; only on the simulated rig."));
    showBehind();
}

void RunPage::restyle() {
    m_windowLabel->setPalette(captionPalette(palette()));
    m_noteLabel->setPalette(captionPalette(palette()));
    m_speedLabel->setPalette(captionPalette(palette()));
    m_shade->setPalette(captionPalette(palette()));
}

} // namespace bask
