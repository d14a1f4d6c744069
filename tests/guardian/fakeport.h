// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/runner.h"

#include <functional>
#include <string>

namespace mb::guardian::test {

inline Bytes bytes(const std::string &text)
{
    return {text.begin(), text.end()};
}

/// A line that logs what is sent, as text, with its time, and answers as the test says.
class FakePort final : public Port {
public:
    struct Sending {
        std::string text;
        Time at{};
        friend bool operator==(const Sending &, const Sending &) = default;
    };

    Sent send(std::span<const std::uint8_t> message) override
    {
        if (state != Sent::All)
            return state;
        sent.push_back({{message.begin(), message.end()}, now});
        if (answer)
            incoming += answer(sent.back().text);
        return Sent::All;
    }
    Bytes read() override
    {
        Bytes all = bytes(incoming);
        incoming.clear();
        return all;
    }
    [[nodiscard]] std::string texts() const
    {
        std::string all;
        for (const Sending &one : sent)
            all += one.text;
        return all;
    }

    Time now{};
    Sent state = Sent::All;
    std::string incoming;
    std::vector<Sending> sent;
    std::function<std::string(const std::string &)> answer; ///< what comes back at once
};

} // namespace mb::guardian::test
