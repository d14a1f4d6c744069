// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"

#include "app/console/progressline.h"
#include "app/console/question.h"
#include "app/folders/account.h"
#include "app/folders/userfolders.h"
#include "experiment/owedgains.h"
#include "files/qttext.h"
#include "model/unit.h"
#include "settings/snapshots.h"
#include "settings/storing.h"

#include <QFile>

#include <algorithm>

namespace mb::console {
Result<std::unique_ptr<Database>> openNotebook()
{
    auto opened = Database::open(databaseFile());
    if (!opened)
        return fail(asUsage(opened.error()));
    if (!(*opened)->remark().empty())
        complain((*opened)->remark());
    return opened;
}

namespace {

std::string causeOf(const tuning::OwedGains &debt)
{
    const std::string caveat(unitCaveatOf(unitByOf(debt.unit)));
    return "trial " + std::to_string(debt.trial) + " did not put back what it changed"
        + (caveat.empty() ? "" : " (" + caveat + ")");
}

/// Of a unit that stores by itself a while after a write, where there is one.
void beginHistory(Console &console, const Device &device, std::optional<Notebook> &notebook)
{
    if (device.family().capabilities.storesAfter > std::chrono::seconds(0) && QFile::exists(qt(databaseFile())))
        notebook.emplace(console);
}

} // namespace

Task<std::vector<TransferOutcome>> readKept(Console &console, Device &device, std::vector<ParameterIndex> indices)
{
    std::optional<Notebook> notebook;
    beginHistory(console, device, notebook);
    if (notebook && notebook->trouble())
        console.note("what was written a moment ago may be called stored before it is: " + notebook->trouble()->text());
    ProgressLine progress(console);
    auto reading = settings::readKept(device, std::move(indices), notebook ? notebook->settings() : nullptr, progress);
    co_return co_await std::move(reading);
}

Task<void> keepStored(Console &console, const Device &device)
{
    std::optional<Notebook> notebook;
    beginHistory(console, device, notebook);
    if (!notebook || !notebook->settings())
        co_return {};
    (void)co_await settings::keepStored(device, settings::Origin::Console, *notebook->settings()).attempt();
    co_return {};
}

Task<std::vector<std::string>> owedLines(Console &console, Device &device)
{
    const bool isAsked = !device.link().address().isRecording() && device.identity().state == DeviceState::Online;
    if (!isAsked || !QFile::exists(qt(databaseFile())))
        co_return std::vector<std::string>();
    Notebook notebook(console);
    co_return co_await notebook.owedLines(device);
}

Task<void> noteOwed(Console &console, Device &device)
{
    const std::vector<std::string> owed = co_await owedLines(console, device);
    for (const std::string &line : owed)
        console.note(line);
    co_return {};
}

UnitNames::UnitNames(Console &console)
    : m_console(console)
{
}

UnitNames::~UnitNames() = default;

std::string UnitNames::of(const Device &device)
{
    const bool isTagged = device.identity().name.empty() && !device.family().capabilities.rename
        && unitByOf(unitKeyOf(device)) == UnitBy::Place && !device.link().address().isRecording();
    if (!isTagged || (!m_notebook && !QFile::exists(qt(databaseFile()))))
        return device.identity().name;
    if (!m_notebook) {
        m_notebook = std::make_unique<Notebook>(m_console);
        if (m_notebook->trouble())
            m_console.note("names that are kept on this computer are not shown: " + m_notebook->trouble()->text());
    }
    SettingsBook *const book = m_notebook->settings();
    return book ? std::string(unitTagIn(book->resolved(unitKeyOf(device)))) : std::string();
}

Notebook::Notebook(Console &console)
    : m_console(console)
{
    auto opened = openNotebook();
    if (!opened) {
        m_trouble = opened.error();
        return;
    }
    m_database = std::move(*opened);
    m_book = std::make_unique<TrialBook>(*m_database, console.clock());
    m_settings = std::make_unique<SettingsBook>(*m_database, console.clock(), accountName());
}

void Notebook::noteTrouble() const
{
    if (m_trouble)
        m_console.note("nothing is kept of this: " + m_trouble->text());
}

Task<void> Notebook::keepBefore(Device &device, settings::Occasion occasion)
{
    if (!m_settings || device.identity().state == DeviceState::Bootloader)
        co_return {};
    ProgressLine progress(m_console);
    auto taking = settings::takeSnapshot(device, occasion, {}, *m_settings, progress);
    const auto taken = co_await std::move(taking).attempt();
    if (taken)
        m_console.note("snapshot " + std::to_string(taken->number) + ", " + taken->name + ", has "
            + std::to_string(taken->count) + " values of " + device.selector());
    else if (taken.error().fault == Fault::NotKept)
        co_return fail(asUsage(settings::keepsNothing(taken.error())));
    else // it is the unit that does not tell: an update may be what mends it
        m_console.note("no snapshot of what was there: " + taken.error().text());
    co_return {};
}

Task<void> Notebook::keepOrRefuse(Device &device, settings::Occasion occasion)
{
    m_console.onlyAsk();
    if (m_trouble && device.identity().state != DeviceState::Bootloader) // one in its bootloader has nothing to keep
        co_return fail(asUsage(settings::keepsNothing(*m_trouble)));
    noteTrouble();
    co_await keepBefore(device, occasion);
    m_console.begin();
    co_return {};
}

Task<void> Notebook::keepReplaced(Device &device, settings::Numbers before, settings::Origin origin)
{
    if (!m_settings || before.empty())
        co_return {};
    auto noting = settings::keepReplaced(device, std::move(before), origin, *m_settings);
    if (const auto noted = co_await std::move(noting).attempt(); !noted)
        m_console.note("the history does not have this write: " + noted.error().text());
    co_return {};
}

double Notebook::lagOf(const Device &device, int axis) const
{
    const auto kept = m_book ? m_book->tuningsOf(unitKeyOf(device)) : Result<std::vector<KeptTuning>>();
    if (!kept)
        return 0.0;
    const auto newest = std::ranges::find_if(kept->rbegin(), kept->rend(), [axis](const KeptTuning &tuning) {
        return tuning.report.axis == axis && tuning.report.loop != Mode::Current && tuning.report.plant.tau > 0.0;
    });
    return newest == kept->rend() ? 0.0 : newest->report.plant.tau;
}

Task<std::vector<tuning::OwedGains>> Notebook::owedTo(Device &device, bool mayWait)
{
    if (!m_book)
        co_return std::vector<tuning::OwedGains>();
    auto all = co_await m_book->owedTo(unitKeyOf(device)).attempt();
    if (!all)
        co_return std::vector<tuning::OwedGains>();
    for (const tuning::OwedGains &debt : *all) {
        if (debt.isUnderWay)
            m_console.note("another program is making trial " + std::to_string(debt.trial)
                + " with this unit, and puts back what it changed: "
                + tuning::assignmentsOf(device.family(), debt.values));
    }
    const auto owed = co_await tuning::stillOwed(device, *m_book, std::move(*all), mayWait).attempt();
    co_return owed.value_or(std::vector<tuning::OwedGains>());
}

Task<std::vector<std::string>> Notebook::owedLines(Device &device, std::vector<ParameterChange> written)
{
    const std::vector<tuning::OwedGains> owed = co_await owedTo(device, false);
    std::vector<std::string> lines;
    for (const tuning::OwedGains &debt : owed) {
        const bool isReplaced = std::ranges::all_of(debt.values, [&](const auto &value) {
            return std::ranges::any_of(written, [&](const ParameterChange &change) {
                return device.parameters().parameter(change.index).key == value.key;
            });
        });
        if (!isReplaced)
            lines.push_back(causeOf(debt) + "; 'motorbenchctl set " + device.selector() + ' '
                + tuning::assignmentsOf(device.family(), debt.values) + "' does");
    }
    co_return lines;
}

Task<void> Notebook::settleOwed(Device &device, bool agreed)
{
    const std::vector<tuning::OwedGains> owed = co_await owedTo(device, true);
    for (const tuning::OwedGains &debt : owed) {
        const std::string what = causeOf(debt);
        const std::string values = tuning::assignmentsOf(device.family(), debt.values);
        bool puts = agreed;
        if (!puts) {
            auto asking = isAgreedTo(m_console, what + "; put " + values + " back now?");
            puts = co_await std::move(asking);
        }
        if (!puts) {
            m_console.note(what + "; --yes does, or 'motorbenchctl set " + device.selector() + ' ' + values + '\'');
            continue;
        }
        co_await tuning::payOwed(device, *m_book, debt);
        m_console.note(values + " is put back, owed by trial " + std::to_string(debt.trial));
    }
    co_return {};
}

} // namespace mb::console
