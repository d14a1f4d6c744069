// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "app/console/publisher.h"
#include "app/console/silentperiods.h"

#include <algorithm>
#include <string>
#include <vector>

namespace mb::console {

/// Channels and states of one family, by name.
struct Watched {
    std::vector<ChannelIndex> channels;
    std::vector<StateIndex> states;
    bool driven = false; ///< by this verb: that the motor stands before and after it is no news
};

/// Prints the samples of one device as they come, from its construction on, and counts them: CSV with a header, or
/// JSON. A state that was named is a sample of true or false (CSV: 1, 0) at the beginning and whenever it changes. Conditions
/// and faults that begin or end are notes, without --json.
class SampleStream {
public:
    /// Nothing named: all channels. With a publisher the samples go there instead of standard output.
    SampleStream(Console &console, Device &device, Watched watched, Publisher *publisher = nullptr);

    [[nodiscard]] std::uint64_t count() const { return m_count; }
    /// Of the channel of which most came.
    [[nodiscard]] std::uint64_t most() const { return *std::ranges::max_element(m_ofChannel); }
    /// Samples known missing, those of a silent unit included, and frames that the link knows missing.
    [[nodiscard]] std::uint64_t lost() const;

private:
    void print(const Sample &sample);
    void print(Instant time, std::string_view key, double value, std::string_view unit, const QJsonValue &json);
    void printStates(Instant time);
    void noteStates();
    [[nodiscard]] bool isNews(const StateRow &row) const
    {
        return !row.clause.empty() && (row.kind != StateKind::Rest || !m_driven);
    }
    [[nodiscard]] std::uint64_t lostSoFar() const;

    Console &m_console;
    Device &m_device;
    Publisher *m_publisher;
    std::string m_name; ///< FAMILY:ADDRESS, for a publisher
    bool m_driven;
    TimeOrigin m_time;
    Instant m_start; ///< what was measured before is not part of it
    std::vector<bool> m_chosen;
    std::uint64_t m_count = 0;
    std::vector<std::uint64_t> m_ofChannel;
    std::uint64_t m_lostBefore = 0;
    SilentPeriods m_silence;
    std::vector<StateIndex> m_states;
    LiveStates m_printed;
    LiveStates m_noted;
    std::vector<std::string> m_faults; ///< that were noted
    Subscription m_samples;
    Subscription m_stateChanged;
    Subscription m_changed;
    Subscription m_heardChanged;
};

/// Usage for what the family has neither as a channel nor as a state.
[[nodiscard]] Result<Watched> parseWatched(const Family &family, const std::vector<std::string> &names);

} // namespace mb::console
