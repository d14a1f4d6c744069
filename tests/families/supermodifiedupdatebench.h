// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/avrdude.h"
#include "families/supermodified/firmware.h"
#include "families/supermodified/scan.h"
#include "families/supermodified/simulator.h"
#include "model/device.h"
#include "model/operation.h"
#include "model/registry.h"
#include "support/eventloop.h"
#include "transport/backends/virtualserial.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cstdlib>

namespace mb::supermodified {

using namespace std::chrono_literals;

// jmp 0x0040; rjmp .-2
inline constexpr std::string_view imageText = ":060000000C942000FFCF6C\n:00000001FF\n";

inline FirmwareImage image(std::string_view text = imageText)
{
    auto parsed = FirmwareImage::fromIntelHex(text);
    EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().text());
    return parsed.value_or(FirmwareImage{});
}

/// A node on a line in memory, in real time, and an `avrdude` of our own in PATH.
struct SupermodifiedUpdateBench {
    explicit SupermodifiedUpdateBench(const LinkAddress &at = *LinkAddress::parse("sim:serial?bitrate=115200"))
        : line(loop.clock(), VirtualSerialLine::Wiring::HalfDuplex, 1)
        , address(at)
        , host(address, line)
        , unit(address, line)
    {
        EXPECT_TRUE(host.open());
        EXPECT_TRUE(unit.open());
        simulator = std::move(*simulate(unit, loop.clock(), *SimulatedUnit::parse("supermodified:4")));
        Identity identity;
        identity.family = "supermodified";
        identity.address = 4;
        identity.dialect = "D1";
        for (const Family *family : families()) {
            if (family->key == "supermodified")
                device = family->open(host, loop.clock(), identity);
        }
        const char *const path = std::getenv("PATH");
        before = path ? path : "";
    }
    ~SupermodifiedUpdateBench() { ::setenv("PATH", before.c_str(), 1); }

    void standIn(const QByteArray &script)
    {
        QFile file(folder.filePath(QStringLiteral("avrdude")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("#!/bin/sh\necho \"$@\" >> " + folder.filePath(QStringLiteral("calls")).toUtf8() + "\n" + script);
        file.close();
        file.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
        ::setenv("PATH", (folder.path().toStdString() + ':' + before).c_str(), 1);
    }
    [[nodiscard]] QByteArray calls() const
    {
        QFile file(folder.filePath(QStringLiteral("calls")));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    Result<UpdateReport> update(const std::string &via, const std::function<void(Operation &)> &meanwhile = {})
    {
        Operation operation(loop.clock(), say("firmware update"));
        std::optional<Result<UpdateReport>> report;
        options.via = via;
        operation.run<UpdateReport>(supermodified::update(*device, written, options, operation),
            [&report](Result<UpdateReport> result) { report = std::move(result); });
        EXPECT_TRUE(loop.runUntil([&] {
            if (halts && isPowered)
                power(!isHeld(operation.status().step.english()));
            if (meanwhile)
                meanwhile(operation);
            return report.has_value();
        }));
        log = operation.status().log;
        interruptible = operation.status().mayInterrupt;
        return report.value_or(Result<UpdateReport>(fail(Fault::Timeout, say("still running"))));
    }

    /// A programmer on the pins keeps the processor in reset, and the bootloader is another program.
    [[nodiscard]] static bool isHeld(const std::string &step)
    {
        return step == "Erasing flash" || step == "Writing flash" || step == "Verifying flash";
    }
    void power(bool on)
    {
        if (on != runs)
            simulator->setPowered(on);
        runs = on;
    }
    void cut()
    {
        isPowered = false;
        power(false);
    }

    [[nodiscard]] bool has(const char *file) const { return QFile::exists(folder.filePath(QString::fromLatin1(file))); }
    [[nodiscard]] std::size_t positions() const
    {
        device->telemetry()->commit();
        return device->telemetry()->size(*findChannel(device->family().channels, "position"));
    }

    mb::test::EventLoop loop;
    VirtualSerialLine line;
    LinkAddress address;
    VirtualSerialLink host;
    VirtualSerialLink unit;
    std::unique_ptr<Simulator> simulator;
    std::unique_ptr<Device> device;
    FirmwareImage written = image();
    UpdateOptions options;
    QTemporaryDir folder;
    std::string before;
    std::vector<LogLine> log;
    bool interruptible = false; ///< at the end
    bool halts = true;          ///< the programmer sits on this node
    bool isPowered = true;
    bool runs = true;
};

inline constexpr const char *supermodifiedSuccess = R"(
bar() { printf "$1 | " >&2; i=0; while [ $i -lt 50 ]; do printf '#' >&2; i=$((i+1)); done; printf ' | 100%% 0.01s\n' >&2; }
echo "avrdude: AVR device initialized and ready to accept instructions" >&2
bar Reading
echo "avrdude: writing 6 bytes flash ..." >&2
bar Writing
echo "avrdude: 6 bytes of flash written" >&2
bar Reading
echo "avrdude: 6 bytes of flash verified" >&2
echo "avrdude done.  Thank you." >&2
)";

} // namespace mb::supermodified
