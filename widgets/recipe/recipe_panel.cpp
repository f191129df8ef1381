#include "widgets/recipe/recipe_panel.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/scrolling.h"
#include "widgets/common/theme.h"
#include "widgets/recipe/recipe_step_dialog.h"
#include "widgets/recipe/recipe_words.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace bask {
namespace {

enum Column { kNumber, kStep, kUntil, kMaxDuration, kElapsed, kState, kColumns };
constexpr int kIcon = 14;

RecipeStep waiting(RecipeStep::Until until, const QStringList& objects) {
    RecipeStep step;
    step.until = until;
    step.duration_s = 60.0;
    step.object = objects.isEmpty() ? std::string() : objects.first().toStdString();
    return step;
}

} // namespace

RecipePanel::RecipePanel(QWidget* parent)
    : QWidget(parent), m_edits(new QWidget(this)), m_tree(new QTreeWidget(this)), m_state(new QLabel(this)),
      m_openMenu(new QMenu(this)), m_exampleMenu(new QMenu(this)), m_addMenu(new QMenu(this)) {
    build();
    const auto on = [this](QPushButton* button, auto slot) {
        connect(button, &QPushButton::clicked, this, slot);
    };
    on(m_save, &RecipePanel::saveRequested);
    on(m_edit, &RecipePanel::editCurrent);
    on(m_remove, &RecipePanel::removeCurrent);
    on(m_start, &RecipePanel::startRequested);
    on(m_stopNow, &RecipePanel::stopNowRequested);
    on(m_stopAfter, &RecipePanel::stopAfterStepRequested);
    on(m_session, [this] {
        emit sessionRequested(
            QString::fromStdString(m_view.progress[static_cast<std::size_t>(current())].recording));
    });
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &RecipePanel::showButtons);
    connect(m_tree, &QTreeWidget::itemActivated, this, &RecipePanel::editCurrent);
    connect(m_new, &QAction::triggered, this, &RecipePanel::newRequested);
    connect(m_open, &QAction::triggered, this, &RecipePanel::openRequested);
    connect(m_saveAs, &QAction::triggered, this, &RecipePanel::saveAsRequested);
    connect(m_addCurrent, &QAction::triggered, this, &RecipePanel::addCurrentRequested);
    connect(m_addFile, &QAction::triggered, this, &RecipePanel::addFileRequested);
    connect(m_addWait, &QAction::triggered, this,
            [this] { add(waiting(RecipeStep::Until::Time, m_objects)); });
    connect(m_addCondition, &QAction::triggered, this,
            [this] { add(waiting(RecipeStep::Until::Below, m_objects)); });
    retranslate();
}

QPushButton* RecipePanel::makeButton(const char* name) {
    auto* button = new QPushButton(this);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    return button;
}

void RecipePanel::build() {
    setObjectName(QStringLiteral("recipePanel"));
    m_tree->setObjectName(QStringLiteral("recipeTree"));
    m_tree->setColumnCount(kColumns);
    m_tree->setRootIsDecorated(false);
    m_tree->setUniformRowHeights(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setMinimumHeight(48);
    m_tree->setTabKeyNavigation(false);
    m_tree->header()->setSectionsMovable(false);
    m_tree->header()->setStretchLastSection(true);
    m_tree->header()->setResizeContentsPrecision(0); // by the rows in view
    for (int column = 0; column < kState; ++column)
        m_tree->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_state->setObjectName(QStringLiteral("recipeState"));
    m_state->setWordWrap(true);
    m_file = makeButton("recipeFile");
    m_save = makeButton("recipeSave");
    m_add = makeButton("recipeAdd");
    m_edit = makeButton("recipeEdit");
    m_remove = makeButton("recipeRemove");
    m_start = makeButton("recipeStart");
    m_stopAfter = makeButton("recipeStopAfter");
    m_stopAfter->setCheckable(true);
    m_stopNow = makeButton("recipeStopNow");
    m_session = makeButton("recipeSession");
    for (QToolButton** button : {&m_up, &m_down}) {
        *button = new QToolButton(this);
        (*button)->setArrowType(button == &m_up ? Qt::UpArrow : Qt::DownArrow);
        (*button)->setObjectName(button == &m_up ? QStringLiteral("recipeUp") : QStringLiteral("recipeDown"));
        (*button)->setFocusPolicy(Qt::StrongFocus);
    }
    m_new = m_openMenu->addAction(QString());
    m_open = m_openMenu->addAction(QString());
    m_openMenu->addMenu(m_exampleMenu);
    m_saveAs = m_openMenu->addAction(QString());
    m_addCurrent = m_addMenu->addAction(QString());
    m_addFile = m_addMenu->addAction(QString());
    m_addWait = m_addMenu->addAction(QString());
    m_addCondition = m_addMenu->addAction(QString());
    m_openMenu->setObjectName(QStringLiteral("recipeFileMenu"));
    m_addMenu->setObjectName(QStringLiteral("recipeAddMenu"));
    m_file->setMenu(m_openMenu);
    m_add->setMenu(m_addMenu);

    auto* edits = new QHBoxLayout(m_edits);
    edits->setContentsMargins(0, 0, 0, 0);
    edits->setSpacing(6);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_file, m_save, m_add, m_edit, m_remove, m_up, m_down})
        edits->addWidget(widget);
    edits->addStretch(1);
    auto* verbs = new QHBoxLayout;
    verbs->setSpacing(6);
    verbs->addWidget(m_state, 1);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_session, m_start, m_stopAfter, m_stopNow})
        verbs->addWidget(widget);
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(8, 4, 8, 4);
    column->setSpacing(4);
    column->addWidget(m_edits);
    column->addWidget(m_tree, 1);
    column->addLayout(verbs);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scrolled(inside)); // in a small window its buttons have no room beside each other
}

void RecipePanel::show(const RecipeView& view) {
    const bool hasMoved = view.isOn() && (view.step != m_view.step || !m_view.isOn());
    m_view = view;
    const int before = m_tree->topLevelItemCount(), rows = static_cast<int>(view.recipe.steps.size());
    if (rows != before) {
        const int row = current();
        m_tree->clear();
        for (int i = 0; i < rows; ++i)
            new QTreeWidgetItem(m_tree);
        choose(rows == before + 1 ? before : std::min(std::max(row, 0), rows - 1));
    }
    if (hasMoved) // what is looked at in Review then is its run
        choose(static_cast<int>(view.step));
    showRows();
    showState();
    showButtons();
}

void RecipePanel::showRows() {
    for (int row = 0; row < m_tree->topLevelItemCount(); ++row) {
        const auto i = static_cast<std::size_t>(row);
        const RecipeStep& step = m_view.recipe.steps[i];
        const RecipeProgress progress = i < m_view.progress.size() ? m_view.progress[i] : RecipeProgress();
        QTreeWidgetItem* item = m_tree->topLevelItem(row);
        const QString condition = conditionWords(step, m_unit);
        QString state = stateWord(progress.state);
        if (progress.reason.code != MessageCode::None)
            state += QStringLiteral(": ") + messageText(progress.reason, m_unit);
        const auto set = [&](int column, const QString& text) {
            if (item->text(column) != text)
                item->setText(column, text);
        };
        set(kNumber, QString::number(row + 1));
        set(kStep, step.isRun() ? tr("Run %1").arg(stepWords(step)) : stepWords(step));
        set(kUntil, step.goesOn ? tr("%1; otherwise on with the next").arg(condition) : condition);
        set(kMaxDuration, maxDurationWords(step));
        set(kElapsed, progress.state == RecipeProgress::State::Waiting ? QString()
                                                                       : formatDuration(progress.elapsed_s));
        set(kState, state);
        item->setToolTip(kStep, QString::fromStdString(step.experiment));
        item->setToolTip(kUntil, item->text(kUntil));
        item->setToolTip(kState, state);
        const bool dark = isDark(this);
        if (const int shown = 2 * static_cast<int>(progress.state) + (dark ? 1 : 0);
            item->data(kState, Qt::UserRole) != shown) {
            QIcon icon(statePixmap(progress.state, dark, kIcon, devicePixelRatioF()));
            icon.addPixmap(statePixmap(progress.state, true, kIcon, devicePixelRatioF()), QIcon::Selected);
            item->setIcon(kState, icon);
            item->setData(kState, Qt::UserRole, shown);
        }
        for (const int column : {kNumber, kMaxDuration, kElapsed})
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
}

void RecipePanel::showState() {
    using Phase = RecipeRunner::Phase;
    QString text;
    if (m_view.isOn()) {
        const QString step = tr("Step %1 of %2").arg(m_view.step + 1).arg(m_view.recipe.steps.size());
        const QString at = tr("%1 of at most %2")
                               .arg(formatDuration(m_view.progress[m_view.step].elapsed_s),
                                    maxDurationWords(m_view.recipe.steps[m_view.step]));
        const QString doing = m_view.phase == Phase::Run    ? tr("running, %1").arg(at)
                              : m_view.phase == Phase::Wait ? tr("waiting, %1").arg(at)
                              : m_view.phase == Phase::Stop ? tr("heat off, retreat")
                                                            : tr("getting ready");
        text = tr("%1: %2").arg(step, doing);
    } else if (m_view.end != RecipeEnd::None) {
        text = endWords(m_view.end);
    } else if (m_view.recipe.steps.empty()) {
        text = tr("Experiments that are run one after another, with waits. Add a step or open a recipe.");
    } else {
        text = tr("%n step(s), at most %1", nullptr, static_cast<int>(m_view.recipe.steps.size()))
                   .arg(formatDuration(maxDuration_s(m_view.recipe)));
    }
    if (!m_view.isOn() && !m_view.recipe.steps.empty()) {
        QString file = m_view.file.isEmpty() ? tr("not saved yet") : m_view.file;
        if (m_view.isModified && !m_view.file.isEmpty())
            file = tr("%1, changed").arg(file);
        text = QStringLiteral("%1 (%2)").arg(text, file);
    }
    if (m_state->text() != text)
        m_state->setText(text);
}

void RecipePanel::showButtons() {
    const bool isOn = m_view.isOn();
    const int row = current(), rows = m_tree->topLevelItemCount();
    m_file->setEnabled(!isOn);
    m_save->setEnabled(!isOn && m_view.isModified);
    m_saveAs->setEnabled(rows > 0);
    m_add->setEnabled(!isOn && rows < static_cast<int>(kMaxRecipeSteps));
    m_edit->setEnabled(!isOn && row >= 0);
    m_remove->setEnabled(!isOn && row >= 0);
    m_up->setEnabled(!isOn && row > 0);
    m_down->setEnabled(!isOn && row >= 0 && row + 1 < rows);
    const bool hasRun = std::ranges::any_of(m_view.recipe.steps, &RecipeStep::isRun);
    m_start->setEnabled(!isOn && m_isStartable && hasRun);
    // What cannot be pressed gives its place to the list.
    m_edits->setVisible(!isOn);
    m_start->setVisible(!isOn);
    m_stopAfter->setVisible(isOn);
    m_stopNow->setVisible(isOn);
    m_stopAfter->setChecked(isOn && m_view.stopsAfterStep);
    const auto i = static_cast<std::size_t>(row);
    m_session->setEnabled(row >= 0 && i < m_view.progress.size() && !m_view.progress[i].recording.empty() &&
                          !(isOn && i == m_view.step));
}

int RecipePanel::current() const {
    return m_tree->indexOfTopLevelItem(m_tree->currentItem());
}

void RecipePanel::choose(int row) {
    m_tree->setCurrentItem(m_tree->topLevelItem(row));
}

/// After the one that is chosen, once its form is accepted.
void RecipePanel::add(const RecipeStep& step) {
    ask(step, [this](const RecipeStep& wanted) {
        Recipe changed = m_view.recipe;
        const int row = current() + 1;
        changed.steps.insert(changed.steps.begin() + row, wanted);
        emit edited(changed);
        choose(row);
    });
}

void RecipePanel::editCurrent() {
    const int row = current();
    if (row < 0)
        return;
    ask(m_view.recipe.steps[static_cast<std::size_t>(row)], [this, row](const RecipeStep& wanted) {
        Recipe changed = m_view.recipe;
        if (row >= static_cast<int>(changed.steps.size()))
            return;
        changed.steps[static_cast<std::size_t>(row)] = wanted;
        if (changed != m_view.recipe)
            emit edited(changed);
    });
}

/// Nothing changes before the form is accepted, nor if the recipe was started meanwhile.
void RecipePanel::ask(const RecipeStep& step, std::function<void(const RecipeStep&)> take) {
    if (m_view.isOn())
        return;
    auto* dialog = new RecipeStepDialog(step, m_objects, m_unit, this);
    connect(dialog, &QDialog::accepted, this, [this, dialog, take = std::move(take)] {
        if (!m_view.isOn())
            take(dialog->step());
    });
    dialog->open();
}

void RecipePanel::move(int by) {
    const int row = current();
    Recipe changed = m_view.recipe;
    std::swap(changed.steps.at(static_cast<std::size_t>(row)),
              changed.steps.at(static_cast<std::size_t>(row + by)));
    emit edited(changed);
    choose(row + by);
}

void RecipePanel::removeCurrent() {
    Recipe changed = m_view.recipe;
    changed.steps.erase(changed.steps.begin() + current());
    emit edited(changed);
}

void RecipePanel::setExamples(const QStringList& names) {
    m_exampleMenu->clear();
    for (const QString& name : names)
        connect(m_exampleMenu->addAction(name), &QAction::triggered, this,
                [this, name] { emit exampleRequested(name); });
}

void RecipePanel::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    showRows();
}

void RecipePanel::setStartable(bool isStartable) {
    m_isStartable = isStartable;
    showButtons();
}

void RecipePanel::retranslate() {
    m_file->setText(tr("File"));
    m_new->setText(tr("New recipe"));
    m_open->setText(tr("Open a recipe…"));
    m_exampleMenu->setTitle(tr("Examples"));
    m_saveAs->setText(tr("Save the recipe as…"));
    m_save->setText(tr("Save"));
    m_add->setText(tr("Add"));
    m_addCurrent->setText(tr("A run of the open experiment"));
    m_addFile->setText(tr("A run of an experiment from a file…"));
    m_addWait->setText(tr("A wait"));
    m_addCondition->setText(tr("A wait until an object has cooled"));
    m_edit->setText(tr("Edit…"));
    m_remove->setText(tr("Remove"));
    m_start->setText(tr("Start the recipe"));
    m_stopAfter->setText(tr("Stop after this step"));
    m_stopNow->setText(tr("Stop the recipe"));
    m_session->setText(tr("Look at the run"));
    const auto say = [](QWidget* widget, const QString& name, const QString& meaning) {
        widget->setAccessibleName(name);
        widget->setToolTip(meaning);
    };
    say(m_file, tr("Recipe file"), tr("A new recipe, another one, or this one under another name"));
    say(m_save, tr("Save the recipe"), tr("Save the recipe"));
    say(m_add, tr("Add a step"), tr("Add a step after the chosen one"));
    say(m_edit, tr("Edit the step"),
        tr("Its condition, its longest time, and what comes if that passes (Enter)"));
    say(m_remove, tr("Remove the step"), tr("Remove the step"));
    say(m_up, tr("Move the step up"), tr("Move the step up"));
    say(m_down, tr("Move the step down"), tr("Move the step down"));
    say(m_start, tr("Start the recipe"), tr("Says what it will do, and asks"));
    say(m_stopAfter, tr("Stop after this step"), tr("The step under way is the last one"));
    say(m_stopNow, tr("Stop the recipe"), tr("Heat off, retreat, and nothing more is begun"));
    say(m_session, tr("Look at the run"), tr("The recording of the chosen step, on the Review page"));
    m_tree->setAccessibleName(tr("Steps of the recipe"));
    m_tree->setHeaderLabels({tr("No."), tr("Step"), tr("Until"), tr("At most"), tr("Elapsed"), tr("State")});
    showRows();
    showState();
}

void RecipePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        showRows();
}

} // namespace bask
