// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/target.h"

#include "app/console/within.h"
#include "async/seconds.h"
#include "model/linkbook.h"
#include "model/parametertransfer.h"
#include "model/registry.h"
#include "transport/backends/replay.h"

#include <algorithm>
#include <cmath>

namespace mb::console {
namespace {

std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

} // namespace

bool serves(const Family &family, LinkKind kind)
{
    return std::ranges::find(family.links, kind) != family.links.end();
}

Result<const Family *> parseFamily(std::span<const Family *const> families, std::string_view key)
{
    if (const Family *family = findFamily(families, key))
        return family;
    std::vector<std::string_view> known;
    for (const Family *family : families)
        known.push_back(family->key);
    return fail(
        Fault::Usage, say("unknown family '%1'", key), suggestion(key, known, "this build knows " + joined(known)));
}

Result<Target> parseTarget(const Console &console, std::string_view text)
{
    MB_TRY(auto selector, DeviceSelector::parse(text));
    MB_TRY(auto family, parseFamily(console.families(), selector.family));
    const Capabilities &can = family->capabilities;
    if (selector.address < can.firstAddress || selector.address > can.lastAddress)
        return fail(Fault::OutOfRange, say("%1: %2 is out of range", family->key, selector.address),
            say("legal is %1 … %2", can.firstAddress, can.lastAddress));
    for (const LinkAddress &link : expandLink(selector.link, console.families())) {
        if (!serves(*family, kindOf(link)))
            continue;
        selector.link = link;
        return Target{std::move(selector), family};
    }
    return fail(Fault::Usage, say("%1 is not found on %2", family->key, selector.link.text()),
        say("name a link of the kind %1", toString(family->links.front())));
}

Result<std::vector<LinkAddress>> parseLinks(const Console &console, const std::vector<std::string> &texts)
{
    std::vector<LinkAddress> links;
    for (const std::string &text : texts) {
        MB_TRY(auto address, LinkAddress::parse(text));
        for (LinkAddress &link : expandLink(address, console.families())) {
            if (std::ranges::find(links, link) == links.end())
                links.push_back(std::move(link));
        }
    }
    return links;
}

namespace {

/// What writes again what a power cycle took, as a command.
std::string rewritingCommand(const Device &device, const std::vector<ParameterChange> &lost)
{
    if (!device.family().capabilities.keepsSettings)
        return "motorbenchctl restore " + device.selector();
    std::string command = "motorbenchctl set " + device.selector();
    for (const ParameterChange &change : lost) {
        const Parameter &parameter = device.parameters().parameter(change.index);
        command += ' ' + std::string(parameter.key) + '=' + toText(parameter, change.raw);
    }
    return command + " --store";
}

Task<void> noteReset(Console &console, Device &device)
{
    if (device.identity().state == DeviceState::Bootloader)
        co_return {};
    if (!device.family().capabilities.keepsSettings)
        co_await device.refresh();
    noteLost(console, device);
    co_return {};
}

} // namespace

void noteLost(Console &console, const Device &device)
{
    const std::vector<ParameterChange> lost = lostSettings(device.family(), device.knowledge().profile());
    if (!lost.empty())
        console.note(device.selector()
            + (device.family().capabilities.keepsSettings ? " may have been reset: " : " was reset: ")
            + std::to_string(lost.size()) + " settings that were written to it are unknown; write them again with '"
            + rewritingCommand(device, lost) + "'");
}

namespace {

/// As long as --timeout says.
Task<Device *> find(const Console &console, Session &session, const Target &target)
{
    const std::optional<Duration> limit = console.options().patience.timeout;
    Error late{Fault::Timeout,
        say("no answer from %1 %2 within %3 s", target.selector.family, target.selector.address,
            secondsOf(limit.value_or(Duration::zero())))};
    return within(session.clock(), session.connect(target.selector, target.mayBeSilent), limit, std::move(late));
}

} // namespace

Task<Device *> connect(Console &console, Target target)
{
    return connectIn(console, console.session(), std::move(target));
}

Task<Device *> connectIn(Console &console, Session &session, Target target)
{
    Result<Device *> device;
    for (int tries = 0; tries <= console.options().patience.retries; ++tries) {
        device = co_await find(console, session, target).attempt();
        if (device || device.error().fault != Fault::Timeout)
            break;
        if (console.isInterrupted()) // a verb that listens is not cut, but need not go on looking
            co_return fail(Fault::Cancelled, say("interrupted before it was done"));
    }
    if (!device && device.error().fault == Fault::Refused)
        co_return fail(Fault::Usage, device.error().detail, device.error().remedy); // the words fit several
    if (!device)
        co_return fail(device.error());
    noteRemark(console, (*device)->link());
    (*device)->link().settings().patience = console.options().patience;
    co_await noteReset(console, **device);
    console.begin();
    co_return *device;
}

Result<void> needsApplication(const Device &device)
{
    MB_TRY_VOID(device.link().address().takesOrders());
    if (device.identity().state != DeviceState::Bootloader)
        return {};
    return fail(Fault::Refused, say("%1 waits in its bootloader, where this is not possible", device.selector()),
        say("update its firmware with 'motorbenchctl flash' first"));
}

void noteRemark(Console &console, Link &link)
{
    const ReplayLink *const recording = replayOf(link);
    const Message remark = recording ? recording->remark() : Message();
    if (!remark.empty())
        console.note(link.address().path + ": " + remark.english());
}

QJsonObject scanRow(const Device &device, const std::string &name)
{
    const Identity &identity = device.identity();
    return {
        {QStringLiteral("device"), qt(device.selector())},
        {QStringLiteral("family"), qt(identity.family)},
        {QStringLiteral("address"), identity.address},
        {QStringLiteral("session"), identity.session ? QJsonValue(*identity.session) : QJsonValue()},
        {QStringLiteral("name"), textOrNull(name)},
        {QStringLiteral("serial"), textOrNull(identity.serial)},
        {QStringLiteral("state"), qt(toString(identity.state))},
        {QStringLiteral("firmware"), textOrNull(identity.firmware)},
        {QStringLiteral("bootloader"), textOrNull(identity.bootloader)},
        {QStringLiteral("dialect"), textOrNull(identity.dialect)},
        {QStringLiteral("detail"), textOrNull(identity.detail.english())},
    };
}

Message suggestion(std::string_view wrong, const std::vector<std::string_view> &known, std::string otherwise)
{
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(2, wrong.size() / 3) + 1;
    for (const std::string_view word : known) {
        const bool part = wrong.size() >= 3 && word.ends_with(wrong);
        const std::size_t distance = part ? 1 : editDistance(wrong, word);
        if (distance < least && distance < word.size()) {
            least = distance;
            nearest = word;
        }
    }
    return nearest.empty() ? Message::verbatim(std::move(otherwise)) : say("did you mean %1?", nearest);
}

std::string joined(const std::vector<std::string_view> &words)
{
    std::string list;
    for (const std::string_view word : words)
        list += (list.empty() ? "" : ", ") + std::string(word);
    return list;
}

Result<void> checkName(std::string_view name, const std::string &text)
{
    const QString characters = qt(text);
    if (characters.toStdString() != text)
        return fail(Fault::OutOfRange, say("%1 is text in UTF-8", name), say("choose another"));
    if (std::ranges::any_of(characters, [](QChar c) { return c.category() == QChar::Other_Control; }))
        return fail(Fault::OutOfRange, say("%1 has no line break, tabulator or other control character", name),
            say("choose another"));
    return {};
}

namespace {

Result<double> parseAs(Message example, std::string_view name, const std::string &text, double low, double high)
{
    const std::optional<double> number = numberFrom(text);
    if (!number)
        return fail(Fault::OutOfRange, say("%1: '%2' is not a number", name, text), std::move(example));
    if (*number < low || *number > high)
        return fail(Fault::OutOfRange, say("%1: %2 is out of range", name, text), say("legal is %1 … %2", low, high));
    return *number;
}

} // namespace

Result<double> parseNumber(std::string_view name, const std::string &text, double low, double high)
{
    return parseAs(say("write it with a dot, like 2.5"), name, text, low, high);
}

Result<double> parseModeNumber(std::string_view name, const std::string &text, Mode mode, double low, double high)
{
    MB_TRY(const auto number, parseNumber(name, text, low, high));
    if (unitOf(mode) == "counts" && number != std::floor(number))
        return fail(
            Fault::OutOfRange, say("%1: %2 is not a whole number", name, text), say("a position is so many counts"));
    return number;
}

Result<int> parseInteger(std::string_view name, const std::string &text, int low, int high)
{
    MB_TRY(const auto number, parseAs(say("legal is %1 … %2", low, high), name, text, low, high));
    if (number != std::floor(number))
        return fail(
            Fault::OutOfRange, say("%1: %2 is not a whole number", name, text), say("legal is %1 … %2", low, high));
    return static_cast<int>(number);
}

Result<int> integerOr(int usual, std::string_view name, const std::string &text, int low, int high)
{
    return text.empty() ? Result<int>(usual) : parseInteger(name, text, low, high);
}

Result<std::optional<Duration>> parseSpan(const std::string &text)
{
    if (text.empty())
        return std::optional<Duration>();
    MB_TRY(const auto seconds, parseNumber("--for", text, 0.001, 1e8));
    return std::optional<Duration>(fromSeconds(seconds));
}

} // namespace mb::console
