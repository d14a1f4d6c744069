// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mb::test {

/// What happened in a story, line by line, and the stored text that it must be equal to (docs/testing.md#golden-conversations).
class Conversation {
public:
    /// A line that is always written: a heading, a result.
    void tell(std::string line);
    /// An event. The first of a kind behind a heading or a result are lines of their own; those after them are summed up in one line,
    /// with how many of each kind there were and a digest of all that they said.
    void event(const std::string &kind, const std::string &line);
    /// From here on every event is summed up …
    void beginSum();
    /// … up to here.
    void endSum();
    /// "34 events, digest 0123456789abcdef" of everything so far.
    [[nodiscard]] std::string summary() const;

    [[nodiscard]] const std::vector<std::string> &lines() const { return m_lines; }
    /// Events that were summed up, too.
    [[nodiscard]] const std::string &whole() const { return m_whole; }
    /// What another one said, as part of this one's whole.
    void include(std::string_view title, const Conversation &other);

    /// Compares with conversations/NAME.txt, or writes it when MOTORBENCH_WRITE_CONVERSATIONS is set. Into the folder
    /// MOTORBENCH_WHOLE_CONVERSATIONS, if there is one, goes everything with what was summed up.
    void expectAsStored(const std::string &name);

private:
    static constexpr int shownOfAKind = 4;

    struct Digest {
        std::uint64_t value = 0xCBF29CE484222325U; // FNV-1a
        void take(std::string_view text);
        [[nodiscard]] std::string text() const;
    };
    void write(std::string line);
    void writeSum();

    std::vector<std::string> m_lines;
    std::string m_whole;
    Digest m_digest;
    std::uint64_t m_events = 0;
    bool m_summing = false;
    Digest m_sumDigest;
    std::map<std::string, int> m_shown;
    std::map<std::string, int> m_counts; ///< not shown
};

} // namespace mb::test
