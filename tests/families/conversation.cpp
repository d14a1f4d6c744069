// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/conversation.h"

#include "support/sourcetree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace mb::test {
namespace {

constexpr std::size_t around = 3;

std::vector<std::string> linesOf(const std::string &path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

std::string lineOf(const std::vector<std::string> &lines, std::size_t at)
{
    return at < lines.size() ? lines[at] : "(nothing)";
}

/// The first line that differs, with those before and behind it.
std::string difference(
    const std::string &name, const std::vector<std::string> &stored, const std::vector<std::string> &got)
{
    const std::size_t most = std::max(stored.size(), got.size());
    std::size_t at = 0;
    while (at < most && lineOf(stored, at) == lineOf(got, at))
        ++at;
    std::ostringstream text;
    text << name << ':' << at + 1 << '\n';
    for (std::size_t i = at - std::min(at, around); i < at; ++i)
        text << "           " << stored[i] << '\n';
    for (std::size_t i = at; i < std::min(at + 1 + around, most); ++i)
        text << " expected: " << lineOf(stored, i) << "\n      got: " << lineOf(got, i) << '\n';
    return text.str();
}

} // namespace

void Conversation::Digest::take(std::string_view text)
{
    for (const char c : text)
        value = (value ^ static_cast<std::uint8_t>(c)) * 0x100000001B3U;
    value = (value ^ std::uint64_t{'\n'}) * 0x100000001B3U;
}

std::string Conversation::Digest::text() const
{
    std::array<char, 20> hex{};
    std::snprintf(hex.data(), hex.size(), "%016llx", static_cast<unsigned long long>(value));
    return hex.data();
}

void Conversation::tell(std::string line)
{
    writeSum();
    m_shown.clear();
    m_whole += line + '\n';
    write(std::move(line));
}

void Conversation::event(const std::string &kind, const std::string &line)
{
    ++m_events;
    m_whole += line + '\n';
    if (!m_summing && ++m_shown[kind] <= shownOfAKind) {
        write(line);
        return;
    }
    ++m_counts[kind];
    m_sumDigest.take(line);
}

void Conversation::beginSum()
{
    writeSum();
    m_summing = true;
}

void Conversation::endSum()
{
    writeSum();
    m_summing = false;
}

void Conversation::write(std::string line)
{
    m_digest.take(line);
    m_lines.push_back(std::move(line));
}

void Conversation::writeSum()
{
    if (m_counts.empty())
        return;
    std::string line = "  in sum:";
    for (const auto &[kind, count] : m_counts)
        line += ' ' + std::to_string(count) + " × " + kind + ',';
    write(line + " digest " + m_sumDigest.text());
    m_counts.clear();
    m_sumDigest = {};
}

std::string Conversation::summary() const
{
    Digest all = m_digest;
    all.take(m_sumDigest.text());
    return std::to_string(m_events) + " events, digest " + all.text();
}

void Conversation::include(std::string_view title, const Conversation &other)
{
    m_whole += std::string(title) + '\n' + other.m_whole;
}

void Conversation::expectAsStored(const std::string &name)
{
    writeSum();
    if (const char *folder = std::getenv("MOTORBENCH_WHOLE_CONVERSATIONS"))
        std::ofstream(std::string(folder) + '/' + name + ".txt") << m_whole;
    const std::string path = inSourceTree("tests/families/conversations/" + name + ".txt");
    if (std::getenv("MOTORBENCH_WRITE_CONVERSATIONS") != nullptr) {
        std::ofstream file(path);
        for (const std::string &line : m_lines)
            file << line << '\n';
        ASSERT_TRUE(file.flush()) << path;
        return;
    }
    const std::vector<std::string> stored = linesOf(path);
    if (stored != m_lines)
        ADD_FAILURE() << difference("tests/families/conversations/" + name + ".txt", stored, m_lines);
}

} // namespace mb::test
