// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"

#include "app/folders/userfolders.h"
#include "tuning/owedgains.h"

#include <unistd.h>

#include <iostream>

namespace mb::console {
namespace {

/// Yes only from somebody who sits at a terminal and says so.
bool isAgreedTo(const std::string &question)
{
    if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDERR_FILENO) != 1)
        return false;
    std::cerr << question << " [y/N] " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes";
}

} // namespace

Notebook::Notebook(Console &console)
    : m_console(console)
{
    auto opened = Database::open(databaseFile());
    if (!opened) {
        console.note("trials are not kept: " + opened.error().detail);
        return;
    }
    m_database = std::move(*opened);
    if (!m_database->remark().empty())
        complain(m_database->remark());
    m_book = std::make_unique<TrialBook>(*m_database, console.clock());
}

Task<void> Notebook::settleOwed(Device &device, bool agreed)
{
    if (!m_book)
        co_return {};
    auto looking = tuning::lookForOwed(device, *m_book);
    const auto owed = co_await std::move(looking).attempt();
    if (!owed)
        co_return {};
    for (const tuning::OwedGains &debt : *owed) {
        const std::string what = "trial " + std::to_string(debt.trial) + " did not put back what it changed";
        const std::string values = tuning::assignmentsOf(device.family(), debt.values);
        if (!agreed && !isAgreedTo(what + "; put " + values + " back now?")) {
            m_console.note(what + "; --yes does, or 'motorbenchctl set " + device.selector() + ' ' + values + '\'');
            continue;
        }
        auto paying = tuning::payOwed(device, *m_book, debt);
        co_await std::move(paying);
        m_console.note(values + " is put back, owed by trial " + std::to_string(debt.trial));
    }
    co_return {};
}

} // namespace mb::console
