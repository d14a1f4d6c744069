// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// A literal of a test as text: `QStringLiteral` without its length.
inline QString s(const char *text)
{
    return QString::fromUtf8(text);
}
