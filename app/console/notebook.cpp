// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"

#include "app/folders/userfolders.h"
#include "model/family.h"
#include "tuning/gains.h"
#include "tuning/verdict.h"

namespace mb::console {

/// The book, and the number it gave last.
class Notebook::Numbered final : public tuning::ExperimentJournal {
public:
    Numbered(Database &database, const Clock &clock)
        : m_book(database, clock)
    {
    }
    [[nodiscard]] TrialBook &book() { return m_book; }
    [[nodiscard]] Task<std::int64_t> begin(tuning::Trial trial) override
    {
        auto beginning = m_book.begin(std::move(trial));
        const std::int64_t begun = co_await std::move(beginning);
        number = begun;
        co_return begun;
    }
    [[nodiscard]] Task<void> owe(std::int64_t trial, std::string unit, std::vector<tuning::OwedValue> values) override
    {
        return m_book.owe(trial, std::move(unit), std::move(values));
    }
    [[nodiscard]] Task<void> settle(std::int64_t trial) override { return m_book.settle(trial); }
    [[nodiscard]] Task<void> complete(std::int64_t trial, tuning::Trial done) override
    {
        return m_book.complete(trial, std::move(done));
    }

    std::optional<std::int64_t> number;

private:
    TrialBook m_book;
};

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
    m_book = std::make_shared<Numbered>(*m_database, console.clock());
}

tuning::ExperimentJournal *Notebook::book()
{
    return m_book.get();
}

std::optional<std::int64_t> Notebook::number() const
{
    return m_book ? m_book->number : std::nullopt;
}

namespace {

/// The unit has every value that is owed to it.
Task<bool> has(Device &device, std::vector<tuning::OwedValue> values)
{
    auto reading = tuning::readReplaced(device, tuning::changesOf(device.family(), values));
    const auto present = co_await std::move(reading).attempt();
    co_return present &&*present == values;
}

} // namespace

Task<void> Notebook::lookForDebts(Device &device)
{
    if (!m_book)
        co_return {};
    const auto debts = m_book->book().debts(tuning::unitOf(device));
    if (!debts)
        co_return {};
    for (const Debt &debt : *debts) {
        auto looking = has(device, debt.values);
        if (co_await std::move(looking)) {
            auto settling = m_book->settle(debt.trial);
            (void)co_await std::move(settling).attempt();
            continue;
        }
        std::string values;
        for (const tuning::OwedValue &value : debt.values) {
            if (const auto index = findParameter(device.family().parameters, value.key))
                values += ' ' + value.key + '=' + toText(device.family().parameters[index->value], value.raw);
        }
        m_console.note("trial " + std::to_string(debt.trial) + " did not put back what it changed; 'motorbenchctl set "
            + device.selector() + values + "' does");
    }
    co_return {};
}

} // namespace mb::console
