// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"

#include <QString>

#include <string_view>

namespace mb {

/// A label, help or word of a table of the library, in the language of the program.
[[nodiscard]] QString tableText(std::string_view english);
/// A sentence of the library in the language of the program; its numbers as everywhere in the window (numberformat.h).
[[nodiscard]] QString messageText(const Message &message);
/// The same with numbers for a file.
[[nodiscard]] QString messageText(const Message &message, QChar decimal);
/// "4.2 %", with the decimal sign of the language.
[[nodiscard]] QString quantityText(const MessageNumber &quantity);

} // namespace mb
