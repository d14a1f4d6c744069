// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/answertime.h"
#include "families/abstractdc/questionwatch.h"
#include "transport/caninbox.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <vector>

namespace mb::abstractdc {

/// Identifiers of speed logs that answer a question for the speed and no other, and how often each was asked for and answered:
/// two answers to one question are two drives with one offset (README.md#offsets).
class Census {
public:
    Census(CanLink &link, const QuestionWatch &questions)
        : m_questions(questions)
        , m_traffic(link.traffic().add([this](const Traffic &traffic) {
            if (traffic.can)
                pass(*traffic.can);
        }))
    {
    }
    [[nodiscard]] const std::set<std::uint32_t> &velocityIds() const { return m_velocity; }
    /// Questions to one drive for its temperature, and answers. Two drives tell hardly the same, unlike their speed at rest.
    struct Balance {
        int asked = 0;
        int answered = 0;
    };
    [[nodiscard]] const Balance &temperatures(int offset) const
    {
        return m_temperatures.at(static_cast<std::size_t>(offset));
    }
    /// Answers to questions for the speed beyond one each.
    [[nodiscard]] bool isTwice(std::uint32_t answer, int offset) const
    {
        const int asked = m_broadcasts + m_asked.at(static_cast<std::size_t>(offset));
        return std::ranges::count(m_answers, answer) > asked + 1; // one question may be older than we are
    }

private:
    void pass(const CanFrame &frame)
    {
        if (frame.extended || frame.remote || frame.error)
            return;
        countTemperature(frame);
        const auto code = static_cast<std::uint8_t>(dialectF.codeOf(Log::Velocity));
        const bool request = frame.size == 1 && frame.data[0] == code;
        if (request && frame.id == id::logRequest) {
            ++m_broadcasts;
        } else if (request && frame.id > id::logRequest && frame.id <= id::logRequest + maxOffset) {
            ++m_asked.at(frame.id - id::logRequest);
        } else if (frame.size == 4 && frame.id >= id::velocityLogLegacy && frame.id <= id::velocityLog + maxOffset
            && m_questions.answersOnly(code)) {
            m_velocity.insert(frame.id);
            m_answers.push_back(frame.id);
        }
    }

    void countTemperature(const CanFrame &frame)
    {
        const bool request = frame.size == 1 && frame.data[0] == dialectF.codeOf(Log::Temperature);
        const std::uint32_t base = request ? id::logRequest : id::temperatureLog;
        if ((!request && frame.size != 4) || frame.id < base || frame.id > base + maxOffset)
            return;
        Balance &own = m_temperatures.at(frame.id - base);
        ++(request ? own.asked : own.answered);
        for (std::size_t i = 1; request && frame.id == id::logRequest && i < m_temperatures.size(); ++i)
            ++m_temperatures.at(i).asked; // everybody was
    }

    const QuestionWatch &m_questions;
    std::array<Balance, maxOffset + 1> m_temperatures{};
    std::set<std::uint32_t> m_velocity;
    std::vector<std::uint32_t> m_answers;
    int m_broadcasts = 0;
    std::array<int, maxOffset + 1> m_asked{};
    Subscription m_traffic;
};

/// A question, and where its answer may come.
struct Probe {
    Question question;
    std::vector<std::uint32_t> answers;
};

class Prober {
public:
    Prober(CanLink &link, Clock &clock, const QuestionWatch &questions)
        : m_link(link)
        , m_clock(clock)
        , m_questions(questions)
    {
    }

    /// The identifier that the answer came on; nothing when no answer came to any try. Only answers that cannot be somebody
    /// else's count.
    Task<std::optional<std::uint32_t>> ask(Probe probe, int most = 3);

private:
    CanLink &m_link;
    Clock &m_clock;
    const QuestionWatch &m_questions;
};

struct Found {
    int offset = 0;
    const Dialect *dialect = nullptr;
};

/// Which drive sends its speed log on `answer`, and its dialect (nullptr: not proven); nothing when not even the offset is sure.
[[nodiscard]] Task<std::optional<Found>> identifyDrive(Prober &prober, std::uint32_t answer);
/// Drives older than the broadcast, asked one by one: their offsets. Of all, or of 0 and those that are `expected`.
[[nodiscard]] Task<std::vector<int>> findOldest(CanLink &link, Clock &clock, std::optional<std::set<int>> expected);

[[nodiscard]] inline std::uint32_t at(std::uint32_t base, int offset)
{
    return base + static_cast<std::uint32_t>(offset);
}

} // namespace mb::abstractdc
