// SPDX-License-Identifier: GPL-3.0-or-later
#include "hourbench.h"

#include <array>

namespace mb::test {
namespace {

using namespace std::chrono_literals;

constexpr std::array<const char *, 3> links{"sim:can", "sim:serial", "sim:spi"};

/// A parameter of each family that may have any of these raw values while nothing else depends on it.
struct Free {
    std::string_view family;
    std::string_view key;
    std::int64_t least;
    std::int64_t most;
};
constexpr std::array freeParameters{
    Free{"dmc60c", "slot1.d", 0, 5000},
    Free{"supermodified", "gain.d", 15'900, 16'100},
    Free{"abstractdc", "position.d", -20, 20},
    Free{"quadquad2drv", "history.length", 2, 127},
};
constexpr std::array rates{0.0, 5.0, 20.0, 50.0, 100.0, 200.0};

struct Order {
    const char *name;
    int share; ///< of a hundred
    void (HourBench::*give)();
};

} // namespace

HourBench::HourBench(std::uint64_t seed)
    : m_random(seed)
    , m_listening(m_core.noticed().add([this](Severity, const std::string &about, const Message &line) {
        m_lines.insert(about + ": " + line.english());
    }))
{
    for (const char *link : links)
        open(link);
    pass(5s);
    for (const DeviceView &device : m_core.snapshot().devices)
        expect(device, "found on " + m_core.snapshot().link(device.link)->name);
    m_rows = rows();
    EXPECT_EQ(m_rows.size(), 9U) << "as many kinds of order";
}

void HourBench::open(const std::string &link)
{
    m_core.send(orders::OpenLink{*LinkAddress::parse(link)}, [](const Result<void> &opened) { EXPECT_TRUE(opened); });
    for (Link *one : m_core.session().links()) {
        if (m_taps.contains(one))
            continue;
        m_passed[one] = {one->counters().rx, one->counters().tx};
        m_taps[one] = one->traffic().add([this, one](const Traffic &traffic) {
            auto &[received, sent] = m_passed[one];
            (traffic.direction == Direction::Sent ? sent : received) += traffic.can ? 1 : traffic.bytes.size();
        });
    }
}

// What is done

void HourBench::act()
{
    static constexpr std::array<Order, 8> table{{
        {"drive", 30, &HourBench::drive},
        {"write", 15, &HourBench::write},
        {"read", 10, &HourBench::read},
        {"rate", 10, &HourBench::chooseRate},
        {"scan", 8, &HourBench::scan},
        {"reopen", 2, &HourBench::reopen},
        {"stop", 5, &HourBench::stopEverything},
        {"rest", 20, &HourBench::rest},
    }};
    int lot = number(0, 99);
    const auto *order = table.begin();
    for (; lot >= order->share; ++order)
        lot -= order->share;
    ++m_orders[order->name];
    (this->*order->give)();
    pass(1ms * number(0, 2000));
}

void HourBench::drive()
{
    const DeviceView view = drawn([](const DeviceView &device) { return device.mayNotMove.empty(); });
    SetPoint setPoint;
    setPoint.mode = view.family->modes.front();
    setPoint.axis = view.family->capabilities.axes > 1 ? number(1, view.family->capabilities.axes) : 1;
    setPoint.target = (setPoint.mode == Mode::Duty ? 0.2 : 400.0) * number(-10, 10) / 10.0;
    if (const Message caution = m_core.session().find(view.id)->caution(setPoint); !caution.empty())
        expect(view, caution.english());
    std::optional<Result<void>> started;
    m_core.send(
        orders::StartMotion{view.id, setPoint, 500ms}, [&started](const Result<void> &result) { started = result; });
    for (int i = number(1, 25); i > 0; --i) {
        pass(100ms);
        m_core.send(orders::RenewMotion{view.id});
    }
    ASSERT_TRUE(started && *started) << (started ? started->error().text() : "no answer");
    if (number(0, 9) == 0)
        m_core.stopAll(StopCause::User);
    else
        m_core.send(orders::StopMotion{view.id});
    pass(4s);
    const Snapshot shot = m_core.snapshot();
    EXPECT_FALSE(shot.device(view.id)->motion.running) << view.selector;
    EXPECT_FALSE(shot.device(view.id)->liveness.moving) << view.selector;
}

void HourBench::write()
{
    const Free &free = freeParameters.at(static_cast<std::size_t>(number(0, freeParameters.size() - 1)));
    const DeviceView view = drawn([&free](const DeviceView &device) {
        return device.family->key == free.family && device.identity->state == DeviceState::Online;
    });
    const auto index = findParameter(view.family->parameters, free.key);
    ASSERT_TRUE(index);
    const Parameter &row = view.family->parameters[index->value];
    const auto &before = view.parameters->at(index->value).raw;
    const std::int64_t raw = number(free.least, free.most);
    std::optional<Result<void>> done;
    m_core.send(
        orders::WriteParameters{view.id, {{*index, raw}}}, [&done](const Result<void> &result) { done = result; });
    pass(3s);
    ASSERT_TRUE(done && *done) << view.selector << ' ' << free.key;
    m_written[{view.selector, std::string(free.key)}] = raw;
    expect(view, std::string(row.key) + ": " + (before ? shownText(row, *before) : "?") + " → " + shownText(row, raw));
    expect(view,
        row.access == Access::WriteOnly ? "1 written; they cannot be read back" : "1 written, read back and equal");
}

void HourBench::read()
{
    const DeviceView view
        = drawn([](const DeviceView &device) { return device.identity->state == DeviceState::Online; });
    m_core.send(orders::ReadParameters{view.id});
    pass(4s);
}

void HourBench::chooseRate()
{
    const DeviceView view
        = drawn([](const DeviceView &device) { return device.identity->state == DeviceState::Online; });
    std::uint16_t channel = 0;
    do
        channel = static_cast<std::uint16_t>(number(0, std::ssize(view.family->channels) - 1));
    while (view.family->channels[channel].quantity == Quantity::SetPoint);
    const double hertz = rates.at(static_cast<std::size_t>(number(0, rates.size() - 1)));
    m_core.send(orders::WishRates{100ULL * view.id.value + channel, {{view.id, {channel}, hertz}}});
    pass(1s);
}

void HourBench::scan()
{
    m_core.send(orders::ScanLinks{});
    pass(5s);
}

/// A simulated bench that is opened again is a new one.
void HourBench::reopen()
{
    const std::string address = links.at(static_cast<std::size_t>(number(0, links.size() - 1)));
    for (const DeviceView &device : m_core.snapshot().devices) {
        if (device.link != address)
            continue;
        expect(device, "is gone");
        expect(device, "found on " + address);
        for (std::uint16_t i = 0; i < device.telemetry->channels().size(); ++i)
            m_samplesBefore += device.telemetry->size({i});
    }
    std::erase_if(m_written, [&address](const auto &entry) { return entry.first.first.starts_with(address + '/'); });
    Link *const link = m_core.session().linkBook().find(*LinkAddress::parse(address));
    m_taps.erase(link);
    m_passed.erase(link);
    m_core.send(orders::CloseLink{address});
    pass(1ms * number(1500, 5000));
    open(address);
    pass(6s);
}

void HourBench::stopEverything()
{
    m_core.stopAll(StopCause::User);
    pass(4s);
}

void HourBench::rest()
{
    pass(1s * number(1, 60));
}

// What is shown

void HourBench::check()
{
    const Snapshot shot = m_core.snapshot();
    ASSERT_EQ(rows(), m_rows);
    checkLinks(shot);
    for (const DeviceView &device : shot.devices)
        checkDevice(device);
    for (const DeviceView &device : shot.devices) {
        for (std::size_t i = 0; i < device.parameters->size(); ++i) {
            const auto written = m_written.find({device.selector, std::string(device.family->parameters[i].key)});
            if (written != m_written.end()) {
                ASSERT_EQ((*device.parameters)[i].raw, written->second) << device.selector;
            }
        }
    }
    checkLog();
}

void HourBench::checkLinks(const Snapshot &shot)
{
    ASSERT_EQ(shot.links.size(), links.size());
    for (const LinkView &link : shot.links) {
        const auto &[received, sent] = m_passed.at(m_core.session().linkBook().find(*LinkAddress::parse(link.address)));
        ASSERT_EQ(link.counters.lost, 0U) << link.address;
        ASSERT_EQ(link.unknown, 0U) << link.address;
        ASSERT_EQ(link.counters.rx, received) << link.address;
        ASSERT_EQ(link.counters.tx, sent) << link.address;
        ASSERT_TRUE(link.diagnosis.isHealthy()) << link.address << ": " << link.diagnosis.text();
        if (link.kind == LinkKind::Can) {
            ASSERT_EQ(link.traffic->newest(), received + sent) << link.address;
        }
    }
}

void HourBench::checkDevice(const DeviceView &device)
{
    for (std::uint16_t i = 0; i < device.telemetry->channels().size(); ++i) {
        const auto gaps = device.telemetry->gaps({i}, Instant{}, Instant::max());
        ASSERT_EQ(device.telemetry->lost({i}), 0U)
            << device.selector << ' ' << device.telemetry->channels()[i].key << ", the last from "
            << std::chrono::duration<double>(gaps.back().from.time_since_epoch()).count() << " s to "
            << std::chrono::duration<double>(gaps.back().to.time_since_epoch()).count() << " s";
    }
    ASSERT_TRUE(device.liveness.faults.empty()) << device.selector << ' ' << device.liveness.faults.front();
    ASSERT_FALSE(device.liveness.foreignMaster) << device.selector;
    ASSERT_FALSE(device.liveness.restarted) << device.selector;
}

/// Every line that was due, and no other.
void HourBench::checkLog()
{
    for (const std::string &line : m_lines)
        ASSERT_EQ(m_lines.count(line), m_due.count(line)) << line;
    for (const std::string &line : m_due)
        ASSERT_EQ(m_lines.count(line), m_due.count(line)) << line;
    m_lines.clear();
    m_due.clear();
}

void HourBench::expect(const DeviceView &device, const std::string &line)
{
    m_due.insert(std::string(device.family->title) + " #" + std::to_string(device.identity->address) + ": " + line);
}

std::set<std::string> HourBench::rows()
{
    std::set<std::string> all;
    for (const DeviceView &device : m_core.snapshot().devices)
        all.insert(device.selector + ' ' + device.identity->dialect + ' '
            + std::string(toString(device.identity->state)) + (device.liveness.heard ? " heard" : ""));
    return all;
}

std::uint64_t HourBench::samples()
{
    std::uint64_t all = m_samplesBefore;
    for (const Device *device : m_core.session().devices()) {
        for (std::uint16_t i = 0; i < device->telemetry()->channels().size(); ++i)
            all += device->telemetry()->size({i});
    }
    return all;
}

int HourBench::number(std::int64_t least, std::int64_t most)
{
    return std::uniform_int_distribution<int>(static_cast<int>(least), static_cast<int>(most))(m_random);
}

template <class Fits> DeviceView HourBench::drawn(Fits fits)
{
    std::vector<DeviceView> fitting;
    for (DeviceView &device : m_core.snapshot().devices) {
        if (fits(device))
            fitting.push_back(std::move(device));
    }
    EXPECT_FALSE(fitting.empty());
    return fitting.at(static_cast<std::size_t>(number(0, std::ssize(fitting) - 1)));
}

} // namespace mb::test
