#include "widgets/review/replay.h"

#include <algorithm>

namespace bask {

void Replay::setSpan(double begin_s, double end_s) {
    m_isPlaying = false;
    m_begin_s = begin_s;
    m_end_s = std::max(begin_s, end_s);
    m_from_s = m_begin_s;
}

double Replay::position_s() const {
    if (!m_isPlaying)
        return m_from_s;
    return std::clamp(m_from_s + m_speed * (m_clock.now_s() - m_since_s), m_begin_s, m_end_s);
}

bool Replay::isPlaying() const {
    return m_isPlaying && position_s() < m_end_s;
}

void Replay::play() {
    const double position = position_s();
    m_from_s = position < m_end_s ? position : m_begin_s;
    m_since_s = m_clock.now_s();
    m_isPlaying = true;
}

void Replay::pause() {
    m_from_s = position_s();
    m_isPlaying = false;
}

void Replay::seek(double time_s) {
    m_from_s = std::clamp(time_s, m_begin_s, m_end_s);
    m_since_s = m_clock.now_s();
}

void Replay::setSpeed(double factor) {
    m_from_s = position_s();
    m_since_s = m_clock.now_s();
    m_speed = std::clamp(factor, kSlowest, kFastest);
}

} // namespace bask
