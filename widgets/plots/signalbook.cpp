// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/signalbook.h"

#include "transport/linkaddress.h"
#include "widgets/common/devicetext.h"

#include <QRegularExpression>

#include <algorithm>
#include <map>

namespace mb {
namespace {

constexpr std::size_t advanceMost = 20'000; ///< samples of derived signals in one tick: about 3 ms

QString asName(std::string_view text)
{
    QString name = qt(text);
    for (QChar &each : name) {
        if (!each.isLetterOrNumber())
            each = QLatin1Char('_');
    }
    return name;
}

/// As `d5`, whatever else has the number.
QString plainName(const DeviceView &device)
{
    return QStringLiteral("d%1").arg(device.identity->address);
}

/// The shortest that no other device has: `d5`, with its family `dmc60c5`, with its link `dmc60c5_can1`.
QString nameAmong(const std::vector<DeviceView> &devices, const DeviceView &device)
{
    const auto others = [&](auto isAlike) {
        return std::ranges::any_of(devices, [&](const DeviceView &other) {
            return other.id != device.id && other.identity->address == device.identity->address && isAlike(other);
        });
    };
    if (!others([](const DeviceView &) { return true; }))
        return plainName(device);
    const QString name = asName(device.family->key) + QString::number(device.identity->address);
    if (!others([&](const DeviceView &other) { return other.family == device.family; }))
        return name;
    const std::string behindScheme
        = device.link.substr(device.link.find(':') + 1); // with what tells two of one path apart
    return name + QLatin1Char('_') + asName(behindScheme);
}

QString nameOfChannel(const QString &device, const Channel &channel)
{
    return device + QLatin1Char('_') + asName(channel.key);
}

} // namespace

SignalBook::SignalBook(Workbench &workbench)
    : m_workbench(workbench)
{
}

const SignalBook::Derived *SignalBook::derivedOf(const Signal &signal) const
{
    const bool there = signal.device == derivedDevice && signal.channel.value < m_derived.size();
    return there ? &m_derived[signal.channel.value] : nullptr;
}

const Channel *SignalBook::rowOf(const Signal &signal) const
{
    if (signal.device == derivedDevice) {
        const bool there = signal.channel.value < m_derived.size() && m_derived[signal.channel.value].signal;
        return there ? m_derived[signal.channel.value].signal->telemetry()->channels().data() : nullptr;
    }
    const DeviceView *device = m_workbench.snapshot().device(signal.device);
    const bool there = device && signal.channel.value < device->channels().size();
    return there ? &device->channels()[signal.channel.value] : nullptr;
}

std::shared_ptr<const Telemetry> SignalBook::telemetryOf(const Signal &signal) const
{
    if (!rowOf(signal))
        return nullptr;
    if (signal.device == derivedDevice)
        return m_derived[signal.channel.value].signal->telemetry();
    return m_workbench.snapshot().device(signal.device)->telemetry;
}

QString SignalBook::nameOf(const Signal &signal) const
{
    if (signal.device == derivedDevice)
        return m_derived[signal.channel.value].name;
    const Snapshot &shot = m_workbench.snapshot();
    return signalName(*shot.device(signal.device), signal.channel, shot.devices);
}

std::vector<const DeviceView *> SignalBook::devicesOf(const Signal &signal) const
{
    const Derived *const derived = derivedOf(signal);
    std::vector<const DeviceView *> devices;
    for (const Signal &one : derived ? derived->inputs : std::vector{signal}) {
        if (const DeviceView *device = m_workbench.snapshot().device(one.device))
            devices.push_back(device);
    }
    return devices;
}

std::string SignalBook::linkOf(const Signal &signal) const
{
    const auto devices = devicesOf(signal);
    return devices.empty() ? std::string() : devices.front()->link;
}

std::vector<SignalBook::Variable> SignalBook::variables() const
{
    std::vector<Variable> all;
    const std::vector<DeviceView> &devices = m_workbench.snapshot().devices;
    for (const DeviceView &device : devices) {
        if (device.identity->state == DeviceState::Bootloader)
            continue;
        const QString name = nameAmong(devices, device);
        for (std::uint16_t i = 0; i < device.family->channels.size(); ++i)
            all.push_back({nameOfChannel(name, device.family->channels[i]), {device.id, {i}}});
    }
    return all;
}

QString SignalBook::whatIsAmbiguous(const QString &formula) const
{
    std::map<QString, QStringList> meanings;
    for (const Variable &variable : variables()) {
        const DeviceView &device = *m_workbench.snapshot().device(variable.signal.device);
        const QString plain = nameOfChannel(plainName(device), device.family->channels[variable.signal.channel.value]);
        meanings[plain].append(variable.name);
    }
    for (const auto &[plain, names] : meanings) {
        if (names.size() > 1 && formula.contains(QRegularExpression(QStringLiteral("\\b%1\\b").arg(plain))))
            return tr("%1 may be one of %2").arg(plain, names.join(QStringLiteral(", ")));
    }
    return {};
}

SignalAddress SignalBook::addressOf(const Signal &signal) const
{
    if (signal.device == derivedDevice)
        return {{}, m_derived[signal.channel.value].name.toStdString()};
    return {m_workbench.snapshot().device(signal.device)->selector, std::string(rowOf(signal)->key)};
}

std::optional<Signal> SignalBook::find(const SignalAddress &address) const
{
    for (std::uint16_t i = 0; address.device.empty() && i < m_derived.size(); ++i) {
        if (m_derived[i].signal && m_derived[i].name == qt(address.key))
            return Signal{derivedDevice, {i}};
    }
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        const bool fits = !address.device.empty() && device.selector == address.device;
        if (const auto channel = fits ? findChannel(device.channels(), address.key) : std::nullopt)
            return Signal{device.id, *channel};
    }
    return std::nullopt;
}

/// Where nothing is settled yet, all that there is now.
std::vector<SignalBook::Meaning> SignalBook::meaningsOf(const Derived &derived) const
{
    if (!derived.meanings.empty())
        return derived.meanings;
    std::vector<Meaning> all;
    for (const Variable &variable : variables())
        all.push_back({variable.name, addressOf(variable.signal)});
    return all;
}

/// False, and nothing is changed, while a device of the formula is not there.
bool SignalBook::compile(Derived &derived) const
{
    const std::vector<Meaning> all = meaningsOf(derived);
    std::vector<std::string> names;
    for (const Meaning &meaning : all)
        names.push_back(meaning.name.toStdString());
    auto expression = Expression::parse(derived.formula.toStdString(), names);
    if (!expression)
        return false;
    Derived found{derived.name, derived.unit, derived.formula};
    std::vector<DerivedSignal::Input> inputs;
    for (const std::size_t used : expression->used()) {
        const auto signal = find(all[used].address);
        if (!signal)
            return false;
        inputs.push_back({telemetryOf(*signal), signal->channel});
        found.meanings.push_back(all[used]);
        found.inputs.push_back(*signal);
        found.rows.push_back(rowOf(*signal));
    }
    found.signal = std::make_shared<DerivedSignal>(
        derived.name.toStdString(), derived.unit.toStdString(), std::move(*expression), inputs);
    derived = std::move(found);
    return true;
}

/// A unit that got another number is the same, and is found under that from now on.
bool SignalBook::isOfNow(Derived &derived) const
{
    for (std::size_t i = 0; derived.signal && i < derived.inputs.size(); ++i) {
        const Signal &input = derived.inputs[i];
        if (telemetryOf(input).get() != &derived.signal->input(i) || rowOf(input) != derived.rows[i])
            return false;
        derived.meanings[i].address = addressOf(input);
    }
    return derived.signal != nullptr;
}

QString SignalBook::whatIsWrong(const QString &name, const QString &formula) const
{
    const QString wanted = name.trimmed();
    if (wanted.isEmpty())
        return tr("The signal needs a name.");
    for (const Derived &derived : m_derived) {
        if (derived.name == wanted)
            return tr("There is a derived signal of this name.");
    }
    std::vector<std::string> names;
    for (const Variable &variable : variables())
        names.push_back(variable.name.toStdString());
    const auto expression = Expression::parse(formula.toStdString(), names);
    if (expression)
        return {};
    const QString ambiguous = whatIsAmbiguous(formula);
    return ambiguous.isEmpty() ? errorText(expression.error()) : ambiguous;
}

Result<Signal> SignalBook::add(const QString &name, const QString &unit, const QString &formula)
{
    if (const QString wrong = whatIsWrong(name, formula); !wrong.isEmpty())
        return fail(Fault::OutOfRange, Message::verbatim(wrong.toStdString()));
    m_derived.push_back({name.trimmed(), unit.trimmed(), formula.trimmed()});
    (void)compile(m_derived.back());
    return Signal{derivedDevice, {static_cast<std::uint16_t>(m_derived.size() - 1)}};
}

void SignalBook::ensure(const QString &name, const QString &unit, const QString &formula, std::vector<Meaning> meanings)
{
    const bool known = std::ranges::any_of(m_derived, [&](const Derived &derived) { return derived.name == name; });
    if (known || name.isEmpty())
        return;
    m_derived.push_back({name, unit, formula, std::move(meanings)});
    (void)compile(m_derived.back());
}

void SignalBook::remove(const Signal &signal)
{
    if (derivedOf(signal))
        m_derived[signal.channel.value] = {};
}

bool SignalBook::complete()
{
    bool any = false;
    for (Derived &derived : m_derived) {
        if (!derived.name.isEmpty() && !isOfNow(derived))
            any = compile(derived) || any;
    }
    return any;
}

void SignalBook::advance()
{
    for (const Derived &derived : m_derived) {
        if (derived.signal)
            derived.signal->advance(advanceMost);
    }
}

} // namespace mb
