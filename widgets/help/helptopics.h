// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>
#include <vector>

namespace mb {

/// A page of the documentation that the program carries.
struct HelpTopic {
    QString key; ///< "hardware/dmc60c"
    QString title;
};

/// In the order in which they are listed.
[[nodiscard]] std::vector<HelpTopic> helpTopics();
/// The page about a family's hardware; empty when there is none.
[[nodiscard]] QString hardwareTopic(std::string_view family);

} // namespace mb
