#pragma once
// The edits of the experiment that can be undone and redone, and at which of them it was saved.

#include "app/experiment_edit.h"

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace bask {

struct EditStep {
    ExperimentEdit edit;
    std::shared_ptr<const Experiment> before, after; ///< shared by neighbours
};

/// Edits of the same thing in quick succession are one step: a dragged slider, a key kept pressed.
class EditHistory {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds kSameStep{1000};
    static constexpr std::size_t kMaxSteps = 200;

    /// Removes all edits. `saved`: the experiment in its present state is in its file.
    void clear(bool saved);
    void add(EditStep step, Time now);

    /// The edit to undo or to redo; null if there is none.
    const EditStep* toUndo() const { return m_done > 0 ? &m_steps[m_done - 1] : nullptr; }
    const EditStep* toRedo() const { return m_done < m_steps.size() ? &m_steps[m_done] : nullptr; }
    /// Only if there is one.
    void undo();
    void redo();

    void setSaved();
    bool isSaved() const { return m_saved == m_done; }

private:
    bool continues(const EditStep& step, Time now) const;

    std::vector<EditStep> m_steps;
    std::size_t m_done = 0; ///< number of steps that are not undone
    /// value of m_done when it was saved; empty if none of these states was saved
    std::optional<std::size_t> m_saved = 0;
    std::optional<Time> m_last; ///< time of the newest edit; empty if the next edit starts a new step
};

} // namespace bask
