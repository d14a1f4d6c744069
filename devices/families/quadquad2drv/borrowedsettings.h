// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/quadquad2drv/controller.h"

namespace mb::quadquad2drv {

/// Settings of an axis (0…3) that an experiment changes. They are in doubt while it does, so that a program that dies leaves them
/// lost, to be written again; and given back however it ends, but not to a board that was reset meanwhile. Engine thread.
class BorrowedSettings : NonCopyable {
public:
    enum class Part { Input, Axis };
    /// The board outlives it. `history` is what the board has, for those who change that too.
    BorrowedSettings(Controller &board, int axis, Part part, std::optional<History> history = {});
    /// Gives back, whoever waits for it or not.
    ~BorrowedSettings();

    [[nodiscard]] Task<void> giveBack();

private:
    struct Setting {
        ParameterIndex index;
        std::optional<std::int64_t> raw; ///< as it was known
        bool isHeld = false;             ///< written, and not lost
    };
    struct Loan {
        int axis = 0;
        Part part = Part::Axis;
        std::optional<History> history;
        std::vector<Setting> settings;
        std::uint64_t resets = 0; ///< of the board, so far
    };
    [[nodiscard]] static Task<void> restore(Controller &board, Loan loan);

    Controller &m_board;
    Loan m_loan;
    bool m_given = false;
};

} // namespace mb::quadquad2drv
