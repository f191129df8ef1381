#pragma once
// The recipe of the window: its file, its edits, and its execution by the engine.

#include "app/session_actions.h"
#include "engine/recipe/recipe_runner.h"
#include "engine/runtime/command.h"
#include "widgets/common/latest_job.h"

#include <QObject>

#include <optional>

namespace bask {

class MessageBar;
class RecipePanel;

/// Each run's experiment is opened in the document, so that the pages show it. Object name of its question:
/// "recipeQuestion".
class RecipeControl : public QObject {
    Q_OBJECT

public:
    /// `bar` shows on every page that a recipe is on: between its steps the engine is idle.
    RecipeControl(Document& document, SessionActions& files, RecipePanel& panel, MessageBar& bar,
                  QWidget* window);

    void open(const QString& path);
    /// Asks if unsaved edits of the recipe would be lost. Returns false to stay.
    bool mayDiscard();
    void apply(const Snapshot& snapshot);
    /// Call before a person stops or holds the rig.
    void takeOver(bool isHold = false);
    /// Ends the recipe and its run, as requested.
    void stopNow();
    /// Call before a person moves or heats the rig manually, which is refused during a run.
    void takeOverAtRest();
    bool isOn() const { return m_runner && !m_runner->isOver(); }

signals:
    void commandIssued(const bask::Command& command);
    void problem(const QString& sentence);
    void told(const QString& sentence);
    /// The panel must be shown.
    void showWanted();

private:
    void become(const Recipe& recipe, const QString& path);
    void edit(const Recipe& recipe);
    void openExample(const QString& name);
    bool save();
    bool saveAs();
    bool write(const QString& path);
    void addCurrent();
    void addFile();
    void start();
    void ask(RecipeExperiments experiments);
    void begin(RecipeExperiments experiments);
    void post(const std::vector<Command>& commands);
    void showPanel();
    void showBar();
    void tellEnd();

    Document& m_document;
    SessionActions& m_files;
    RecipePanel& m_panel;
    MessageBar& m_bar;
    QWidget* m_window;
    Recipe m_recipe;
    QString m_path;
    bool m_isModified = false;
    std::optional<RecipeRunner> m_runner; ///< runs the present recipe; an edit resets it
    Snapshot m_last;
    bool m_isStartable = false; ///< no run is armed or on, and no fault is latched
    LatestJob<Result<RecipeExperiments>> m_read;
};

} // namespace bask
