#pragma once
// Whether a robot comes nearer to where it was sent.

namespace bask {

class Approach {
public:
    void begin(double now_s);
    /// Takes what is left of the way, m or rad.
    void add(double now_s, double left, double period_s);
    /// It has not come nearer for so long that it will not.
    bool isStill() const { return m_isStill; }

private:
    double m_nearer_s = 0.0, m_left = 0.0;
    bool m_isStill = false;
};

} // namespace bask
