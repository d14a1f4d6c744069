// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace mb {

/// The three functions of an expression that remember: fed with a time in seconds and a value, they yield theirs.
class MovingValue {
public:
    enum class Kind { Derivative, Integral, Average };

    MovingValue(Kind kind, double seconds)
        : m_kind(kind)
        , m_seconds(seconds)
    {
    }
    [[nodiscard]] double feed(double time, double value)
    {
        if (!std::isfinite(value)) {
            restart();
            return std::numeric_limits<double>::quiet_NaN();
        }
        switch (m_kind) {
        case Kind::Derivative: return derivative(time, value);
        case Kind::Integral: return integral(time, value);
        case Kind::Average: return average(time, value);
        }
        return value;
    }
    void restart()
    {
        m_has = false;
        m_sum = 0.0;
        m_window.clear();
    }

private:
    double derivative(double time, double value)
    {
        const double span = time - m_time;
        if (m_has && span <= 0.0)
            return m_result;
        m_result = m_has ? (value - m_value) / span : std::numeric_limits<double>::quiet_NaN();
        remember(time, value);
        return m_result;
    }
    double integral(double time, double value)
    {
        if (m_has)
            m_sum += (time - m_time) * (value + m_value) / 2.0;
        remember(time, value);
        return m_sum;
    }
    double average(double time, double value)
    {
        m_window.emplace_back(time, value);
        m_sum += value;
        while (m_window.front().first <= time - m_seconds) {
            m_sum -= m_window.front().second;
            m_window.pop_front();
        }
        if (++m_fed % 4096 == 0) { // what rounding left behind
            m_sum = 0.0;
            for (const auto &sample : m_window)
                m_sum += sample.second;
        }
        return m_sum / static_cast<double>(m_window.size());
    }
    void remember(double time, double value)
    {
        m_has = true;
        m_time = time;
        m_value = value;
    }

    Kind m_kind;
    double m_seconds;
    bool m_has = false;
    double m_time = 0.0;
    double m_value = 0.0;
    double m_sum = 0.0;
    double m_result = std::numeric_limits<double>::quiet_NaN();
    unsigned m_fed = 0;
    std::deque<std::pair<double, double>> m_window;
};

} // namespace mb
