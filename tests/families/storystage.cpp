// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/storystage.h"

#include "traffic/trafficline.h"
#include "transport/backends/virtualspi.h"
#include "wire/canframe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace mb::test {
namespace {

std::string nameOf(const Device &device)
{
    return std::string(device.family().key) + ':' + std::to_string(device.identity().address);
}

std::string entryText(const ParameterStore::Entry &entry)
{
    return (entry.raw ? std::to_string(*entry.raw) : std::string("?")) + ' ' + std::string(toString(entry.state));
}

std::string arrow(Direction direction)
{
    return direction == Direction::Sent ? "> " : "< ";
}

/// The message alone, for sums.
std::string kindOf(Direction direction, const DecodedFrame *frame)
{
    return arrow(direction) + (frame ? std::string(frame->message) : std::string("unknown"));
}

} // namespace

/// What a job says of itself.
class StoryStage::ToldProgress final : public Progress {
public:
    explicit ToldProgress(StoryStage &stage)
        : m_stage(stage)
    {
    }
    void step(const Message &what, int done, int total) override
    {
        m_stage.event("step",
            m_stage.stamp() + "step " + std::to_string(done) + '/' + std::to_string(total) + ' ' + what.english());
    }
    void part(int number, PartState state) override
    {
        m_stage.event("part", m_stage.stamp() + "part " + std::to_string(number) + ' ' + std::string(textOf(state)));
    }
    void log(Severity severity, const Message &text) override
    {
        m_stage.event("log", m_stage.stamp() + "log " + severityText(severity) + ": " + text.english());
    }
    void mayInterrupt(bool may) override
    {
        m_stage.event("interrupt", m_stage.stamp() + (may ? "may be interrupted" : "must not be interrupted"));
    }

private:
    StoryStage &m_stage;
};

class StoryStage::Finds final : public ScanSink {
public:
    Finds(StoryStage &stage, ScanExtent extent, std::vector<Identity> remembered)
        : m_stage(stage)
        , m_extent(extent)
        , m_remembered(std::move(remembered))
    {
    }
    void found(const Identity &identity) override
    {
        m_stage.event("found", m_stage.stamp() + "found " + textOf(identity));
        const auto same = std::find_if(rows.begin(), rows.end(), [&identity](const Identity &row) {
            return row.family == identity.family && row.address == identity.address && row.session == identity.session;
        });
        if (same == rows.end())
            rows.push_back(identity);
        else
            *same = identity;
    }
    void progress(const Message &what, int done, int total) override { m_stage.progress().step(what, done, total); }
    [[nodiscard]] std::vector<Identity> remembered() const override { return m_remembered; }
    [[nodiscard]] std::vector<Identity> known() const override
    {
        std::vector<Identity> all;
        for (const StoryDevice &on : m_stage.m_devices)
            all.push_back(on.device->identity());
        return all;
    }
    [[nodiscard]] ScanExtent extent() const override { return m_extent; }
    std::vector<Identity> rows;

private:
    StoryStage &m_stage;
    ScanExtent m_extent;
    std::vector<Identity> m_remembered;
};

StoryStage::StoryStage(Conversation &told, std::string_view link, std::uint64_t seed)
    : m_told(told)
    , m_address(*LinkAddress::parse(link))
    , m_progress(std::make_unique<ToldProgress>(*this))
    , m_seed(seed)
{
    int bitrate = 0;
    for (const auto &[key, value] : m_address.options)
        bitrate = key == "bitrate" ? std::stoi(value) : bitrate;
    m_bus = std::move(*makeSimulatedBus(kindOf(m_address), clock, bitrate, seed));
    for (const Family *family : families()) {
        if (std::find(family->links.begin(), family->links.end(), kindOf(m_address)) == family->links.end())
            continue;
        m_families.push_back(family);
        if (family->followCan)
            m_canDecoders.push_back(family->followCan({}));
        else if (family->decodeCan)
            m_canDecoders.push_back([family](const CanFrame &frame) { return family->decodeCan(frame, {}); });
        if (family->decodeBytes)
            m_byteDecoders.push_back(family->decodeBytes({}));
    }
    clock.advance(std::chrono::seconds(1)); // an instant of 0 is "never" in some places
}

StoryStage::~StoryStage()
{
    while (!m_devices.empty())
        close(*m_devices.back().device);
    flushSamples();
    m_taps.clear();
    m_host.reset(); // it lets go of the boards, which are ends of the same bus
}

Simulator &StoryStage::unit(std::string_view notation)
{
    auto parsed = SimulatedUnit::parse(notation);
    EXPECT_TRUE(parsed) << notation;
    parsed->seed = m_seed * 1000 + m_units.size();
    m_ends.push_back(m_bus->makeEnd(m_address));
    EXPECT_TRUE(m_ends.back()->open());
    auto made = findFamily(families(), parsed->family)->simulate(*m_ends.back(), clock, *parsed);
    EXPECT_TRUE(made) << (made ? "" : made.error().text());
    m_units.push_back(std::move(*made));
    Simulator &simulator = *m_units.back();
    m_taps.push_back(simulator.events().add([this, name = simulator.name()](const SimulatorEvent &event) {
        if (event.what == "gains-written") // as the line before says
            return;
        this->event(event.what, stamp() + "unit " + name + ' ' + event.what + ' ' + numberOf(event.value));
    }));
    return simulator;
}

Link &StoryStage::host()
{
    if (!m_host) {
        m_host = m_bus->makeHost(m_address);
        EXPECT_TRUE(m_host->open());
        m_taps.push_back(m_host->traffic().add([this](const Traffic &traffic) { passed(traffic); }));
        m_taps.push_back(m_host->stateChanged().add([this](LinkState state) {
            constexpr std::array<const char *, 3> names{"closed", "open", "lost"};
            event("link", stamp() + "link " + names.at(static_cast<std::size_t>(state)));
        }));
    }
    return *m_host;
}

Link &StoryStage::other()
{
    (void)host();
    m_ends.push_back(m_bus->makeEnd(m_address));
    EXPECT_TRUE(m_ends.back()->open());
    return *m_ends.back();
}

void StoryStage::setLoss(double fraction)
{
    m_bus->setLoss(fraction);
    if (auto *const spi = dynamic_cast<VirtualSpiLink *>(m_host.get()))
        spi->setLoss(fraction); // the bus tells it once only
}

void StoryStage::tear(const Hole &hole)
{
    m_hole = hole;
}

void StoryStage::countForHole()
{
    if (m_hole.piece == 0 || --m_hole.piece != 0)
        return;
    const auto open = [this] {
        setLoss(1.0);
        m_loss.startIn(m_hole.time, [this] { setLoss(0.0); });
    };
    if (m_hole.after == Duration::zero())
        open();
    else
        m_loss.startIn(m_hole.after, open);
}

std::vector<Identity> StoryStage::scan(ScanExtent extent, std::vector<Identity> remembered)
{
    heading("scan");
    Finds finds(*this, extent, std::move(remembered));
    const Instant begun = clock.now();
    std::vector<Task<void>> tasks;
    for (const Family *family : m_families)
        tasks.push_back(family->scan(host(), clock, finds));
    for (Task<void> &task : tasks)
        task.start();
    const auto ended = [&tasks] {
        return std::all_of(tasks.begin(), tasks.end(), [](const Task<void> &task) { return task.isFinished(); });
    };
    (void)clock.runUntil(ended, std::chrono::minutes(10));
    for (Task<void> &task : tasks)
        outcome(task.isFinished() ? resultText(task.result()) : std::string("it does not end"));
    for (const Identity &row : finds.rows)
        outcome(textOf(row));
    outcome("scanned for " + secondsOf(clock.now() - begun));
    return finds.rows;
}

std::vector<Identity> StoryStage::probe(std::string_view family, int address)
{
    Finds finds(*this, ScanExtent::Quick, {});
    (void)perform(
        "probe " + std::to_string(address), findFamily(families(), family)->probe(host(), clock, address, finds));
    for (const Identity &row : finds.rows)
        outcome(textOf(row));
    return finds.rows;
}

Device &StoryStage::open(const Identity &identity)
{
    heading("open " + textOf(identity));
    StoryDevice &on = m_devices.emplace_back();
    on.device = findFamily(families(), identity.family)->open(host(), clock, identity);
    EXPECT_TRUE(on.device);
    Device &device = *on.device;
    on.known.assign(device.parameters().entries().begin(), device.parameters().entries().end());
    on.identity = textOf(identity);
    on.subscriptions.push_back(
        device.telemetry()->samples().add([this, &on](const Sample &sample) { heard(on, sample); }));
    on.subscriptions.push_back(device.changed().add([this, &on] { look(on); }));
    on.subscriptions.push_back(device.statesChanged().add([this, &on](Instant) { look(on); }));
    on.subscriptions.push_back(device.parameters().changed().add([this, &on] { lookAtStore(on); }));
    on.subscriptions.push_back(device.knowledge().changed().add([this, &device] {
        event("profile", stamp() + nameOf(device) + " profile " + textOf(device.knowledge().profile()));
    }));
    on.subscriptions.push_back(device.stopping().changed().add([this, &device] {
        event("stop",
            stamp() + nameOf(device) + " stop: " + std::string(textOf(device.stopping().state()))
                + (device.stopping().mayTurn() ? ", may turn" : "") + (device.stopping().isDue() ? ", due" : ""));
    }));
    look(on);
    return device;
}

void StoryStage::close(Device &device)
{
    flushSamples();
    const auto on = std::find_if(
        m_devices.begin(), m_devices.end(), [&device](const StoryDevice &one) { return one.device.get() == &device; });
    on->subscriptions.clear();
    on->stream.reset();
    m_devices.erase(on);
}

SetPointStream &StoryStage::stream(Device &device)
{
    const auto on = std::find_if(
        m_devices.begin(), m_devices.end(), [&device](const StoryDevice &one) { return one.device.get() == &device; });
    if (!on->stream) {
        on->stream = std::make_unique<SetPointStream>(device, clock);
        on->subscriptions.push_back(on->stream->changed().add([this, &device, stream = on->stream.get()] {
            event("stream", stamp() + nameOf(device) + " stream " + textOf(*stream));
        }));
    }
    return *on->stream;
}

void StoryStage::advance(Duration time)
{
    clock.advance(time);
    flushSamples();
}

void StoryStage::sum(const std::function<void()> &meanwhile)
{
    flushSamples();
    m_told.beginSum();
    meanwhile();
    flushSamples();
    m_told.endSum();
}

Progress &StoryStage::progress()
{
    return *m_progress;
}

void StoryStage::outcome(const std::string &text)
{
    tell(stamp() + "=> " + text);
    m_outcomes += (m_outcomes.empty() ? "" : "; ") + text;
}

void StoryStage::tellTelemetry()
{
    for (StoryDevice &on : m_devices) {
        Telemetry &telemetry = *on.device->telemetry();
        telemetry.commit();
        for (std::uint16_t i = 0; i < telemetry.channels().size(); ++i) {
            const auto latest = telemetry.latest({i});
            if (!latest && telemetry.lost({i}) == 0)
                continue;
            const std::size_t gaps = telemetry.gaps({i}, Instant{}, clock.now()).size();
            tell("   " + nameOf(*on.device) + ' ' + std::string(telemetry.channels()[i].key) + ": "
                + std::to_string(telemetry.size({i})) + " samples, " + std::to_string(telemetry.lost({i})) + " lost, "
                + std::to_string(gaps) + " gaps, " + numberOf(telemetry.rate({i}, on.device->clock().now()))
                + " Hz, last " + (latest ? numberOf(latest->value) : std::string("none"))
                + std::string(telemetry.channels()[i].unit));
        }
    }
}

void StoryStage::tellStopScript(const Device &device)
{
    for (const StopStep &step : device.stopScript().steps) {
        std::string line = "   stop step:";
        if (step.frame)
            line += " frame " + toText(*step.frame);
        if (!step.bytes.empty())
            line += " bytes " + hexText(step.bytes);
        if (step.replyFrame)
            line += " answer " + toText(*step.replyFrame);
        if (!step.reply.empty())
            line += " answer " + hexText(step.reply);
        tell(line + " wait " + std::to_string(step.wait.count()) + " ms, " + std::to_string(step.attempts) + " times");
    }
}

void StoryStage::tell(std::string line)
{
    flushSamples();
    m_told.tell(std::move(line));
}

void StoryStage::event(const std::string &kind, const std::string &line)
{
    flushSamples();
    m_told.event(kind, line);
}

void StoryStage::flushSamples()
{
    if (!m_samples.empty())
        m_told.event("samples", std::exchange(m_samples, {}));
}

void StoryStage::passed(const Traffic &traffic)
{
    if (traffic.direction == Direction::Sent)
        countForHole();
    const std::string when = secondsOf(traffic.time.time_since_epoch()) + ' ' + arrow(traffic.direction);
    if (traffic.can) {
        std::optional<DecodedFrame> decoded;
        for (const CanDecoder &decode : m_canDecoders) {
            auto one = decode(*traffic.can);
            if (one && !decoded)
                decoded = std::move(one);
        }
        event(kindOf(traffic.direction, decoded ? &*decoded : nullptr),
            when + toText(*traffic.can) + (decoded ? " | " + textOf(*decoded) : std::string()));
        return;
    }
    std::vector<DecodedBytes> found;
    for (const auto &decoder : m_byteDecoders)
        decoder->take(traffic.time.time_since_epoch(), traffic.direction, traffic.bytes, found);
    std::string text;
    for (const DecodedBytes &one : found)
        text += " | " + (one.frame ? textOf(*one.frame) : "none of its frames: " + hexText(one.bytes));
    event(kindOf(traffic.direction, found.empty() || !found.front().frame ? nullptr : &*found.front().frame),
        when + hexText(traffic.bytes) + text);
}

void StoryStage::heard(StoryDevice &on, const Sample &sample)
{
    const std::string begin = secondsOf(sample.time.time_since_epoch()) + " sample " + nameOf(*on.device) + ' ';
    if (!m_samples.starts_with(begin)) {
        flushSamples();
        m_samples = begin;
    }
    m_samples += ' ' + std::string(on.device->telemetry()->channels()[sample.channel.value].key) + '='
        + numberOf(sample.value);
}

void StoryStage::look(StoryDevice &on)
{
    const Device &device = *on.device;
    const std::string states = textOf(device.family().states, device.states());
    const std::string live = textOf(device.liveness()) + (states.empty() ? "" : " {" + states + '}');
    if (std::exchange(on.live, live) != live)
        event("device", stamp() + nameOf(device) + " is " + live);
    const std::string identity = textOf(device.identity());
    if (std::exchange(on.identity, identity) != identity)
        event("device", stamp() + "device " + identity);
}

void StoryStage::lookAtStore(StoryDevice &on)
{
    const auto entries = on.device->parameters().entries();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        ParameterStore::Entry &known = on.known[i];
        if (known.raw == entries[i].raw && known.state == entries[i].state)
            continue;
        known = entries[i];
        event("parameter",
            stamp() + nameOf(*on.device) + ' ' + std::string(on.device->parameters().table()[i].key) + " = "
                + entryText(known));
    }
}

void tellVariants(Conversation &told, const std::vector<std::string> &variants,
    const std::function<std::string(Conversation &, const std::string &variant)> &story)
{
    for (const std::string &variant : variants) {
        Conversation one;
        const std::string outcomes = story(one, variant);
        told.include(variant, one);
        told.tell(variant + ": " + outcomes + " [" + one.summary() + ']');
    }
}

} // namespace mb::test
