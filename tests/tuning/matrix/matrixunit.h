// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/bench.h"
#include "support/fakejournal.h"
#include "support/simulatedsession.h"
#include "tuning/autotune.h"

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace mb::test {

/// What a motor is tuned on in the matrix: everything that is not the same on every bench.
struct Surroundings {
    double rate = 0.0;           ///< samples per second; 0: what the family asks for
    double loss = 0.0;           ///< share of frames
    double ripple = 0.0;         ///< σ of the supply, share of its voltage
    double busResistance = 0.02; ///< Ohm, of battery and cables
    double friction = 1.0;       ///< times the motor's own
    double backlash = 0.0;       ///< counts
};

/// A cell of the matrix.
struct Cell {
    std::string family;
    std::string motor;
    Mode loop = Mode::Velocity;
    std::uint64_t seed = 1;
    double loadFactor = 1.0; ///< times the usual load of this motor
    Surroundings around;
    std::string dialect;              ///< of the unit's firmware; empty: the usual one
    std::string stored = "overshoot"; ///< gains that it has before, where it knows several: "tuned", "default"
};

/// The usual inertia of rotor and load over the rotor's own.
[[nodiscard]] double usualLoad(const std::string &motor);

/// Of the encoder that goes with motor and controller, of a rotor turn.
[[nodiscard]] int countsOf(const Cell &cell);

/// One simulated controller alone on a bench of its own, in virtual time.
class MatrixUnit {
public:
    /// The unit of a cell. `ideal`: without loss, ripple and noise of a sensor, which no two runs share.
    explicit MatrixUnit(const Cell &cell, bool ideal = false);

    [[nodiscard]] VirtualClock &clock() { return m_clock; }
    [[nodiscard]] Device &device() { return *m_device; }
    [[nodiscard]] Simulator &simulator();
    [[nodiscard]] SetPointStream &stream() { return m_session.stream(*m_device); }
    [[nodiscard]] Result<tuning::TuneReport> tune(const tuning::TunePlan &plan);
    [[nodiscard]] tuning::ExperimentSurroundings surroundings();
    /// Of the loop that the cell names, in the slot that is tuned; nothing for what cannot be read.
    [[nodiscard]] std::vector<std::pair<std::string, std::optional<double>>> gains();
    /// Those of every loop of its axis and slots as the unit itself has them, by key, raw; nothing where it does not answer.
    [[nodiscard]] std::vector<std::pair<std::string, std::optional<std::int64_t>>> gainsInUnit();
    /// From now on, the share of frames that is lost.
    void setLoss(double share) { m_session.bench(*m_link)->setLoss(share); }
    /// Another program's end of the same bus.
    [[nodiscard]] std::unique_ptr<Link> otherEnd() { return m_session.bench(*m_link)->hostLink(); }
    [[nodiscard]] FakeJournal &journal() { return m_journal; }
    /// What a tuning said it was about to do, and when, s.
    [[nodiscard]] const std::vector<std::pair<double, std::string>> &notes() const { return m_notes; }
    [[nodiscard]] tuning::Interruption &interruption() { return m_interruption; }

private:
    void prepare();
    void write(std::string_view key, double number);
    void disturb(const Surroundings &around);
    void renew();
    void shake();

    Cell m_cell;
    std::string m_text;
    std::string_view m_unit;
    Family m_family;
    const Family *m_list;
    VirtualClock m_clock;
    Session m_session;
    Link *m_link = nullptr;
    Device *m_device = nullptr;
    FakeJournal m_journal;
    tuning::DirectionBook m_directions;
    tuning::Interruption m_interruption;
    std::vector<std::pair<double, std::string>> m_notes;
    std::mt19937_64 m_random;
    Timer m_renewal;
    Timer m_shaking;
};

} // namespace mb::test
