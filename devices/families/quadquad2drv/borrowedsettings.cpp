// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/borrowedsettings.h"

#include <utility>

namespace mb::quadquad2drv {

BorrowedSettings::BorrowedSettings(Controller &board, int axis, Part part, std::optional<History> history)
    : m_board(board)
    , m_loan{axis, part, history, {}, board.resets()}
{
    const auto borrow = [this](ParameterIndex index) {
        const DeviceProfile &profile = m_board.knowledge().profile();
        const std::string key(m_board.parameters().parameter(index).key);
        const auto written = profile.written.find(key);
        Setting setting{index, m_board.parameters().entry(index).raw,
            written != profile.written.end() && !profile.lost.contains(key)};
        if (setting.isHeld && !setting.raw)
            setting.raw = written->second; // not read yet
        m_loan.settings.push_back(setting);
        m_board.knowledge().doubt(index);
    };
    const auto first = part == Part::Axis ? AxisParameter::PositionP : AxisParameter::InputMode;
    const auto last = part == Part::Axis ? AxisParameter::LimitAcceleration : AxisParameter::InputPosition;
    for (auto i = indexOf(axis, first).value; i <= indexOf(axis, last).value; ++i)
        borrow({i});
    if (history) {
        borrow(indexOf(BoardParameter::HistoryLength));
        borrow(indexOf(BoardParameter::HistoryTimeBits));
    }
}

BorrowedSettings::~BorrowedSettings()
{
    if (!m_given)
        m_board.putBack(restore(m_board, std::move(m_loan)));
}

Task<void> BorrowedSettings::giveBack()
{
    co_await restore(m_board, m_loan);
    m_given = true;
    co_return {};
}

Task<void> BorrowedSettings::restore(Controller &board, Loan loan)
{
    if (loan.resets != board.resets())
        co_return {};
    SettingRequests &requests = board.settings();
    const auto forget = [&] {
        for (const Setting &setting : loan.settings)
            board.parameters().forget(setting.index, ParameterState::Unknown);
    };
    forget();
    for (const Setting &setting : loan.settings) {
        if (setting.raw)
            board.parameters().setWritten(setting.index, *setting.raw);
    }
    std::vector<Bytes> orders
        = loan.part == Part::Axis ? requests.ofAxis(loan.axis) : std::vector<Bytes>{requests.input(loan.axis)};
    if (loan.history)
        orders.push_back(setHistory(
            static_cast<std::uint8_t>(loan.history->length), static_cast<std::uint8_t>(loan.history->timeBits)));
    for (const Bytes &order : orders) {
        Result<void> told = co_await board.tell(order).attempt();
        if (told && loan.resets != board.resets())
            co_return {};
        if (!told) {
            forget();
            co_return fail(told.error());
        }
    }
    for (const Setting &setting : loan.settings) {
        if (setting.isHeld)
            board.knowledge().assume(setting.index, *setting.raw);
        requests.accepted(setting.index);
    }
    co_return {};
}

} // namespace mb::quadquad2drv
