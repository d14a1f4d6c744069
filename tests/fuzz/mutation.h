// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace mb::test {

/// Changes texts at random, the same way in every run.
class Mutation {
public:
    Mutation(std::uint32_t seed, std::vector<std::string> words)
        : m_random(seed)
        , m_words(std::move(words))
    {
    }

    /// 0…bound-1; 0 when the bound is 0.
    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : m_random() % bound; }

    /// One to four changes.
    std::string operator()(std::string text)
    {
        for (std::size_t i = below(4) + 1; i > 0; --i)
            change(text);
        return text;
    }

private:
    char anyByte() { return static_cast<char>(below(256)); }

    void change(std::string &text)
    {
        const std::size_t at = below(text.size() + 1);
        const std::size_t length = below(12);
        switch (below(8)) {
        case 0:
            if (at < text.size())
                text[at] = anyByte();
            break;
        case 1:
            if (at < text.size())
                text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
            break;
        case 2: text.insert(at, 1, anyByte()); break;
        case 3: text.erase(at, length); break;
        case 4: text.resize(at); break;
        case 5: text.insert(at, m_words[below(m_words.size())]); break;
        case 6: text.insert(below(text.size() + 1), text.substr(at, length * 4)); break;
        default:
            if (at < text.size())
                text[at] = "0123456789ABCDEF"[below(16)];
        }
    }

    std::mt19937 m_random;
    std::vector<std::string> m_words;
};

} // namespace mb::test
