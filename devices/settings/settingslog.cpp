// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settingslog.h"

#include <QtGlobal>

#include <array>

namespace mb::settings {
namespace {

/// In the order of the enumerators; the texts stand in databases.
constexpr std::array<std::string_view, 6> occasions{"hand", "found", "restore", "import", "tuning", "update"};
constexpr std::array<std::string_view, 6> names{QT_TRANSLATE_NOOP("table", "by hand"),
    QT_TRANSLATE_NOOP("table", "as found"), QT_TRANSLATE_NOOP("table", "before restore"),
    QT_TRANSLATE_NOOP("table", "before import"), QT_TRANSLATE_NOOP("table", "before tuning"),
    QT_TRANSLATE_NOOP("table", "before update")};
constexpr std::array<std::string_view, 5> origins{"window", "console", "tune", "recipe", "elsewhere"};
constexpr std::array<std::string_view, 8> purposes{
    "write", "restore", "undo", "redo", "revert", "provisional", "keep", "store"};
constexpr std::array<std::string_view, 5> proofs{"open", "equal", "blind", "differs", "refused"};

template <class E, std::size_t N> std::string_view textOf(const std::array<std::string_view, N> &texts, E value)
{
    return texts.at(static_cast<std::size_t>(value));
}

/// The first enumerator where the text is foreign.
template <class E, std::size_t N> E fromText(const std::array<std::string_view, N> &texts, std::string_view text)
{
    for (std::size_t i = 0; i < N; ++i) {
        if (texts[i] == text)
            return static_cast<E>(i);
    }
    return static_cast<E>(0);
}

} // namespace

std::string_view toString(Occasion occasion)
{
    return textOf(occasions, occasion);
}

Occasion occasionFromString(std::string_view text)
{
    return fromText<Occasion>(occasions, text);
}

std::string_view usualName(Occasion occasion)
{
    return textOf(names, occasion);
}

std::string_view toString(Origin origin)
{
    return textOf(origins, origin);
}

Origin originFromString(std::string_view text)
{
    return fromText<Origin>(origins, text);
}

std::string_view toString(Purpose purpose)
{
    return textOf(purposes, purpose);
}

Purpose purposeFromString(std::string_view text)
{
    return fromText<Purpose>(purposes, text);
}

std::string_view toString(Proof proof)
{
    return textOf(proofs, proof);
}

Proof proofFromString(std::string_view text)
{
    return fromText<Proof>(proofs, text);
}

} // namespace mb::settings
