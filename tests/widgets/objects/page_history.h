#pragma once
// What a window does for the Objects page: takes every edit, undoes and redoes them.

#include "widgets/objects/objects_page.h"

#include <QAction>

#include <vector>

namespace bask::test {

class PageHistory : public QObject {
public:
    explicit PageHistory(ObjectsPage& page) : m_page(page) {
        page.setUndoActions(&undo, &redo);
        connect(&page, &ObjectsPage::experimentEdited, this, [this](const Experiment& experiment) {
            m_states.resize(m_now + 1);
            m_states.push_back(experiment);
            ++m_now;
            refresh();
        });
        connect(&undo, &QAction::triggered, this, [this] { go(m_now - 1); });
        connect(&redo, &QAction::triggered, this, [this] { go(m_now + 1); });
    }
    /// What the page has now is the beginning.
    void begin() {
        m_states = {m_page.experiment()};
        m_now = 0;
        refresh();
    }

    QAction undo, redo;

private:
    void go(std::size_t state) {
        m_now = state;
        refresh();
        m_page.setExperiment(m_states[m_now]);
    }
    void refresh() {
        undo.setEnabled(m_now > 0);
        redo.setEnabled(m_now + 1 < m_states.size());
    }

    ObjectsPage& m_page;
    std::vector<Experiment> m_states;
    std::size_t m_now = 0;
};

} // namespace bask::test
