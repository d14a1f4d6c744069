// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/node.h"
#include "model/deviceknowledge.h"
#include "model/parameterstore.h"

namespace mb::supermodified {

/// Reads and writes the settings of one node, and notes in the roster what others must know of them. Engine thread; outlives its
/// tasks.
class NodeSettings {
public:
    /// All outlive it; `codes` gets what the node reports in place of answers.
    NodeSettings(Line &line, const Node &node, const ParameterStore &known, DeviceKnowledge &kept, CodeSink codes);

    /// The node's dialect has it.
    [[nodiscard]] bool offers(ParameterIndex index) const;
    /// Raw value in force.
    [[nodiscard]] Task<std::int64_t> read(ParameterIndex index);
    /// OutOfRange: what the dialect does not take, or an id that another node has or will have.
    [[nodiscard]] Task<void> mayWrite(ParameterIndex index, std::int64_t raw);
    /// Yields what was sent. A set is answered after its EEPROM was written (README.md#time-outs).
    [[nodiscard]] Task<std::int64_t> write(ParameterIndex index, std::int64_t raw);
    /// One exchange with the node: node.h.
    [[nodiscard]] Task<Frame> talk(Line::Request request);

private:
    /// The current limit that the node has to store, while it may take this duration for it; beyond this run of the program.
    struct OwedLimit {
        std::int64_t limit = 0; ///< 0: none
        std::int64_t duration = 0;
        friend bool operator==(const OwedLimit &, const OwedLimit &) = default;
    };
    [[nodiscard]] OwedLimit owedLimit() const;
    void owe(const OwedLimit &owed);
    [[nodiscard]] Result<Line::Request> request(Command command, std::int64_t raw) const;
    [[nodiscard]] Task<void> mayTake(int id);
    [[nodiscard]] Task<std::int64_t> readNumber(Command command);
    [[nodiscard]] Task<void> writeNumber(Command command, std::int64_t raw);
    [[nodiscard]] Task<void> writeDuration(std::int64_t raw);
    void noteWritten(const Parameter &row, std::int64_t raw);
    void noteRead(const Parameter &row, std::int64_t raw);

    Line &m_line;
    const Node &m_node;
    const ParameterStore &m_known;
    DeviceKnowledge &m_kept;
    CodeSink m_codes;
};

} // namespace mb::supermodified
