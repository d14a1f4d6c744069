// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/listeners.h"
#include "async/noncopyable.h"
#include "async/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mb {

/// What can be made to go wrong with a simulated unit or link.
enum class FaultKind {
    Drop,
    Corrupt,
    Delay,
    Silent,
    Power,
    PowerPage,
    Reset,
    BusOff,
    EncoderDead,
    EncoderReversed,
    Brownout,
    Stall,
    Duplicate
};

/// Its word in the notation.
[[nodiscard]] std::string_view toString(FaultKind kind);

/// A fault on demand, docs/names.md#simulated-faults: `drop@3`, `delay@7:50`, `encoder-reversed`.
struct SimulatedFault {
    FaultKind kind = FaultKind::Drop;
    double at = 0.0;       ///< frame number from 1, page, or seconds after the start, by kind
    double argument = 0.0; ///< milliseconds of `delay`

    [[nodiscard]] static Result<SimulatedFault> parse(std::string_view text);
};

/// `FAMILY:ADDRESS[,option=value…]`, the notation of `simulate`.
struct SimulatedUnit {
    std::string family;
    int address = 0;
    std::vector<std::pair<std::string, std::string>> options; ///< without faults
    std::vector<SimulatedFault> faults;
    std::uint64_t seed = 1;

    [[nodiscard]] static Result<SimulatedUnit> parse(std::string_view text);
    [[nodiscard]] std::optional<std::string_view> option(std::string_view key) const;
};

/// Something a test or a bench operator wants to know of a simulated device, with the time it happened.
struct SimulatorEvent {
    Instant time{};
    std::string
        what; ///< output-on, output-off, halted, fault, reset, bootloader, application, flash-page, power-lost, gains-written …
    double value = 0.0;
};

/// A simulated controller: decodes requests and encodes replies on the link it was made for. Lives on the link's thread.
class Simulator : NonCopyable {
public:
    virtual ~Simulator() = default;

    [[nodiscard]] virtual std::string name() const = 0; ///< "dmc60c:5"
    /// Addresses of the links that it serves besides the one it was made for.
    [[nodiscard]] virtual std::vector<std::string> otherLinks() const { return {}; }
    /// Whether the bridge drives the motor now.
    [[nodiscard]] virtual bool isOutputOn() const = 0;
    /// Shaft speed, counts/s, and position, counts, of the motor itself (not of its sensor).
    [[nodiscard]] virtual double speed() const = 0;
    [[nodiscard]] virtual double position() const = 0;
    /// A, through the motor itself (not of its sensor); nothing where no current loop is simulated.
    [[nodiscard]] virtual std::optional<double> current() const { return std::nullopt; }
    /// Takes the supply away, or gives it back: RAM is lost, flash stays as it was at that moment.
    virtual void setPowered(bool powered) = 0;
    /// What its program memory holds now, from the first byte of the application on, as an update brings it; empty where no
    /// memory is simulated. Bytes that nothing can read back are 0.
    [[nodiscard]] virtual std::vector<std::uint8_t> flash() const { return {}; }
    /// What a service technician could change: "load-torque", "stall", "bus-voltage"; false when there is no such thing.
    virtual bool disturb(std::string_view what, double value) = 0;
    /// The raw number of a gain that its loop runs with, by the key of its table: of a unit whose wire cannot tell it; else nothing.
    [[nodiscard]] virtual std::optional<std::int64_t> gain(std::string_view) const { return std::nullopt; }

    [[nodiscard]] Listeners<const SimulatorEvent &> &events() { return m_events; }

protected:
    void emitEvent(Instant time, std::string what, double value = 0.0)
    {
        m_events.notify(SimulatorEvent{time, std::move(what), value});
    }

private:
    Listeners<const SimulatorEvent &> m_events;
};

} // namespace mb
