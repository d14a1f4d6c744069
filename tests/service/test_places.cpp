// SPDX-License-Identifier: GPL-3.0-or-later
// Units without a serial number: another one may stand in the same place. In virtual time.
#include "servicebench.h"

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::ServiceBooks;
using test::UnitRack;

class UnitsByPlace : public testing::Test {
protected:
    RecipeMatter load(const UnitRack &rack, const QByteArray &recipe, const QByteArray &parameters = {})
    {
        books.emplace(rack.clock);
        books->write("recipe.json", recipe);
        books->write("base.json", parameters);
        auto matter = loadRecipe(books->path("recipe.json"), rack.list());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? *matter : RecipeMatter{};
    }
    static QueueOptions units(int count, const std::string &run = {})
    {
        QueueOptions options;
        options.units = count;
        options.run = run;
        return options;
    }
    /// The bus is empty for long enough, then this one is on it.
    static void exchangeFor(UnitRack &rack, std::optional<std::size_t> place)
    {
        rack.putOn(std::nullopt);
        rack.clock.advance(4s);
        rack.putOn(place);
    }
    static bool waitFor(UnitRack &rack, QueueRun &run, int ended)
    {
        return rack.clock.runUntil([&] { return run.queue.counts().ended() >= ended; }, 3min);
    }
    std::optional<ServiceBooks> books;
};

const QByteArray driveRecipe
    = R"({"recipe":1,"name":"drives","family":"abstractdc","parameters":{"file":"base.json","store":true}})";
const QByteArray driveGains
    = R"({"family":"abstractdc","parameters":{"velocity.p":{"raw":77},"velocity.i":{"raw":5}}})";

TEST_F(UnitsByPlace, GainsThatCannotBeReadAreWrittenToTheNextUnitInThePlaceToo)
{
    UnitRack rack({"abstractdc:3", "abstractdc:3"});
    std::vector<std::size_t> saved;
    std::vector<Subscription> events;
    for (std::size_t i = 0; i < 2; ++i)
        events.push_back(rack.unit(i).events().add([&saved, i](const SimulatorEvent &event) {
            if (event.what == "settings-saved")
                saved.push_back(i);
        }));
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, driveRecipe, driveGains), units(2));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    exchangeFor(rack, 1);
    ASSERT_TRUE(waitFor(rack, run, 2));
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 2U);
    for (const Visit &visit : visits) {
        EXPECT_EQ(visit.outcome, Outcome::Passed) << visit.cause.english();
        const std::string &evidence = visit.evidence.english();
        EXPECT_NE(evidence.find("2 of 2 settings written"), std::string::npos) << evidence;
        EXPECT_NE(evidence.find("2 settings were written and cannot be read back"), std::string::npos) << evidence;
        EXPECT_EQ(evidence.find("proof: read back"), std::string::npos) << evidence;
        EXPECT_EQ(visit.parameters, 0) << "none was read back";
    }
    EXPECT_EQ(saved, (std::vector<std::size_t>{0, 1})) << "each has them in its flash";
}

} // namespace
} // namespace mb::service
