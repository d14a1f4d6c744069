// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/virtualclock.h"
#include "families/conversation.h"
#include "families/storytext.h"
#include "model/registry.h"
#include "simulation/simulatedbus.h"

#include <functional>
#include <list>
#include <memory>
#include <string>
#include <string_view>

namespace mb::test {

/// One device of a story and everything that it publishes.
struct StoryDevice {
    std::unique_ptr<Device> device;
    std::unique_ptr<SetPointStream> stream;
    std::vector<ParameterStore::Entry> known; ///< as was told last
    std::string identity;                     ///< the same, as the next
    std::string live;
    std::vector<Subscription> subscriptions;
};

/// A bus in memory with simulated units and a host, on virtual time: what passes and what is published becomes a conversation.
class StoryStage {
public:
    /// `link` as in "sim:can?bitrate=500000".
    StoryStage(Conversation &told, std::string_view link, std::uint64_t seed = 1);
    StoryStage(const StoryStage &) = delete;
    StoryStage &operator=(const StoryStage &) = delete;
    ~StoryStage();

    /// Another unit on the bus; all of them before the host is asked for the first time.
    Simulator &unit(std::string_view notation);
    /// The program's end of the bus.
    Link &host();
    /// Another end, for somebody else's frames.
    Link &other();
    void setLoss(double fraction);
    /// Loses everything for `time`, so long `after` the program has sent its N-th piece from now.
    struct Hole {
        int piece = 0;
        Duration after{};
        Duration time{};
    };
    void tear(const Hole &hole);
    void pullHost() { m_bus->dropOut(host()); }

    /// All families that speak here look at once.
    std::vector<Identity> scan(ScanExtent extent = ScanExtent::Quick, std::vector<Identity> remembered = {});
    std::vector<Identity> probe(std::string_view family, int address);
    Device &open(const Identity &identity);
    void close(Device &device);
    SetPointStream &stream(Device &device);

    void heading(const std::string &what) { tell("-- " + what); }
    void advance(Duration time);
    /// What happens meanwhile is summed up.
    void sum(const std::function<void()> &meanwhile);
    void wait(Duration time)
    {
        sum([this, time] { clock.advance(time); });
    }
    /// Runs a task to its end and tells the result.
    template <class T>
    Result<T> perform(const std::string &what, Task<T> task, Duration limit = std::chrono::minutes(5))
    {
        heading(what);
        const Instant begun = clock.now();
        task.start();
        const bool ended = clock.runUntil([&task] { return task.isFinished(); }, limit);
        Result<T> result = ended ? std::move(task.result()) : fail(Fault::Cancelled, say("it does not end"));
        outcome(resultText(result) + " after " + secondsOf(clock.now() - begun));
        return result;
    }
    /// Cancels it after some time, as a person would.
    template <class T> void cut(const std::string &what, Task<T> task, Duration after)
    {
        heading(what + ", cut after " + secondsOf(after));
        task.start();
        advance(after);
        const bool ended = task.isFinished();
        outcome(ended ? resultText(task.result()) : std::string("cut"));
        task.cancel();
    }
    template <class T> void answer(const std::string &what, const Result<T> &result)
    {
        heading(what);
        outcome(resultText(result));
    }
    void outcome(const std::string &text);
    /// What every device has lost, and how often it hears what.
    void tellTelemetry();
    void tellStopScript(const Device &device);
    Progress &progress();
    /// Everything that was a result, since they were forgotten.
    [[nodiscard]] const std::string &outcomes() const { return m_outcomes; }
    void forgetOutcomes() { m_outcomes.clear(); }

    VirtualClock clock;

private:
    class ToldProgress;
    class Finds;
    void tell(std::string line);
    void event(const std::string &kind, const std::string &line);
    void flushSamples();
    void countForHole();
    void passed(const Traffic &traffic);
    void heard(StoryDevice &on, const Sample &sample);
    void look(StoryDevice &on);
    void lookAtStore(StoryDevice &on);
    [[nodiscard]] std::string stamp() const { return secondsOf(clock.now().time_since_epoch()) + ' '; }

    Conversation &m_told;
    LinkAddress m_address;
    std::unique_ptr<SimulatedBus> m_bus;
    std::vector<const Family *> m_families;
    std::vector<CanDecoder> m_canDecoders;
    std::vector<std::unique_ptr<ByteDecoder>> m_byteDecoders;
    std::unique_ptr<Link> m_host;
    std::list<std::unique_ptr<Link>> m_ends;
    std::vector<std::unique_ptr<Simulator>> m_units;
    std::vector<Subscription> m_taps;
    std::list<StoryDevice> m_devices;
    std::unique_ptr<ToldProgress> m_progress;
    std::string m_samples; ///< of one device at one time, not told yet
    std::string m_outcomes;
    std::uint64_t m_seed;
    Hole m_hole; ///< with the pieces that are still to be sent before it
    Timer m_loss{clock};
};

/// One line for each variant of a story: what it yields, how much was said, and the digest of all that.
void tellVariants(Conversation &told, const std::vector<std::string> &variants,
    const std::function<std::string(Conversation &, const std::string &variant)> &story);

} // namespace mb::test
