#pragma once
// The edits of the experiment that can be undone and redone, and where among them it was saved.

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

/// Edits of one thing, each shortly after the one before, are one step: a slider dragged, a key held.
class EditHistory {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds kSameStep{1000};
    static constexpr std::size_t kMaxSteps = 200;

    /// Empty again. `saved`: as the experiment is now, it is in its file.
    void clear(bool saved);
    void add(EditStep step, Time now);

    /// Null: nothing to undo, to redo.
    const EditStep* toUndo() const { return m_done > 0 ? &m_steps[m_done - 1] : nullptr; }
    const EditStep* toRedo() const { return m_done < m_steps.size() ? &m_steps[m_done] : nullptr; }
    /// Only where there is one.
    void undo();
    void redo();

    void setSaved();
    bool isSaved() const { return m_saved == m_done; }

private:
    bool continues(const EditStep& step, Time now) const;

    std::vector<EditStep> m_steps;
    std::size_t m_done = 0;                 ///< steps that are not undone
    std::optional<std::size_t> m_saved = 0; ///< as many were done then; empty: none of these states
    std::optional<Time> m_last;             ///< of the newest edit; empty: the next one is a step of its own
};

} // namespace bask
