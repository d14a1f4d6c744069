// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "model/identity.h"
#include "wire/canframe.h"

#include <array>
#include <optional>
#include <vector>

namespace mb::abstractdc {

/// For Family::recogniser: drives in the traffic of others. An answer alone does not tell whose it is (1024 … 1123 are today's
/// speeds and legacy positions); a question with the identifier of its answer does, as in a scan.
class Recognition {
public:
    /// Every frame of a recording, in their order. Who has answered with this one; the dialect is empty until a question was asked that not all dialects answer alike.
    [[nodiscard]] std::optional<Identity> take(const CanFrame &frame);

private:
    struct Question {
        std::uint32_t base = 0; ///< of its identifier: another one asks the oldest dialect
        int offset = 0;
        int code = 0;
        Instant time{};
    };
    struct Explanation {
        int offset = 0;
        const Dialect *dialect = nullptr;
    };
    void ask(const CanFrame &frame);
    [[nodiscard]] std::vector<Explanation> explain(const CanFrame &answer) const;
    [[nodiscard]] Identity identityOf(int offset, const Dialect *dialect);

    std::vector<Question> m_asked; ///< in the last second
    std::array<const Dialect *, maxOffset + 1> m_proven{};
};

} // namespace mb::abstractdc
