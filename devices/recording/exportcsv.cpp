// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/exportcsv.h"

#include "async/outputfile.h"
#include "files/csvtext.h"
#include "recording/merge.h"

#include <array>
#include <charconv>

namespace mb {
namespace {

constexpr std::uint64_t lookEvery = 16384; ///< samples between two looks at the progress

double seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

std::string isoTime(Duration sinceEpoch)
{
    const auto whole = std::chrono::floor<std::chrono::seconds>(sinceEpoch);
    std::string text = csvTime(static_cast<double>(whole.count()));
    const auto micros = std::chrono::floor<std::chrono::microseconds>(sinceEpoch - whole);
    const std::string digits = std::to_string(micros.count());
    return text.insert(text.size() - 1, '.' + std::string(6 - digits.size(), '0') + digits);
}

std::string oneLine(std::string text)
{
    for (char &c : text)
        c = c == '\n' || c == '\r' ? ' ' : c;
    return text;
}

/// Everything that is not a number.
std::string headOf(const ExportPlan &plan)
{
    std::string head = "# MotorBench recording\n# time_s 0 is " + isoTime(plan.clock.unixTime(plan.from)) + " (Unix "
        + numberText(seconds(plan.clock.unixTime(plan.from))) + ")\n";
    for (const auto &[name, facts] : plan.about) {
        for (const auto &[key, value] : facts)
            head += "# " + name + ": " + key + " = " + oneLine(value) + '\n';
    }
    for (const auto &[name, facts] : lossOf(plan)) {
        for (const auto &[key, value] : facts)
            head += "# " + name + ": " + key + " = " + value + " lost\n";
    }
    for (const ExportChannel &channel : plan.channels) {
        if (!channel.formula.empty())
            head += "# derived: " + channel.key + " = " + oneLine(channel.formula) + '\n';
        if (channel.simulated)
            head += "# simulated: " + channel.title() + '\n';
    }
    for (const TimedNote &note : plan.notes)
        head += "# note " + numberText(seconds(plan.clock.unixTime(note.time) - plan.clock.unixTime(plan.from)))
            + " s: " + oneLine(note.text) + '\n';
    std::vector<std::string> titles{"time_s"};
    for (const ExportChannel &channel : plan.channels)
        titles.push_back(channel.unit.empty() ? channel.title() : channel.title() + " (" + channel.unit + ')');
    return head + csvRow(titles);
}

/// One row of the table, filled column by column.
class Row {
public:
    explicit Row(std::size_t columns)
        : m_fields(columns)
    {
    }
    [[nodiscard]] bool fits(const MergedSamples::Next &next) const
    {
        return m_empty || (next.point.time == m_time && m_fields[next.channel].empty());
    }
    void put(const MergedSamples::Next &next)
    {
        m_time = next.point.time;
        m_empty = false;
        std::array<char, 40> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), next.point.value).ptr;
        m_fields[next.channel].assign(text.data(), end);
    }
    /// A row of its own, just before the sample it does not connect to.
    void putGap(const MergedSamples::Next &next)
    {
        m_time = std::max(m_time, next.point.time - std::chrono::microseconds(1));
        m_empty = false;
        m_fields[next.channel] = "nan";
    }
    void writeTo(std::string &out, const ExportPlan &plan)
    {
        if (m_empty)
            return;
        std::array<char, 40> time{};
        const double since = seconds(plan.clock.unixTime(m_time) - plan.clock.unixTime(plan.from));
        out.append(time.data(), // with a dot in every locale
            std::to_chars(time.data(), time.data() + time.size(), since, std::chars_format::fixed, 6).ptr);
        for (std::string &field : m_fields) {
            out += ',';
            out += field;
            field.clear();
        }
        out += '\n';
        m_empty = true;
    }

private:
    std::vector<std::string> m_fields;
    Instant m_time{};
    bool m_empty = true;
};

} // namespace

Result<ExportReport> exportCsv(const ExportPlan &plan, const std::string &path, const ExportProgress &progress)
{
    OutputFile file(path);
    MB_TRY_VOID(file.open());
    ExportReport report;
    std::string text = headOf(plan);
    Row row(plan.channels.size());
    MergedSamples samples(plan);
    const double span = std::max(seconds(plan.to - plan.from), 1e-9);
    while (const auto next = samples.next()) {
        if (next->gap) {
            row.writeTo(text, plan);
            row.putGap(*next);
        }
        if (!row.fits(*next))
            row.writeTo(text, plan);
        row.put(*next);
        report.lost += next->lost;
        if (++report.samples % lookEvery != 0)
            continue;
        if (progress && !progress(seconds(next->point.time - plan.from) / span))
            return fail(Fault::Cancelled);
        file.write(text);
        text.clear();
    }
    row.writeTo(text, plan);
    file.write(text);
    MB_TRY_VOID(file.commit());
    return report;
}

} // namespace mb
