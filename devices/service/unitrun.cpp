// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/unitrun.h"

#include "async/sleep.h"
#include "model/heardsince.h"
#include "model/unit.h"
#include "service/busydevice.h"
#include "service/goldenband.h"
#include "service/preflight.h"
#include "settings/snapshots.h"
#include "settings/storing.h"
#include "settings/writing.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace mb::service {
namespace {

using namespace std::chrono_literals;

constexpr Duration numberAgain = 2s;
constexpr Duration lookForUnit = 100ms;
constexpr int mostTests = 3;

/// Nobody can tell its unit from another in the same place.
bool isPlace(const Visit &visit)
{
    return unitByOf(visit.unit) == UnitBy::Place;
}

bool isLost(const TestFinding &finding)
{
    return finding.failure && finding.failure->fault == Fault::LinkLost;
}

Message settingsText(int count)
{
    return count == 1 ? say("1 setting") : say("%1 settings", count);
}

} // namespace

Outcome outcomeOfRefusal(const Visit &visit)
{
    const auto writes = [](const StepEntry &entry) { return entry.step > Step::Backup; };
    return std::ranges::any_of(visit.steps, writes) ? Outcome::Failed : Outcome::Refused;
}

UnitRun::UnitRun(
    Device &device, SetPointStream &stream, Visit visit, ServiceSurroundings surroundings, Progress &progress)
    : m_device(device)
    , m_stream(stream)
    , m_visit(std::move(visit))
    , m_around(std::move(surroundings))
    , m_progress(progress)
    , m_begun(device.clock().now())
    , m_earlier(m_visit.seconds)
    , m_trusted(isPlace(m_visit) ? m_visit.steps.size() : 0)
{
    if (m_trusted > 0) { // it may be another unit than the one that was cut off here
        m_visit.from.clear();
        m_visit.to.clear();
        m_visit.unproved = false;
        m_visit.snapshot.reset();
        m_visit.trial.reset();
        m_visit.test.clear();
    }
    m_around.experiments.start = &m_start;
    m_visit.imageHash = m_around.matter.imageHash;
    if (m_visit.from.empty() && !isEnded(Step::Firmware))
        m_visit.from = device.identity().firmware;
}

Task<void> UnitRun::serve()
{
    const Recipe &recipe = m_around.matter.recipe;
    struct Entry {
        Step step;
        Work work;
        bool wanted;
    };
    const std::array<Entry, 7> order{{
        {Step::Preflight, &UnitRun::look, true},
        {Step::Backup, &UnitRun::backUp, !isEnded(Step::Backup)},
        {Step::Firmware, &UnitRun::update, recipe.firmware && !(isEnded(Step::Firmware) && hasImage())},
        {Step::Parameters, &UnitRun::setParameters, recipe.parameters.has_value()},
        {Step::Test, &UnitRun::test, recipe.test && !isEnded(Step::Test)},
        {Step::Number, &UnitRun::giveNumber, recipe.number.has_value()},
        {Step::Proof, &UnitRun::prove, true},
    }};
    for (const Entry &entry : order) {
        if (!entry.wanted)
            continue;
        co_await perform(entry.step, entry.work);
    }
    co_return {};
}

/// Written down before it begins and when it has ended, so that whoever goes on after a cut knows where the unit stands.
Task<void> UnitRun::perform(Step step, Work work)
{
    m_visit.step = step;
    m_visit.steps.push_back({step, 0.0, false, {}});
    co_await write();
    const Message detail = co_await (this->*work)();
    if (auto same = isSame(); !same) // what comes next must not be done to it
        co_return fail(same.error());
    m_visit.steps.push_back({step, 0.0, true, detail});
    co_await write();
    co_return {};
}

Task<void> UnitRun::write()
{
    const auto took = std::chrono::duration<double>(m_device.clock().now() - m_begun);
    m_visit.seconds = m_earlier + took.count();
    m_visit.device = m_device.selector();
    Result<Visit> written = co_await m_around.journal.write(m_visit).attempt();
    if (!written) {
        m_journalError = written.error();
        co_return fail(written.error());
    }
    m_visit = std::move(*written);
    if (m_around.written)
        m_around.written(m_visit);
    co_return {};
}

bool UnitRun::isEnded(Step step) const
{
    return std::any_of(m_visit.steps.begin() + static_cast<std::ptrdiff_t>(m_trusted), m_visit.steps.end(),
        [step](const StepEntry &entry) { return entry.step == step && entry.ended; });
}

/// The unit still has what an earlier run has written: it tells the version, or nobody can.
bool UnitRun::hasImage() const
{
    const Identity &identity = m_device.identity();
    if (identity.state == DeviceState::Bootloader)
        return false;
    return !m_device.family().capabilities.versionOnWire || identity.firmware == m_visit.to;
}

bool UnitRun::storesByItself() const
{
    const Capabilities &can = m_device.family().capabilities;
    return can.storesAtOnce || can.storesAfter.count() > 0;
}

/// Another unit may answer under the number of the one before: what was known of that one is no part of this.
Task<void> UnitRun::meet()
{
    if (!m_device.liveness().restarted || m_device.identity().state == DeviceState::Bootloader)
        co_return {};
    co_await m_device.refresh();
    if (storesByItself()) {
        auto forgetting = m_device.store(m_progress); // says that the flash of the former one is not proved
        (void)co_await std::move(forgetting).attempt();
    }
    co_return {};
}

Result<void> UnitRun::isSame() const
{
    const std::string &serial = m_device.identity().serial;
    if (!serial.empty() && !m_visit.serial.empty() && serial != m_visit.serial)
        return fail(Fault::Refused, say("this is another unit by now, number %1", serial), say("look for units again"));
    return {};
}

Task<Message> UnitRun::look()
{
    co_await meet();
    co_await preflight(m_device, m_around.matter, m_around.experiments.journal, m_progress);
    co_await isSame();
    const std::string &firmware = m_device.identity().firmware;
    co_return firmware.empty() ? say("no version is told") : say("firmware %1", firmware);
}

Task<Message> UnitRun::backUp()
{
    if (m_device.identity().state == DeviceState::Bootloader)
        co_return say("nothing can be read in the bootloader");
    if (!m_around.settings) {
        co_await readAll();
        co_return say("not kept: there is no notebook");
    }
    auto taking = settings::takeSnapshot(
        m_device, settings::Occasion::Update, "before " + m_visit.recipe, *m_around.settings, m_progress);
    const settings::ParameterSnapshot snapshot = co_await std::move(taking);
    m_visit.snapshot = snapshot.number;
    const auto entries = m_device.parameters().entries();
    m_before.assign(entries.begin(), entries.end());
    co_return say("snapshot %1 has %2 values", snapshot.number, snapshot.count);
}

Task<UpdateReport> UnitRun::runUpdate()
{
    const BusyDevice busy(m_device, say("firmware update"));
    auto updating = m_device.family().update(
        m_device, m_around.matter.image, updateOptionsOf(*m_around.matter.recipe.firmware), m_progress);
    co_return co_await std::move(updating).attempt();
}

Task<Message> UnitRun::update()
{
    const UpdateReport report = co_await runUpdate();
    if (!report.from.empty() || m_visit.from.empty())
        m_visit.from = m_visit.from.empty() ? report.from : m_visit.from;
    m_visit.to = report.to;
    m_visit.unproved = report.outcome == UpdateOutcome::Done && !report.verified;
    m_visit.evidence = report.summary();
    if (report.outcome == UpdateOutcome::Cancelled)
        co_return fail(Fault::Cancelled, report.evidence);
    if (report.outcome == UpdateOutcome::Done || report.outcome == UpdateOutcome::UpToDate) {
        auto meeting = meet(); // its restart was our own: no reason to stop the motor later
        co_await std::move(meeting);
        if (report.outcome == UpdateOutcome::UpToDate)
            co_return say("already %1", report.to);
        const Message written = say("%1 pages, %2 sent again", report.pages, report.retries);
        co_return m_visit.unproved ? joined(written, report.evidence) : written;
    }
    co_return fail(report.fault.value_or(Fault::Refused), report.evidence, report.remedy);
}

Task<void> UnitRun::readAll()
{
    const std::vector<TransferOutcome> outcomes = co_await readParameters(m_device, readable(m_device), m_progress);
    for (const TransferOutcome &outcome : outcomes) {
        if (!outcome.raw)
            co_return fail(outcome.raw.error());
    }
    co_return {};
}

/// The unit is not known to have it; of what cannot be read, nobody has written it since it was lost.
bool UnitRun::isMissing(const ParameterChange &change) const
{
    const ParameterStore::Entry &entry = m_device.parameters().entry(change.index);
    return !entry.raw || entry.state == ParameterState::Failed || *entry.raw != change.raw;
}

/// What is assumed of it may be the unit's before, so that it is written each time.
bool UnitRun::isUnreadable(const ParameterChange &change) const
{
    return m_device.parameters().parameter(change.index).access == Access::WriteOnly;
}

/// Readable settings that are not part of the recipe and not what the backup says.
int UnitRun::others() const
{
    int count = 0;
    const auto &wanted = m_around.matter.parameters;
    for (std::uint16_t i = 0; i < m_before.size(); ++i) {
        const Parameter &parameter = m_device.parameters().parameter({i});
        const bool ours
            = std::ranges::any_of(wanted, [i](const ParameterChange &change) { return change.index.value == i; });
        const auto &now = m_device.parameters().entry({i});
        if (!ours && parameter.nature == Nature::Setting && parameter.persistent && !parameter.belongsToUnit
            && m_before[i].raw && now.raw && *m_before[i].raw != *now.raw)
            ++count;
    }
    return count;
}

Task<Message> UnitRun::setParameters()
{
    co_await readAll();
    if (auto offered = checkOffered(m_device, m_around.matter); !offered) // an update may have changed what it has
        co_return fail(offered.error());
    std::vector<ParameterChange> changes = m_around.matter.parameters;
    std::erase_if(
        changes, [this](const ParameterChange &change) { return !isUnreadable(change) && !isMissing(change); });
    auto writing = settings::writeKept(
        m_device, changes, {settings::Origin::Recipe, settings::Purpose::Write}, m_around.settings, m_progress);
    const std::vector<TransferOutcome> outcomes = co_await std::move(writing);
    for (const TransferOutcome &outcome : outcomes) {
        if (!outcome.raw)
            co_return fail(outcome.raw.error());
        if (m_device.parameters().parameter(outcome.index).afterRestart)
            m_later.push_back(outcome.index);
    }
    m_wrote = !changes.empty();
    if (m_around.matter.recipe.parameters->store && !storesByItself())
        co_await m_device.store(m_progress);
    const auto &wanted = m_around.matter.parameters;
    const auto count = static_cast<int>(wanted.size());
    const auto untold = std::ranges::count_if(wanted, [this](const auto &change) { return isUnreadable(change); });
    m_visit.parameters = count - static_cast<int>(untold) - static_cast<int>(m_later.size());
    co_return say("%1 of %2 written", changes.size(), settingsText(count));
}

/// Of who stands still anyway nothing is judged: its visit stays open.
Result<void> UnitRun::goesOn(Message whatStops) const
{
    const tuning::Interruption *const stop = m_around.experiments.interruption;
    return stop && stop->isRequested() ? fail(Fault::Cancelled, std::move(whatStops)) : Result<void>();
}

/// Announced each time, before the motor turns.
Task<TestFinding> UnitRun::testOnce()
{
    const SelfTest &wanted = *m_around.matter.recipe.test;
    co_await goesOn(say("stopped before its motor turned"));
    co_await m_around.permit->beforeMotion(m_device, wanted, m_progress);
    co_await goesOn(say("stopped before its motor turned"));
    const PermittedMotion turning(*m_around.permit, m_around.experiments.interruption);
    Result<TestFinding> finding = co_await runSelfTest(m_device, m_stream, wanted, m_around.experiments).attempt();
    const bool stands = !finding || finding->ending == Ending::None;
    if (stands && m_around.leftOut && *m_around.leftOut)
        co_return fail(Fault::Cancelled);
    co_return finding;
}

/// Samples that were lost on the way say nothing of the motor: while the unit answers, the test is done again.
Task<Message> UnitRun::test()
{
    if (!m_around.permit)
        co_return fail(
            Fault::Unsafe, say("nobody watches over this self-test, and it moves the motor"), say("arm it first"));
    TestFinding finding = co_await testOnce();
    int tries = 1;
    while (isLost(finding) && m_device.liveness().heard && tries < mostTests) {
        Result<TestFinding> next = co_await testOnce().attempt();
        if (!next && next.error().fault == Fault::OutOfRange)
            break; // the lost one has used up the way that was announced
        finding = co_await std::move(next);
        ++tries;
    }
    VisitFilter passed;
    passed.recipe = m_visit.recipe;
    passed.recipeHash = m_visit.recipeHash;
    passed.outcome = Outcome::Passed;
    passed.simulated = m_visit.simulated;
    passed.newest = visitsForBand;
    passed.steps = false;
    const Result<std::vector<Visit>> others = co_await m_around.journal.visits(passed).attempt();
    const Message unusual = others ? markUnusual(finding.values, *others) : Message();
    m_visit.test = std::move(finding.values);
    m_visit.trial = finding.trial;
    m_visit.ending = finding.ending;
    if (finding.failure)
        co_return fail(*finding.failure);
    const Message held = tries == 1 ? say("within its limits")
                                    : say("within its limits, at attempt %1: samples were lost before", tries);
    co_return joined(held, unusual);
}

/// Without a server and with none left the unit waits here: nothing else is lost by that.
Task<int> UnitRun::reserve()
{
    const Family &family = m_device.family();
    NumberWish wish{numberScopeOf(m_visit), numberOwnerOf(m_visit), m_visit.id, m_around.matter.recipe.number->first,
        family.capabilities.lastAddress, m_around.taken, m_visit.simulated};
    bool hasWaited = false;
    for (;;) {
        const Result<std::optional<int>> number = co_await m_around.journal.number(wish).attempt();
        if (number && *number) {
            if (hasWaited) { // another may have taken its place
                co_await m_device.refresh();
            }
            co_return **number;
        }
        if (number) {
            m_visit.ending = Ending::NumbersUsedUp;
            co_return fail(Fault::OutOfRange, say("all numbers are used up, the highest is %1", wish.last),
                say("begin another recipe, or another bus"));
        }
        if (number.error().fault != Fault::Timeout)
            co_return fail(number.error());
        co_await goesOn(say("stopped while it waited for a number"));
        m_progress.step(say("no number: server silent"), 0, 0);
        hasWaited = true;
        co_await standBy();
    }
}

/// Whoever takes it off meanwhile may put another one on: then it is not this unit that waits.
Task<void> UnitRun::standBy()
{
    const bool isFollowed = m_device.liveness().heard;
    const Instant again = m_device.clock().now() + numberAgain;
    Instant heardAt = m_device.clock().now();
    while (m_device.clock().now() < again || (isFollowed && !m_device.liveness().heard)) {
        if (m_device.liveness().heard)
            heardAt = m_device.clock().now();
        if (isFollowed && m_device.clock().now() - heardAt >= exchangeTime)
            co_return fail(Fault::Timeout, say("the unit was taken off while it waited for a number"),
                say("put it on again, and do it again"));
        co_await Sleep(m_device.clock(), lookForUnit);
    }
    co_return {};
}

Task<Message> UnitRun::giveNumber()
{
    if (!m_visit.number) {
        const int number = co_await reserve();
        co_await isSame();
        m_visit.number = number;
        auto noting = write(); // it is this unit's, whatever happens next
        co_await std::move(noting);
    }
    co_await isSame();
    const int old = m_device.identity().address;
    m_progress.step(say("Giving it number %1", *m_visit.number), 0, 0);
    if (old != *m_visit.number)
        co_await settings::renumberKept(
            m_device, *m_visit.number, settings::Origin::Recipe, m_around.settings, m_progress);
    co_return old == *m_visit.number ? say("number %1, as before", *m_visit.number) : say("number %1", *m_visit.number);
}

/// What proves it, and what nothing can prove.
Message UnitRun::proofOf(bool stores) const
{
    const auto &wanted = m_around.matter.parameters;
    const auto blind = std::ranges::count_if(wanted, [this](const auto &change) { return isUnreadable(change); });
    const bool isChanged = m_wrote || m_earlier > 0.0; // what was cut off may have written
    Message told = !stores ? say("read back") : isChanged ? say("its flash has it") : say("nothing had to be stored");
    if (blind > 0) {
        const Message untold = blind == 1 ? say("1 setting was written and cannot be read back")
                                          : say("%1 settings were written and cannot be read back", blind);
        told = blind == std::ssize(wanted) && !stores ? untold : joined(told, untold);
    }
    if (m_visit.number && m_device.identity().address != *m_visit.number)
        told = joined(told, say("its number holds from its next power cycle on, and nothing proves it before"));
    if (!m_later.empty())
        told = joined(told,
            m_later.size() == 1
                ? say("1 setting holds from its next power cycle on, and nothing proves it before")
                : say("%1 settings hold from its next power cycle on, and nothing proves them before", m_later.size()));
    if (!wanted.empty() && !stores && !m_around.matter.recipe.parameters->store)
        told = joined(told,
            wanted.size() == 1 ? say("1 setting is lost with its power")
                               : say("%1 settings are lost with its power", wanted.size()));
    return told;
}

Task<Message> UnitRun::prove()
{
    const bool stores = storesByItself();
    if (stores) {
        const bool proved
            = co_await settings::storeKept(m_device, settings::Origin::Recipe, m_around.settings, m_progress);
        if (!proved)
            co_return fail(Fault::BadCheck, say("nothing proves that its flash has what was written"),
                say("switch its supply off and on, then do it again: what is read then comes from its flash"));
    }
    co_await m_device.refresh();
    co_await isSame();
    m_visit.to = m_device.identity().firmware;
    co_await readAll();
    std::vector<ParameterChange> left = m_around.matter.parameters;
    std::erase_if(left, [this](const ParameterChange &change) {
        return std::ranges::find(m_later, change.index) != m_later.end() || !isMissing(change);
    });
    if (!left.empty())
        co_return fail(Fault::BadCheck,
            say("%1 of the recipe read back different, first %2", settingsText(static_cast<int>(left.size())),
                m_device.parameters().parameter(left.front().index).key),
            say("do it again"));
    if (m_around.matter.recipe.firmware && m_device.family().capabilities.versionOnWire
        && !m_around.matter.imageVersion.empty() && m_visit.to != m_around.matter.imageVersion)
        co_return fail(Fault::BadCheck,
            say("the unit answers with firmware %1, the image is %2", m_visit.to, m_around.matter.imageVersion),
            say("do it again"));
    const Message told = proofOf(stores);
    const int changed = others();
    co_return changed == 0
        ? told
        : joined(told, say("%1 besides those of the recipe differ from the backup", settingsText(changed)));
}

Task<Visit> UnitRun::conclude(Outcome outcome, Error error)
{
    Message evidence;
    for (std::size_t i = m_trusted; i < m_visit.steps.size(); ++i) {
        const StepEntry &entry = m_visit.steps[i];
        if (entry.ended && !entry.detail.empty())
            evidence = joined(evidence, say("%1: %2", Message::label(toString(entry.step)), entry.detail));
    }
    m_visit.evidence = std::move(evidence);
    m_visit.outcome = outcome;
    m_visit.cause = error.detail;
    m_visit.remedy = error.help();
    if (outcome == Outcome::Passed)
        m_visit.step = Step::Done;
    m_visit.steps.push_back({m_visit.step, 0.0, true, outcome == Outcome::Passed ? say("passed") : error.detail});
    co_await write();
    co_return m_visit;
}

} // namespace mb::service
