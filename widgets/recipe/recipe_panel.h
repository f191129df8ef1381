#pragma once
// A recipe as a list of steps with their results: edited, started and stopped here.

#include "engine/base/units.h"
#include "engine/recipe/recipe_runner.h"

#include <QStringList>
#include <QWidget>

#include <functional>
#include <vector>

class QAction;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;
class QTreeWidget;

namespace bask {

/// What the panel shows besides the steps.
struct RecipeView {
    Recipe recipe;
    QString file; ///< its name; empty if it has no file yet
    bool isModified = false;
    std::vector<RecipeProgress> progress; ///< empty if it was never started
    std::size_t step = 0;                 ///< current step
    RecipeRunner::Phase phase = RecipeRunner::Phase::Over;
    RecipeEnd end = RecipeEnd::None;
    bool stopsAfterStep = false;
    bool isOn() const { return phase != RecipeRunner::Phase::Over; }
};

/// Passive: the caller keeps the recipe and answers signals with show(). Object names: "recipePanel",
/// "recipeTree", "recipeState", and those of the buttons as below.
class RecipePanel : public QWidget {
    Q_OBJECT

public:
    explicit RecipePanel(QWidget* parent = nullptr);

    void show(const RecipeView& view);
    void setExamples(const QStringList& names);
    /// Sets the names of objects that a step's form offers.
    void setObjects(const QStringList& names) { m_objects = names; }
    void setTemperatureUnit(TemperatureUnit unit);
    void setStartable(bool isStartable); ///< whether a recipe can be started: no run is on

signals:
    void edited(const bask::Recipe& recipe);
    void newRequested();
    void openRequested();
    void exampleRequested(const QString& name);
    void saveRequested();
    void saveAsRequested();
    void addCurrentRequested(); ///< add the open experiment
    void addFileRequested();
    void startRequested();
    void stopAfterStepRequested(bool isWanted);
    void stopNowRequested();
    void sessionRequested(const QString& path);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QPushButton* makeButton(const char* name);
    int current() const;
    void choose(int row);
    void add(const RecipeStep& step);
    void editCurrent();
    void ask(const RecipeStep& step, std::function<void(const RecipeStep&)> take);
    void move(int by);
    void removeCurrent();
    void showRows();
    void showState();
    void showButtons();
    void retranslate();

    RecipeView m_view;
    QStringList m_objects;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isStartable = true;
    QWidget* m_edits; ///< the row of buttons that is hidden while a recipe is on
    QTreeWidget* m_tree;
    QLabel* m_state;
    QMenu *m_openMenu, *m_exampleMenu, *m_addMenu;
    QAction *m_new, *m_open, *m_saveAs, *m_addCurrent, *m_addFile, *m_addWait, *m_addCondition;
    QPushButton *m_file, *m_save, *m_add, *m_edit, *m_remove, *m_start, *m_stopAfter, *m_stopNow, *m_session;
    QToolButton *m_up, *m_down;
};

} // namespace bask
