// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wire/canframe.h"

#include <QString>

#include <optional>

namespace mb {

/// What a typed frame is: one or the other.
struct TypedFrame {
    std::optional<CanFrame> frame;
    QString problem; ///< what is wrong and what would be right
};
/// Reads identifier (hexadecimal, `0x` allowed) and bytes ("81 25 11", blanks as you like). A whole line of candump in the
/// first field, `02061405#8125`, is understood too; its digits then tell the format.
[[nodiscard]] TypedFrame readTypedFrame(const QString &id, bool extended, const QString &data);

} // namespace mb
