// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/loadtable.h"

#include "model/identity.h"
#include "wire/byteordermark.h"
#include "wire/number.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <deque>
#include <fstream>
#include <map>
#include <utility>

namespace mb {
namespace {

constexpr std::size_t longestLine = 1U << 20U;
constexpr std::size_t mostColumns = 1000;

std::vector<std::string> fieldsOf(const std::string &line, char separator = ',')
{
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
            fields.back() += line[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (c == separator && !quoted)
            fields.emplace_back();
        else
            fields.back() += c;
    }
    return fields;
}

/// Of the first line: what parts most columns of comma, semicolon and tab.
char separatorOf(const std::string &line)
{
    const auto count = [&line](char c) { return std::ranges::count(line, c); };
    char best = ',';
    for (const char c : {';', '\t'}) {
        if (count(c) > count(best))
            best = c;
    }
    return best;
}

/// Where a program wrote that there is no number, it is NaN.
std::optional<double> numberOf(const std::string &text)
{
    constexpr std::array<std::string_view, 5> none{"nan", "-nan", "inf", "-inf", "NaN"};
    if (std::ranges::find(none, text) != none.end())
        return std::nan("");
    return numberFrom(text);
}

std::optional<Instant> timeOf(const std::string &text, double offset, double unit = 1.0)
{
    auto seconds = numberOf(text);
    if (seconds)
        *seconds *= unit;
    constexpr double farthest = 4.5e9; // nanoseconds in 62 bits: between any two of them there are 63
    if (!seconds || !(std::abs(*seconds + offset) < farthest))
        return std::nullopt;
    // In two parts: a double of Unix time has no digits left for it. Histories keep whole microseconds.
    const double whole = std::floor(*seconds);
    const double wholeOffset = std::floor(offset);
    return Instant(std::chrono::seconds(static_cast<std::int64_t>(whole) + static_cast<std::int64_t>(wholeOffset))
        + std::chrono::microseconds(std::llround((*seconds - whole + offset - wholeOffset) * 1e6)));
}

/// "dmc60c:5 velocity (counts/s)" in two.
std::pair<std::string, std::string> titleAndUnit(const std::string &head)
{
    const std::size_t open = head.rfind(" (");
    if (open == std::string::npos || head.back() != ')')
        return {head, {}};
    return {head.substr(0, open), head.substr(open + 2, head.size() - open - 3)};
}

/// Of "Zeit (ms)", "t [us]", "time_ns": what one of them is in seconds; of other heads they are seconds.
double timeUnitOf(std::string_view head)
{
    constexpr std::array<std::pair<std::string_view, double>, 5> units{
        {{"ms", 1e-3}, {"us", 1e-6}, {"\u00b5s", 1e-6}, {"\u03bcs", 1e-6}, {"ns", 1e-9}}};
    if (head.ends_with(')') || head.ends_with(']'))
        head.remove_suffix(1);
    const std::string_view word = head.substr(head.find_last_of("_([ ") + 1);
    const auto *const unit = std::ranges::find(units, word, &std::pair<std::string_view, double>::first);
    return unit == units.end() ? 1.0 : unit->second;
}

/// "# loss sim:can/dmc60c:5: velocity = 84 of 2084 lost": of which column, and how many.
std::optional<std::pair<std::string, std::uint64_t>> lossIn(std::string_view line)
{
    constexpr std::string_view mark = "# loss ";
    const std::size_t owner = line.find(": ");
    const std::size_t equals = line.rfind(" = ");
    const std::size_t of = line.rfind(" of ");
    if (!line.starts_with(mark) || !line.ends_with(" lost") || owner == std::string_view::npos
        || equals == std::string_view::npos || of == std::string_view::npos || owner + 2 > equals || equals + 3 > of)
        return std::nullopt;
    const auto count = wholeFrom<std::uint64_t>(line.substr(equals + 3, of - equals - 3));
    if (!count)
        return std::nullopt;
    const std::string_view selector = line.substr(mark.size(), owner - mark.size());
    const std::string device(selector == "derived" ? "" : partsOf(selector).device);
    const std::string key(line.substr(owner + 2, equals - owner - 2));
    return std::pair(device.empty() ? key : device + ' ' + key, *count);
}

class TableReader {
public:
    TableReader(const std::string &path, std::uint64_t mostSamples, std::size_t mostBytes)
        : m_path(path)
        , m_file(path)
        , m_most(mostSamples)
        , m_mostBytes(mostBytes)
    {
    }

    Result<std::shared_ptr<LoadedRecording>> read()
    {
        if (!m_file)
            return fail(Fault::OutOfRange, say("%1 cannot be read: %2", m_path, std::strerror(errno)));
        std::string line;
        bool read = false;
        while ((read = next(line)) && line.rfind('#', 0) == 0)
            takeComment(line);
        if (m_line == 1 && !read && !m_tooLong)
            return fail(Fault::OutOfRange, say("%1: %2", m_path, say("the file is empty")));
        if (line == "t,channel,value,unit")
            return readLong();
        if (m_tooLong)
            return wrong(tooLong());
        m_separator = separatorOf(line);
        const std::vector<std::string> heads = fieldsOf(line, m_separator);
        if (heads.size() < 2 || heads.size() > mostColumns || numberOf(heads[1])
            || line.find('\0') != std::string::npos)
            return wrong(say("there is no table here: expected time_s,name (unit),… or t,channel,value,unit"));
        m_timeUnit = timeUnitOf(heads.front());
        for (std::size_t i = 1; i < heads.size(); ++i) {
            const auto [title, unit] = titleAndUnit(heads[i]);
            addLoadedChannel(*m_loaded, title, unit);
            m_lost.push_back(std::exchange(m_losses[title], 0));
        }
        m_loaded->telemetry = std::make_shared<Telemetry>(m_loaded->table);
        while (!isEnough(m_most, m_loaded->telemetry->memoryUse()) && next(line)) {
            if (const auto taken = takeRow(fieldsOf(line, m_separator)); !taken && !isLeftOut())
                return tl::unexpected(taken.error());
        }
        if (m_tooLong)
            return wrong(tooLong());
        for (std::uint16_t i = 0; i < m_lost.size(); ++i) {
            if (m_lost[i] > 0)
                m_loaded->telemetry->lost({i}, m_lost[i]);
        }
        return m_loaded;
    }

private:
    bool next(std::string &line)
    {
        line.clear();
        do {
            ++m_line;
            if (!take(line))
                return false;
            if (m_line == 1)
                line = std::string(withoutByteOrderMark(line));
            if (!line.empty() && line.back() == '\r')
                line.pop_back();
        } while (line.empty());
        return true;
    }

    /// A line that is not understood and has no end is what a cut of power or a full disk has left of the last one.
    bool isLeftOut()
    {
        m_loaded->complete = !m_file.eof() && m_loaded->complete;
        return m_file.eof();
    }

    /// Whether all are read that there may be; of a file that ends there nothing is left out.
    bool isEnough(std::uint64_t most, std::size_t bytes)
    {
        m_loaded->shortened
            = (m_taken >= most || bytes > m_mostBytes) && m_file.peek() != std::ifstream::traits_type::eof();
        return m_loaded->shortened;
    }

    /// Never more of it than a line may have: a file may be one line of gigabytes.
    bool take(std::string &line)
    {
        m_file.getline(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
        const auto got = static_cast<std::size_t>(m_file.gcount());
        m_tooLong = m_file.fail() && got + 1 == m_buffer.size();
        if (m_file.fail())
            return false;
        line.assign(m_buffer.data(), got - (m_file.eof() ? 0 : 1)); // the sign of its end is counted
        return true;
    }

    [[nodiscard]] static Message tooLong() { return say("a line has more than %1 bytes", longestLine); }

    void takeComment(const std::string &line)
    {
        if (const std::size_t unixTime = line.find("(Unix ");
            line.rfind("# time_s 0 is", 0) == 0 && unixTime != std::string::npos) {
            const auto offset = numberOf(line.substr(unixTime + 6, line.find(')', unixTime) - unixTime - 6));
            m_loaded->hasClock = offset.has_value();
            m_offset = offset.value_or(0.0);
        }
        m_loaded->simulated = m_loaded->simulated || line.rfind("# simulated:", 0) == 0;
        if (const auto loss = lossIn(line); loss && m_losses.size() < mostColumns)
            m_losses[loss->first] += loss->second;
    }

    [[nodiscard]] tl::unexpected<Error> wrong(const Message &what) const
    {
        return fail(Fault::OutOfRange, say("%1, line %2: %3", m_path, m_line, what));
    }

    Result<void> takeRow(const std::vector<std::string> &fields)
    {
        const auto time = timeOf(written(fields.front()), m_offset, m_timeUnit);
        if (!time)
            return wrong(say("'%1' is no time in seconds", fields.front()));
        if (fields.size() > m_loaded->table.size() + 1)
            return wrong(say("more columns than the first line has"));
        for (std::uint16_t i = 1; i < fields.size(); ++i) {
            if (fields[i].empty())
                continue;
            const auto value = numberOf(written(fields[i]));
            if (!value)
                return wrong(say("'%1' is no number", fields[i]));
            const ChannelIndex channel{static_cast<std::uint16_t>(i - 1)};
            ++m_taken;
            if (std::isfinite(*value))
                m_loaded->telemetry->append({channel, *time, *value});
            else
                m_loaded->telemetry->lost(channel, std::exchange(m_lost[channel.value], 0)); // all in its first gap
        }
        return {};
    }

    /// One sample a line; the channels are known only at the end.
    Result<std::shared_ptr<LoadedRecording>> readLong()
    {
        struct LongRow {
            Instant time;
            std::uint16_t channel;
            double value;
        };
        std::deque<LongRow> rows; // never copied while it grows
        std::map<std::string, std::uint16_t> places;
        std::string line;
        while (!isEnough(m_most / 3, 0) && next(line)) {
            const std::vector<std::string> fields = fieldsOf(line);
            const bool isWhole = fields.size() == 4;
            const auto time = isWhole ? timeOf(fields[0], 0.0) : std::nullopt;
            const auto value = isWhole ? numberOf(fields[2]) : std::nullopt;
            if (!time || !value || !std::isfinite(*value)) {
                if (isLeftOut())
                    break;
                return wrong(isWhole ? say("'%1' is no number", (time ? fields[2] : fields[0]))
                                     : say("expected time, channel, value and unit"));
            }
            const auto [place, isNew] = places.emplace(fields[1], static_cast<std::uint16_t>(places.size()));
            if (places.size() > mostColumns)
                return wrong(say("more than 1000 channels"));
            if (isNew)
                addLoadedChannel(*m_loaded, fields[1], fields[3]);
            rows.push_back({*time, place->second, *value});
            ++m_taken;
        }
        if (m_tooLong)
            return wrong(tooLong());
        constexpr auto longAgo = Instant(std::chrono::hours(24 * 365 * 20)); // `watch` on sim: counts from its start
        m_loaded->hasClock = !rows.empty() && rows.front().time > longAgo;
        m_loaded->telemetry = std::make_shared<Telemetry>(m_loaded->table);
        for (std::uint64_t taken = 0; const LongRow &row : rows) {
            if (taken++ % 4096 == 0 && m_loaded->telemetry->memoryUse() > m_mostBytes) {
                m_loaded->shortened = true;
                break;
            }
            m_loaded->telemetry->append({{row.channel}, row.time, row.value});
        }
        return m_loaded;
    }

    /// Spreadsheets of half the world write 1,5 and part columns by semicolons.
    [[nodiscard]] std::string written(std::string number) const
    {
        if (m_separator != ',')
            std::replace(number.begin(), number.end(), ',', '.');
        return number;
    }

    const std::string &m_path;
    std::ifstream m_file;
    std::uint64_t m_most;
    std::size_t m_mostBytes;
    std::uint64_t m_taken = 0;
    std::vector<char> m_buffer = std::vector<char>(longestLine + 1);
    bool m_tooLong = false; ///< the line that was to be read last
    std::size_t m_line = 0;
    char m_separator = ',';
    double m_timeUnit = 1.0; ///< seconds
    double m_offset = 0.0;
    std::map<std::string, std::uint64_t> m_losses; ///< by title of the column, as the head tells them
    std::vector<std::uint64_t> m_lost;             ///< of a column, and in no gap of it yet
    std::shared_ptr<LoadedRecording> m_loaded = std::make_shared<LoadedRecording>();
};

} // namespace

Result<std::shared_ptr<LoadedRecording>> loadTable(
    const std::string &path, std::uint64_t mostSamples, std::size_t mostBytes)
{
    return TableReader(path, mostSamples, mostBytes).read();
}

} // namespace mb
