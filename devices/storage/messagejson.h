// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"

#include <QJsonValue>
#include <QString>

namespace mb {

/// A sentence as the user's file keeps it, so that it is read back in whatever language the window has then: its literal and
/// what stands in it. Text that is nobody's to translate, and what older versions wrote, is a plain string.
[[nodiscard]] QJsonValue toJson(const Message &message);
[[nodiscard]] Message messageFrom(const QJsonValue &value);
/// For fields of that type (files/jsonfields.h).
inline bool fromJson(const QJsonValue &value, Message &message)
{
    message = messageFrom(value);
    return value.isString() || value.isObject();
}

/// The same in a column of text.
[[nodiscard]] QString savedText(const Message &message);
[[nodiscard]] Message messageFrom(const std::string &saved);

} // namespace mb
