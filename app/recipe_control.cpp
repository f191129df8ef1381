#include "app/recipe_control.h"

#include "app/actions.h"
#include "app/error_text.h"
#include "app/examples.h"
#include "engine/base/message_code.h"
#include "engine/model/limits_widened.h"
#include "widgets/common/display.h"
#include "widgets/common/message_bar.h"
#include "widgets/recipe/recipe_panel.h"
#include "widgets/recipe/recipe_words.h"
#include "widgets/rig/way_up_question.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace bask {
namespace {

constexpr std::size_t kMaxShown = 12; ///< steps in the question
const QString kRecipeQuestion = QStringLiteral("recipeQuestion");

const RecipeStep& of(const RecipeRunner& runner) {
    return runner.recipe().steps[runner.step()];
}

} // namespace

RecipeControl::RecipeControl(Document& document, SessionActions& files, RecipePanel& panel, MessageBar& bar,
                             QWidget* window)
    : QObject(window), m_document(document), m_files(files), m_panel(panel), m_bar(bar), m_window(window) {
    connect(&m_bar, &MessageBar::actionClicked, this, &RecipeControl::showWanted);
    m_panel.setExamples(exampleRecipeNames());
    connect(&m_panel, &RecipePanel::edited, this, &RecipeControl::edit);
    connect(&m_panel, &RecipePanel::newRequested, this, [this] {
        if (mayDiscard())
            become({}, {});
    });
    connect(&m_panel, &RecipePanel::openRequested, this, [this] {
        const QString path = m_files.ask({FileQuestion::Kind::OpenFile,
                                          tr("Open a recipe"),
                                          m_files.lastFolder(FileFolder::Experiments),
                                          tr("Recipes (*.json);;All files (*)"),
                                          {}});
        if (!path.isEmpty())
            open(path);
    });
    connect(&m_panel, &RecipePanel::exampleRequested, this, &RecipeControl::openExample);
    connect(&m_panel, &RecipePanel::saveRequested, this, &RecipeControl::save);
    connect(&m_panel, &RecipePanel::saveAsRequested, this, &RecipeControl::saveAs);
    connect(&m_panel, &RecipePanel::addCurrentRequested, this, &RecipeControl::addCurrent);
    connect(&m_panel, &RecipePanel::addFileRequested, this, &RecipeControl::addFile);
    connect(&m_panel, &RecipePanel::startRequested, this, &RecipeControl::start);
    connect(&m_panel, &RecipePanel::sessionRequested, &m_files, &SessionActions::open);
    connect(&m_panel, &RecipePanel::stopAfterStepRequested, this, [this](bool isWanted) {
        if (m_runner)
            m_runner->setStopAfterStep(isWanted);
        showPanel();
    });
    connect(&m_panel, &RecipePanel::stopNowRequested, this, &RecipeControl::stopNow);
    connect(&m_document, &Document::changed, this, [this] {
        QStringList names;
        for (const ObjectSpec& object : m_document.experiment().objects)
            names << QString::fromStdString(object.name);
        m_panel.setObjects(names);
    });
    showPanel();
}

void RecipeControl::become(const Recipe& recipe, const QString& path) {
    m_recipe = recipe;
    m_path = path;
    m_isModified = false;
    m_runner.reset();
    showPanel();
}

void RecipeControl::edit(const Recipe& recipe) {
    if (isOn())
        return;
    m_recipe = recipe;
    m_isModified = true;
    m_runner.reset();
    showPanel();
}

void RecipeControl::open(const QString& path) {
    if (isOn())
        return emit problem(tr("A recipe is on. Stop it before another one is opened."));
    if (!mayDiscard())
        return;
    const auto read = readRecipe(path.toStdString());
    if (!read)
        return emit problem(sentence(read.error()));
    become(*read, path);
    m_files.remember(path);
    emit showWanted();
}

void RecipeControl::openExample(const QString& name) {
    if (!mayDiscard())
        return;
    if (const auto read = readExampleRecipe(name))
        become(*read, {});
    else
        emit problem(sentence(read.error()));
}

bool RecipeControl::mayDiscard() {
    if (!m_isModified || m_recipe.steps.empty())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved recipe"), tr("The recipe was changed and not saved."),
                    QMessageBox::NoButton, m_window);
    box.setObjectName(QStringLiteral("unsavedRecipeQuestion"));
    QPushButton* saving = box.addButton(tr("Save"), QMessageBox::AcceptRole);
    QPushButton* discarding = box.addButton(tr("Discard changes"), QMessageBox::DestructiveRole);
    QPushButton* staying = box.addButton(tr("Cancel"), QMessageBox::RejectRole);
    box.setDefaultButton(saving);
    box.setEscapeButton(staying);
    box.exec();
    return box.clickedButton() == saving ? save() : box.clickedButton() == discarding;
}

bool RecipeControl::save() {
    return m_path.isEmpty() ? saveAs() : write(m_path);
}

bool RecipeControl::saveAs() {
    const QString proposed =
        m_path.isEmpty()
            ? QDir(m_files.lastFolder(FileFolder::Experiments)).filePath(QStringLiteral("recipe.json"))
            : m_path;
    const QString path = m_files.ask({FileQuestion::Kind::SaveFile, tr("Save the recipe"), proposed,
                                      tr("Recipes (*.json)"), QStringLiteral("json")});
    return !path.isEmpty() && write(path);
}

bool RecipeControl::write(const QString& path) {
    if (const auto written = writeRecipe(m_recipe, path.toStdString()); !written) {
        emit problem(sentence(written.error()));
        return false;
    }
    m_path = path;
    m_isModified = false;
    m_files.remember(path);
    showPanel();
    emit told(tr("Saved %1").arg(QFileInfo(path).fileName()));
    return true;
}

void RecipeControl::addCurrent() {
    // A step names a file: what is run is what stands there.
    if ((m_document.path().isEmpty() || m_document.modified()) && !m_files.save())
        return;
    Recipe changed = m_recipe;
    changed.steps.emplace_back().experiment = m_document.path().toStdString();
    edit(changed);
}

void RecipeControl::addFile() {
    const QString path = m_files.ask({FileQuestion::Kind::OpenFile,
                                      tr("Add a run of an experiment"),
                                      m_files.lastFolder(FileFolder::Experiments),
                                      tr("Experiments (*.json);;All files (*)"),
                                      {}});
    if (path.isEmpty())
        return;
    Recipe changed = m_recipe;
    changed.steps.emplace_back().experiment = QFileInfo(path).absoluteFilePath().toStdString();
    edit(changed);
}

void RecipeControl::start() {
    if (isOn() || m_files.refusedByRun())
        return;
    const auto example = [](const std::string& name) { return readExample(QString::fromStdString(name)); };
    m_read.run([recipe = m_recipe, example] { return readExperiments(recipe, example); },
               [this, recipe = m_recipe](Result<RecipeExperiments> read) {
                   if (!read)
                       return emit problem(sentence(read.error()));
                   if (recipe == m_recipe)
                       ask(std::move(*read));
               });
}

/// What it will do, all of it, before the first motion. STOP can be pressed meanwhile.
void RecipeControl::ask(RecipeExperiments experiments) {
    const auto& rig = m_document.experiment().rig;
    for (std::size_t i = 0; i < experiments.size(); ++i)
        if (experiments[i]->rig != rig)
            return emit problem(
                tr("Step %1 is for another rig than the present one: a recipe runs on one rig, which "
                   "has been looked at.")
                    .arg(i + 1));
    if (hasManualSource(rig))
        return emit problem(
            tr("The source is heated by hand: a recipe cannot switch it off between its steps."));
    if (isOn() || m_files.refusedByRun() || !m_files.mayDiscard())
        return;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(m_recipe.steps.size(), kMaxShown); ++i) {
        const RecipeStep& step = m_recipe.steps[i];
        const QString until = conditionWords(step, m_files.temperatureUnit());
        lines << (step.until == RecipeStep::Until::Time
                      ? tr("%1. %2 until %3").arg(i + 1).arg(stepWords(step), until)
                      : tr("%1. %2 until %3, at most %4")
                            .arg(i + 1)
                            .arg(stepWords(step), until, maxDurationWords(step)));
    }
    if (m_recipe.steps.size() > kMaxShown)
        lines << tr("and %n more", nullptr, static_cast<int>(m_recipe.steps.size() - kMaxShown));
    QStringList limits; // of all its steps, each told once
    for (const auto& experiment : experiments)
        for (const Message& limit :
             widenedOnRealRig(m_document.experiment(), *experiment, m_document.realRobot()))
            if (const QString words = sentence(limit); !limits.contains(words))
                limits << words;
    if (!limits.isEmpty())
        lines << QString() << tr("Its steps allow the real rig more than now:") << limits
              << tr("Do robot, source, objects and sensors bear it?");
    dropQuestion(m_window, kRecipeQuestion);
    auto* box = new QMessageBox(
        rig ? QMessageBox::Warning : QMessageBox::Question, tr("Start the recipe"),
        tr("It takes at most %1 and its retreats:").arg(formatDuration(maxDuration_s(m_recipe))) + u'\n' +
            lines.join(u'\n'),
        QMessageBox::NoButton, m_window);
    box->setInformativeText(
        rig ? tr("This rig is real: the robot moves and the source heats, again and again and by itself. Is "
                 "everybody and everything out of the way for so long? An alarm, a hold or a stop ends the "
                 "recipe.")
            : tr("An alarm, a hold or a stop ends the recipe."));
    box->setObjectName(kRecipeQuestion);
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* go = box->addButton(tr("Start"), QMessageBox::AcceptRole);
    QPushButton* stay = box->addButton(tr("Cancel"), QMessageBox::RejectRole);
    go->setObjectName(QStringLiteral("recipeGo"));
    box->setDefaultButton(stay);
    box->setEscapeButton(stay);
    connect(go, &QPushButton::clicked, this,
            [this, asked = m_recipe, open = m_document.experiment(), experiments = std::move(experiments)] {
                if (asked != m_recipe || open != m_document.experiment())
                    return emit problem(tr("Something was changed meanwhile: start the recipe once more."));
                begin(experiments);
            });
    box->setModal(false);
    box->show();
}

void RecipeControl::begin(RecipeExperiments experiments) {
    if (isOn() || !m_isStartable || m_files.refusedByRun())
        return;
    m_runner.emplace(m_recipe, std::move(experiments), [this](std::size_t) -> Result<std::string> {
        const QString path = m_files.nextRecordingPath();
        if (path.isEmpty())
            return Error(MessageCode::FileUnwritable, {},
                         {SessionActions::tr("the folder cannot be made").toStdString()});
        return path.toStdString();
    });
    post(m_runner->begin(m_last));
    showPanel();
}

void RecipeControl::post(const std::vector<Command>& commands) {
    for (const Command& command : commands)
        if (const auto* load = std::get_if<LoadExperiment>(&command))
            m_document.open(load->experiment, QString::fromStdString(of(*m_runner).experiment));
        else
            emit commandIssued(command);
}

void RecipeControl::apply(const Snapshot& snapshot) {
    m_last = snapshot;
    m_isStartable = allowsEdits(snapshot.state) && snapshot.state != RunState::Fault;
    m_panel.setStartable(m_isStartable);
    if (!m_isStartable)
        dropQuestion(m_window, kRecipeQuestion);
    if (!isOn())
        return;
    m_runner->setKeepsExperiment(m_document.modified());
    post(m_runner->take(snapshot));
    showPanel();
    tellEnd();
}

void RecipeControl::stopNow() {
    if (m_runner)
        post(m_runner->stopNow());
    showPanel();
}

void RecipeControl::takeOver(bool isHold) {
    dropQuestion(m_window, kRecipeQuestion);
    if (!isOn())
        return;
    m_runner->takeOver(isHold);
    showPanel();
    tellEnd();
}

void RecipeControl::takeOverAtRest() {
    if (isOn() &&
        (m_runner->phase() == RecipeRunner::Phase::Load || m_runner->phase() == RecipeRunner::Phase::Wait))
        takeOver();
}

void RecipeControl::tellEnd() {
    if (m_runner->isOver()) {
        const bool isDone = m_runner->end() == RecipeEnd::Done;
        QString text = endWords(m_runner->end());
        if (m_runner->reason().code != MessageCode::None)
            text += u' ' + sentenceText(m_runner->reason());
        else if (m_runner->progress()[m_runner->step()].state == RecipeProgress::State::Paused)
            text += u' ' + tr("Its run is held, not ended: nothing but a person resumes or stops it now.");
        else if (m_document.modified())
            text += u' ' + tr("The experiment has unsaved edits.");
        isDone ? emit told(text) : emit problem(text);
    }
}

void RecipeControl::showPanel() {
    RecipeView view;
    view.recipe = m_recipe;
    view.file = QFileInfo(m_path).fileName();
    view.isModified = m_isModified;
    if (m_runner) {
        view.progress = m_runner->progress();
        view.step = m_runner->step();
        view.phase = m_runner->phase();
        view.end = m_runner->end();
        view.stopsAfterStep = m_runner->stopsAfterStep();
    }
    m_panel.show(view);
    showBar();
}

void RecipeControl::showBar() {
    if (!isOn())
        return m_bar.clear();
    const QString text = tr("A recipe is on, step %1 of %2. It arms, moves and heats by itself.")
                             .arg(m_runner->step() + 1)
                             .arg(m_recipe.steps.size());
    if (m_bar.sentence() != text)
        m_bar.say(MessageBar::Kind::Note, text, tr("Show the recipe"), false);
}

} // namespace bask
