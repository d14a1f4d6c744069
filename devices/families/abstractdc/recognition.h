// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/questionbook.h"
#include "model/identity.h"

#include <array>
#include <optional>

namespace mb::abstractdc {

/// For Family::recogniser: drives in the traffic of others. An answer alone does not tell whose it is (1024 … 1123 are today's
/// speeds and legacy positions); a question with the identifier of its answer does, as in a scan.
class Recognition {
public:
    /// Every frame of a recording, in their order. Who has answered with this one; the dialect is empty until a question was asked that not all dialects answer alike.
    [[nodiscard]] std::optional<Identity> take(const CanFrame &frame);

private:
    [[nodiscard]] Identity identityOf(int offset, const Dialect *dialect);

    QuestionBook m_book; ///< none is closed by its answer: two drives may have been asked the same
    std::array<const Dialect *, maxOffset + 1> m_proven{};
};

} // namespace mb::abstractdc
