// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/result.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

class QSocketNotifier;
struct gpiod_chip;
struct gpiod_line;

namespace mb {

/// A line of a chip of this computer.
struct GpioLineListing {
    std::string name;  ///< "gpiochip0:25"
    std::string label; ///< what the system calls it, "GPIO25"; empty when it has no name
    bool used = false; ///< another program or a driver has it
};
/// Lines of all chips that this user may open, by chip and number. Opens chips, requests no line.
[[nodiscard]] std::vector<GpioLineListing> gpioLines();

/// One GPIO line, named CHIP:LINE as in `gpiochip0:25`, through libgpiod 1.6. Tested on lines that a test plays: no machine of ours has one.
class GpioLine : NonCopyable {
public:
    GpioLine();
    ~GpioLine();

    /// `changed` hears every edge, from the event loop of this thread.
    [[nodiscard]] Result<void> openInput(std::string_view name, std::function<void(bool level)> changed);
    /// Open drain, released.
    [[nodiscard]] Result<void> openOpenDrain(std::string_view name);
    void close();
    [[nodiscard]] bool isOpen() const { return m_line != nullptr; }
    [[nodiscard]] bool level() const;
    /// Of an output: false pulls it low.
    void set(bool released);

private:
    [[nodiscard]] Result<void> find(std::string_view name);
    void takeEvent();

    gpiod_chip *m_chip = nullptr;
    gpiod_line *m_line = nullptr;
    std::function<void(bool)> m_changed;
    std::unique_ptr<QSocketNotifier> m_events;
};

} // namespace mb
