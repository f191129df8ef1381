#include "app/edit_history.h"

#include <utility>

namespace bask {

void EditHistory::clear(bool saved) {
    m_steps.clear();
    m_done = 0;
    m_saved = saved ? std::optional<std::size_t>(0) : std::nullopt;
    m_last.reset();
}

bool EditHistory::continues(const EditStep& step, Time now) const {
    return m_done > 0 && m_last && now - *m_last < kSameStep && mayBeOneOfMany(step.edit.kind) &&
           m_steps[m_done - 1].edit == step.edit;
}

void EditHistory::add(EditStep step, Time now) {
    const bool isSameStep = continues(step, now);
    m_steps.resize(m_done); // what was undone is gone
    if (m_saved && *m_saved > m_done)
        m_saved.reset();
    m_last = now;
    if (isSameStep) {
        m_steps.back().after = std::move(step.after);
        if (*m_steps.back().after == *m_steps.back().before) {
            m_steps.pop_back();
            --m_done;
            m_last.reset();
        }
        return;
    }
    m_steps.push_back(std::move(step));
    ++m_done;
    if (m_steps.size() <= kMaxSteps)
        return;
    m_steps.erase(m_steps.begin());
    --m_done;
    if (m_saved)
        m_saved = *m_saved > 0 ? std::optional(*m_saved - 1) : std::nullopt;
}

void EditHistory::undo() {
    --m_done;
    m_last.reset();
}

void EditHistory::redo() {
    ++m_done;
    m_last.reset();
}

void EditHistory::setSaved() {
    m_saved = m_done;
    m_last.reset();
}

} // namespace bask
