// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"
#include "async/result.h"

#include <QByteArray>

#include <map>
#include <optional>
#include <string>

namespace mb {

/// On which line each key of a JSON object stands: "test.limits.duty" to its line, counted from 1; a place in a list is its number
/// from 0 ("accept.rise.1"). Where a text stops to be JSON, its keys end.
struct JsonLines {
    std::map<std::string, int> lines;
    std::string repeated; ///< path of a key that is there twice; empty: none is

    /// Of the key, or else of the nearest object around it; 1 for the whole.
    [[nodiscard]] int of(std::string path) const;
    /// OutOfRange with its line: a key is there twice. To be asked before QJsonDocument reads the text, which takes the last of them
    /// and, in Qt 5.15, keeps the memory of the others.
    [[nodiscard]] Result<void> checkKeys() const;
};

[[nodiscard]] JsonLines linesOf(const QByteArray &text);
/// The line of a place in a text, counted from 1.
[[nodiscard]] int lineAt(const QByteArray &text, int offset);
/// "line 7: unknown key 'nmae'": how every mistake of a recipe is told.
[[nodiscard]] Message atLine(int line, const Message &mistake);
/// The line that atLine() has put before a mistake, also where more stands before that; nothing: it has none.
[[nodiscard]] std::optional<int> lineOf(const Message &mistake);

} // namespace mb
