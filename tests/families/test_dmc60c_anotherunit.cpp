// SPDX-License-Identifier: GPL-3.0-or-later
// An update is of one unit: another one that answers under its number is neither flashed nor reported.
#include "families/dmc60c/updatecontact.h"
#include "families/dmc60ccontrollerfixture.h"
#include "model/registry.h"
#include "support/hextext.h"
#include "support/simulatedsession.h"

namespace mb::dmc60c {
namespace {

const std::string ownSerial = "2103343A79F2"; // that of `descriptors`
const FakeUnit::Frames own{"0206F005#341203012060", "0206F005#3412000017010901"};
const FakeUnit::Frames another{"0206F005#431203012060", "0206F005#4312000017010901"}; // session 0x1243
const std::string anotherDescriptors = "0206FC05#4312600000000000";
const FakeUnit::Frames otherSerial{"0206FCC5#00000E00", "0206FC85#060C323130333334", "0206FC85#303030303031"};

class Dmc60cAnother : public Dmc60cController {
protected:
    Result<UpdateContact::Unit> find(const std::string &serial)
    {
        Identity identity = identityOf5();
        identity.serial = serial;
        device->setIdentity(identity);
        UpdateContact contact(*device);
        return run(contact.findAgain(1s));
    }
};

TEST_F(Dmc60cAnother, TheSameUnitIsFoundAgainAfterItLostItsSupply)
{
    unit.answer(enumeration, {another}, 5ms);
    unit.answer(anotherDescriptors, {descriptors});
    const auto found = find(ownSerial);
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(device->identity().session, 0x1243);
}

TEST_F(Dmc60cAnother, AUnitWithAnotherSerialNumberIsNotTaken)
{
    unit.answer(enumeration, {another}, 5ms);
    unit.answer(anotherDescriptors, {otherSerial});
    const auto found = find(ownSerial);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().fault, Fault::Unsafe);
    EXPECT_NE(found.error().text().find("210334000001"), std::string::npos) << found.error().text();
    EXPECT_EQ(device->identity().session, 0x1234);
}

TEST_F(Dmc60cAnother, AUnitWithAnotherSerialNumberIsNotTakenThoughItsSessionWasAdopted)
{
    unit.answer(enumeration, {own}, 5ms);
    unit.answer(getDescriptors, {otherSerial});
    const auto found = find(ownSerial);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().fault, Fault::Unsafe);
}

TEST_F(Dmc60cAnother, WhereNoSerialNumberIsKnownTheSessionTells)
{
    unit.answer(enumeration, {another}, 5ms);
    unit.answer(anotherDescriptors, {descriptors});
    const auto found = find("");
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().fault, Fault::Unsafe);
    unit.answer(enumeration, {own}, 5ms);
    clock.advance(1s);
    const auto same = find("");
    EXPECT_TRUE(same) << same.error().text();
}

/// Two units of one number, of which one has power at a time.
struct Exchanged final : Progress {
    Exchanged()
        : bus(clock, 1'000'000, 1)
        , host(*LinkAddress::parse("sim:can"), bus)
        , port(*LinkAddress::parse("sim:can"), bus)
        , otherPort(*LinkAddress::parse("sim:can"), bus)
    {
        EXPECT_TRUE(host.open() && port.open() && otherPort.open());
        unit = std::move(
            *family.simulate(port, clock, *SimulatedUnit::parse("dmc60c:5,serial=210334000001,session=4660")));
        other = std::move(*family.simulate(
            otherPort, clock, *SimulatedUnit::parse("dmc60c:5,serial=210334000002,session=17185,firmware=1.25")));
        other->setPowered(false);
        events = other->events().add([this](const SimulatorEvent &event) {
            if (event.what == "page-written")
                ++pages;
        });
        struct Sink final : ScanSink {
            void found(const Identity &identity) override { last = identity; }
            void progress(const Message &, int, int) override { }
            std::optional<Identity> last;
        } sink;
        EXPECT_TRUE(test::run(clock, family.scan(host, clock, sink)));
        EXPECT_EQ(sink.last->serial, "210334000001");
        device = family.open(host, clock, *sink.last);
    }
    void exchange()
    {
        unit->setPowered(false);
        other->setPowered(true);
    }
    UpdateReport update(bool force)
    {
        const auto image = FirmwareImage::fromIntelHex(test::smallApplication(0x0119).text());
        UpdateOptions options;
        options.force = force;
        const auto report = test::run(clock, family.update(*device, *image, options, *this), 10min);
        EXPECT_TRUE(report);
        return report.value_or(UpdateReport{});
    }
    void step(const Message &what, int, int) override
    {
        if (what.english() == exchangeAt)
            exchange();
    }
    void part(int, PartState) override { }
    void log(Severity, const Message &) override { }

    VirtualClock clock;
    VirtualCanBus bus;
    VirtualCanLink host;
    VirtualCanLink port;
    VirtualCanLink otherPort;
    std::unique_ptr<Simulator> unit;
    std::unique_ptr<Simulator> other;
    Subscription events;
    std::string exchangeAt;
    int pages = 0;
    std::unique_ptr<Device> device;
};

TEST(Dmc60cExchanged, AUnitThatTookThePlaceAtTheRestartIsNotReportedUpdated)
{
    Exchanged bench;
    bench.exchangeAt = "Restart";
    const UpdateReport report = bench.update(false);
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_FALSE(report.verified);
    EXPECT_NE(report.evidence.english().find("210334000002"), std::string::npos) << report.evidence.english();
    EXPECT_EQ(bench.pages, 0);
}

TEST(Dmc60cExchanged, AUnitThatTookThePlaceBeforeTheUpdateIsNotFlashed)
{
    Exchanged bench;
    bench.exchange();
    bench.clock.advance(5s);
    const UpdateReport report = bench.update(true);
    EXPECT_EQ(report.outcome, UpdateOutcome::Refused);
    EXPECT_EQ(report.fault, Fault::Unsafe);
    EXPECT_NE(report.evidence.english().find("210334000002"), std::string::npos) << report.evidence.english();
    EXPECT_EQ(bench.pages, 0);
}

TEST(Dmc60cExchanged, AUnitThatTookThePlaceBetweenTwoPagesIsNotFlashed)
{
    Exchanged bench;
    bench.exchangeAt = "Page 0";
    const UpdateReport report = bench.update(false);
    EXPECT_EQ(report.outcome, UpdateOutcome::Failed);
    EXPECT_NE(report.evidence.english().find("210334000002"), std::string::npos) << report.evidence.english();
    EXPECT_EQ(bench.pages, 0);
}

} // namespace
} // namespace mb::dmc60c
