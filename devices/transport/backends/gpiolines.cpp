// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows libgpiod (1.6; 2.x has another interface).
#include "transport/backends/gpiolines.h"

#include "wire/number.h"

#include <QSocketNotifier>

#include <cerrno>
#include <cstring>
#include <optional>
#include <string>

#include <gpiod.h>

namespace mb {
namespace {

constexpr const char *consumer = "motorbench";

Error causeOf(int error, const std::string &name)
{
    switch (error) {
    case ENOENT:
        return {Fault::LinkLost, say("there is no GPIO chip for %1", name), say("gpiodetect lists those there are"), {},
            Ailment::NotThere};
    case EACCES:
        return {Fault::LinkLost, say("no permission to use %1", name), say("become a member of its group"),
            "sudo usermod -aG gpio $USER", Ailment::NoPermission};
    case EBUSY:
        return {Fault::LinkLost, say("GPIO line %1 is used by another program or driver", name), {}, {}, Ailment::Busy};
    default: return {Fault::LinkLost, say("GPIO line %1: %2", name, std::strerror(error))};
    }
}

} // namespace

std::vector<GpioLineListing> gpioLines()
{
    std::vector<GpioLineListing> lines;
    gpiod_chip_iter *chips = gpiod_chip_iter_new();
    if (!chips) // no chip, or none that may be opened
        return lines;
    for (gpiod_chip *chip = gpiod_chip_iter_next(chips); chip; chip = gpiod_chip_iter_next(chips)) {
        for (unsigned number = 0; number < gpiod_chip_num_lines(chip); ++number) {
            gpiod_line *line = gpiod_chip_get_line(chip, number);
            if (!line)
                continue;
            const char *label = gpiod_line_name(line);
            lines.push_back({std::string(gpiod_chip_name(chip)) + ':' + std::to_string(number), label ? label : "",
                gpiod_line_is_used(line)});
        }
    }
    gpiod_chip_iter_free(chips);
    return lines;
}

GpioLine::GpioLine() = default;

GpioLine::~GpioLine()
{
    close();
}

Result<void> GpioLine::find(std::string_view name)
{
    const auto colon = name.rfind(':');
    const auto number = colon == std::string_view::npos ? std::nullopt : wholeFrom<unsigned>(name.substr(colon + 1));
    if (!number)
        return fail(Fault::OutOfRange, say("a GPIO line is CHIP:LINE, as in gpiochip0:25, not '%1'", name));
    m_chip = gpiod_chip_open_lookup(std::string(name.substr(0, colon)).c_str());
    if (!m_chip)
        return fail(causeOf(errno, std::string(name)));
    m_line = gpiod_chip_get_line(m_chip, *number);
    if (!m_line) {
        const int error = errno;
        close();
        return fail(causeOf(error, std::string(name)));
    }
    return {};
}

Result<void> GpioLine::openInput(std::string_view name, std::function<void(bool)> changed)
{
    MB_TRY_VOID(find(name));
    if (gpiod_line_request_both_edges_events(m_line, consumer) != 0) {
        const int error = errno;
        close();
        return fail(causeOf(error, std::string(name)));
    }
    m_changed = std::move(changed);
    m_events = std::make_unique<QSocketNotifier>(gpiod_line_event_get_fd(m_line), QSocketNotifier::Read);
    QObject::connect(m_events.get(), &QSocketNotifier::activated, m_events.get(), [this] { takeEvent(); });
    return {};
}

Result<void> GpioLine::openOpenDrain(std::string_view name)
{
    MB_TRY_VOID(find(name));
    if (gpiod_line_request_output_flags(m_line, consumer, GPIOD_LINE_REQUEST_FLAG_OPEN_DRAIN, 1) != 0) {
        const int error = errno;
        close();
        return fail(causeOf(error, std::string(name)));
    }
    return {};
}

void GpioLine::close()
{
    m_events.reset();
    m_changed = nullptr;
    if (m_line)
        gpiod_line_release(std::exchange(m_line, nullptr));
    if (m_chip)
        gpiod_chip_close(std::exchange(m_chip, nullptr));
}

bool GpioLine::level() const
{
    return m_line && gpiod_line_get_value(m_line) == 1;
}

void GpioLine::set(bool released)
{
    if (m_line)
        gpiod_line_set_value(m_line, released ? 1 : 0);
}

void GpioLine::takeEvent()
{
    gpiod_line_event event{};
    if (gpiod_line_event_read(m_line, &event) == 0)
        m_changed(level()); // the level of now: edges may have gathered
}

} // namespace mb
