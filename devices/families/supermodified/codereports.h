// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"

#include <map>

namespace mb::supermodified {

/// The error codes that one node has reported since it was opened, in place of answers. Engine thread.
class CodeReports {
public:
    /// True where the code says that the bridge is off.
    bool take(std::uint8_t code);
    /// The motor was started: what switched it off before is over.
    void started();
    /// All that a node may report, in the order of codeNames(), and last, as code_7f, those that it has reported and that have no name: those of D3 are not known.
    [[nodiscard]] std::vector<FaultRecord> records() const;
    /// Liveness::faults.
    [[nodiscard]] std::vector<std::string> active() const;
    void clear() { m_codes.clear(); }

private:
    struct Reported {
        std::int64_t count = 0;
        bool active = false;
    };
    std::map<std::uint8_t, Reported> m_codes;
};

} // namespace mb::supermodified
