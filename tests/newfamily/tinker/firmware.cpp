// SPDX-License-Identifier: GPL-3.0-or-later
#include "tinker/firmware.h"

#include "model/device.h"
#include "tinker/codec.h"
#include "transport/exchange.h"
#include "wire/bytes.h"

#include <QtGlobal>

#include <array>

namespace mb::tinker {
namespace {

constexpr std::array<std::string_view, 1> layers{R"svg(
<circle cx="40" cy="40" r="30" fill="{control}" stroke="{outline}" stroke-width="2"/>
<line x1="40" y1="40" x2="62" y2="18" stroke="{accent}" stroke-width="4"/>
<text x="90" y="44" font-size="11" fill="{text}">{0}</text>
)svg"};
constexpr std::array<std::string_view, 1> words{QT_TRANSLATE_NOOP("table", "tinkered handle")};
constexpr Drawing handle{.width = 160,
    .height = 80,
    .layers = layers,
    .words = words,
    .description = QT_TRANSLATE_NOOP("table", "Drawing: a tinkered handle")};

constexpr std::array<GuidedStep, 2> steps{{
    {QT_TRANSLATE_NOOP("table", "Turn the tinkered handle"),
        QT_TRANSLATE_NOOP("table", "To the right, until it clicks."), &handle},
    {QT_TRANSLATE_NOOP("table", "The tinkered file is sent"), QT_TRANSLATE_NOOP("table", "Four bytes at a time.")},
}};
constexpr std::array routeTable{UpdateRoute{.scheme = "handle",
    .example = "handle:right",
    .steps = steps,
    .words = {.cancel = QT_TRANSLATE_NOOP("table", "The tinkered loader then waits"),
        .critical = QT_TRANSLATE_NOOP("table", "The tinkered program is begun"),
        .cut = QT_TRANSLATE_NOOP("table", "A tinkered unit that is cut waits in its loader."),
        .silent = QT_TRANSLATE_NOOP("table", "turn the tinkered handle back")}}};

/// Sends until the unit says that it has it.
Task<void> deliver(Device &device, CanFrame frame, std::uint16_t at)
{
    CanInbox::Match match = [unit = device.identity().address, at](const CanFrame &reply) {
        return isFrom(reply, Message::Loaded, unit, 2) && readU16le(reply.data, 0) == at;
    };
    auto asking = exchange(static_cast<CanLink &>(device.link()), device.clock(), frame, std::move(match), {});
    const CanFrame reply = co_await std::move(asking);
    (void)reply;
    co_return {};
}

} // namespace

std::span<const UpdateRoute> routes()
{
    return routeTable;
}

Result<ImageSummary> inspect(const FirmwareImage &image)
{
    if (!image.has(0) || !image.has(1) || image.hasAny(programSize, 0xFFFFFFFF))
        return fail(Fault::OutOfRange, say("it is no program of this unit"));
    ImageSummary summary;
    summary.version = std::to_string(*image.at(0)) + '.' + std::to_string(*image.at(1));
    summary.parts = {0, 1};
    return summary;
}

Task<UpdateReport> update(Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress)
{
    const auto summary = inspect(image);
    if (!summary)
        co_return fail(summary.error());
    if (!options.via.starts_with("handle:"))
        co_return fail(Fault::Usage, say("turn the handle and say so"), say("--via handle:right"));
    UpdateReport report;
    report.from = device.identity().firmware;
    const int unit = device.identity().address;
    progress.part(0, PartState::Active);
    co_await deliver(device, ask(Message::Load, unit), wholeProgram);
    progress.part(0, PartState::Done);
    progress.part(1, PartState::Active);
    const auto bytes = static_cast<int>(image.byteCount());
    int sent = 0;
    for (std::uint32_t at = 0; at < programSize; at += pieceSize) {
        if (!image.hasAny(at, at + pieceSize - 1))
            continue;
        std::array<std::uint8_t, pieceSize> four{};
        image.overlay(at, four);
        const auto place = static_cast<std::uint16_t>(at);
        co_await deliver(device, piece(unit, place, four), place);
        progress.step(say("sending"), sent += pieceSize, bytes);
    }
    co_await deliver(device, ask(Message::Run, unit), wholeProgram);
    co_await device.refresh();
    report.to = device.identity().firmware;
    report.verified = report.to == summary->version;
    report.outcome = report.verified ? UpdateOutcome::Done : UpdateOutcome::Failed;
    report.evidence = say("it says that it is %1", report.to);
    progress.part(1, PartState::Done);
    co_return report;
}

} // namespace mb::tinker
