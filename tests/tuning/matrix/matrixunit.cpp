// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/matrixunit.h"

#include "experiment/gains.h"
#include "families/abstractdc/simulatoroptions.h"
#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/simulatoraxis.h"
#include "model/loopparameters.h"
#include "support/unitgains.h"

#include <algorithm>
#include <numbers>

namespace mb::test {
namespace {

constexpr double volts = 12.0;
constexpr int coarseCounts = 128; ///< of a turn, for boards that take 50 000 edges a second

struct Place {
    std::string_view family;
    const char *link;
    const char *unit;
    bool storesSeveral = false; ///< `gains=` as Cell::stored
};
constexpr std::array<Place, 4> places{{
    {"dmc60c", "sim:can", "dmc60c:5", true},
    {"abstractdc", "sim:can", "abstractdc:3,dialect=F", true},
    {"quadquad2drv", "sim:spi", "quadquad2drv:0"},
    {"supermodified", "sim:serial", "supermodified:4"},
}};

const Place &placeOf(std::string_view family)
{
    return *std::find_if(places.begin(), places.end(), [family](const Place &p) { return p.family == family; });
}

const Family &familyOf(std::string_view key)
{
    return **std::find_if(families().begin(), families().end(), [key](const Family *f) { return f->key == key; });
}

std::string textOf(const Cell &cell)
{
    const double load = std::max(1.0, usualLoad(cell.motor) * cell.loadFactor);
    const std::string dialect = cell.dialect.empty() ? "" : ",dialect=" + cell.dialect;
    const std::string stored = placeOf(cell.family).storesSeveral ? ",gains=" + cell.stored : "";
    return std::string(placeOf(cell.family).unit) + dialect + stored + ",motor=" + cell.motor
        + ",load=" + std::to_string(load);
}

/// The stored gains of an Abstract DC Drive by key, in the order in which they may be written: none of them can be read.
std::vector<std::pair<std::string, double>> storedGainsOf(const std::string &unit)
{
    using namespace abstractdc::simulation;
    std::vector<std::pair<std::string, double>> numbers;
    const auto options = UnitOptions::parse(*SimulatedUnit::parse(unit));
    EXPECT_TRUE(options) << unit;
    const auto stored = storedGains(*options);
    constexpr std::array<const char *, 3> loops{"velocity.", "current.", "position."};
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const Record &record = stored.at(i);
        for (const auto &[name, value] : {std::pair("divisor", record.divisor), std::pair("p", record.p),
                 std::pair("i", record.i), std::pair("d", record.d)})
            numbers.emplace_back(std::string(loops.at(i)) + name, value);
    }
    return numbers;
}

std::string linkOf(const Cell &cell, bool ideal)
{
    std::string link = std::string(placeOf(cell.family).link) + "?seed=" + std::to_string(cell.seed);
    if (!ideal && cell.around.loss > 0.0)
        link += "&loss=" + std::to_string(cell.around.loss);
    return link;
}

} // namespace

double usualLoad(const std::string &motor)
{
    if (motor.starts_with("cim"))
        return 9.0;
    return motor == "775pro" ? 7.0 : 5.0;
}

int countsOf(const Cell &cell)
{
    const int own = motorByName(cell.motor)->countsPerTurn;
    return cell.family == "quadquad2drv" ? std::min(own, coarseCounts) : own;
}

MatrixUnit::MatrixUnit(const Cell &cell, bool ideal)
    : m_cell(cell)
    , m_text(textOf(cell))
    , m_unit(m_text)
    , m_family(familyOf(cell.family))
    , m_list(&m_family)
    , m_session(m_clock, std::span(&m_list, 1))
    , m_random(cell.seed)
    , m_renewal(m_clock)
    , m_shaking(m_clock)
{
    m_family.bench = std::span(&m_unit, 1);
    const auto address = LinkAddress::parse(linkOf(cell, ideal));
    EXPECT_TRUE(address);
    const auto opened = m_session.openLink(*address);
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
    m_link = *opened;
    for (int attempt = 0; attempt < 5 && m_session.devices().empty(); ++attempt)
        (void)run(m_clock, m_session.scan(*m_link));
    EXPECT_FALSE(m_session.devices().empty()) << m_text;
    m_device = m_session.devices().front();
    m_clock.advance(std::chrono::milliseconds(300));
    disturb(cell.around);
    prepare();
    if (!ideal && cell.around.ripple > 0.0)
        shake();
    if (ideal && cell.family == "dmc60c") {
        EXPECT_TRUE(simulator().disturb("current-noise", 0.0));
    }
    renew();
}

Simulator &MatrixUnit::simulator()
{
    return *m_session.bench(*m_link)->simulators().front();
}

void MatrixUnit::write(std::string_view key, double number)
{
    const auto index = findParameter(m_device->parameters().table(), key);
    EXPECT_TRUE(run(m_clock, m_device->write(*index, *toRaw(m_device->parameters().parameter(*index), number)))) << key;
}

/// What a QuadQuad2Drv needs to know of itself first, and a board that may use most of its power. The gains of an Abstract DC Drive
/// are written once, as they are: who does not know what was there compares with nothing.
void MatrixUnit::prepare()
{
    if (m_cell.family == "abstractdc") {
        for (const auto &[key, number] : storedGainsOf(m_text))
            write(key, number);
    }
    if (m_cell.family != "quadquad2drv")
        return;
    using namespace quadquad2drv;
    using namespace quadquad2drv::simulation;
    const std::array<std::pair<std::string_view, double>, 5> scales{{{calibration::velocityP, gain::velocityP},
        {calibration::velocityI, gain::velocityI}, {calibration::positionP, gain::positionP},
        {calibration::positionI, gain::positionI}, {calibration::positionD, gain::positionD}}};
    for (const auto &[key, scale] : scales)
        EXPECT_TRUE(m_device->knowledge().calibrate(key, scale));
    for (const auto &[key, value] : {std::pair("ch1.limit.power", 0.8), std::pair("history.length", 8.0)})
        write(key, value);
}

void MatrixUnit::disturb(const Surroundings &around)
{
    EXPECT_TRUE(simulator().disturb("encoder-counts", countsOf(m_cell)));
    EXPECT_TRUE(simulator().disturb("bus-resistance", around.busResistance));
    EXPECT_TRUE(simulator().disturb("friction", around.friction));
    if (around.backlash > 0.0) {
        EXPECT_TRUE(simulator().disturb("backlash", around.backlash * 2.0 * std::numbers::pi / countsOf(m_cell)));
    }
}

void MatrixUnit::renew()
{
    stream().renew();
    m_renewal.startIn(std::chrono::milliseconds(100), [this] { renew(); });
}

void MatrixUnit::shake()
{
    m_shaking.startIn(std::chrono::milliseconds(5), [this] {
        std::normal_distribution<double> ripple(0.0, m_cell.around.ripple);
        (void)simulator().disturb("bus-voltage", volts * (1.0 + ripple(m_random)));
        shake();
    });
}

tuning::ExperimentSurroundings MatrixUnit::surroundings()
{
    tuning::ExperimentSurroundings around;
    around.journal = &m_journal;
    around.directions = &m_directions;
    around.interruption = &m_interruption;
    around.rate = m_cell.around.rate;
    around.note = [this, begin = m_clock.now()](const Message &text) {
        m_notes.emplace_back(std::chrono::duration<double>(m_clock.now() - begin).count(), text.english());
    };
    return around;
}

Result<tuning::TuneReport> MatrixUnit::tune(const tuning::TunePlan &plan)
{
    return run(m_clock, tuning::autotune(*m_device, stream(), plan, surroundings()), std::chrono::minutes(10));
}

std::vector<std::pair<std::string, std::optional<double>>> MatrixUnit::gains()
{
    return run(m_clock, tuning::readGains(*m_device, m_cell.loop, 1, 0))
        .value_or(std::vector<std::pair<std::string, std::optional<double>>>());
}

std::vector<std::pair<std::string, std::optional<std::int64_t>>> MatrixUnit::gainsInUnit()
{
    std::vector<std::pair<std::string, std::optional<std::int64_t>>> all;
    for (const LoopGains &loop : m_family.trials->loops) {
        for (int slot = 0; slot < m_family.capabilities.gainSlots; ++slot) {
            for (const ParameterIndex index : loopParameters(m_family, loop, 1, slot)) {
                const std::string key(m_family.parameters[index.value].key);
                all.emplace_back(key, rawInUnit(m_clock, *m_device, simulator(), key));
            }
        }
    }
    return all;
}

} // namespace mb::test
