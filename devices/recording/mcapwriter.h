// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/result.h"
#include "recording/mcapformat.h"

#include <cstdio>
#include <memory>
#include <vector>

namespace mb {

class OutputFile;

/// What a file says of a channel; everything else goes into `about`.
struct McapChannel {
    std::string topic; ///< "/sim_can/dmc60c_5/velocity"
    mcap::Map about;   ///< unit, device, key, label …
};

/// Writes samples as an MCAP file that PlotJuggler and Foxglove open: one topic a channel, messages of protocol buffers
/// with their description inside. Neither chunked nor compressed: what has been flushed can be read, whatever happens
/// afterwards. Without finish() the file has no summary and no end, which readers call truncated, and McapReader takes.
/// One thread.
class McapWriter : NonCopyable {
public:
    /// OutOfRange with the cause when the file cannot be made.
    [[nodiscard]] static Result<std::unique_ptr<McapWriter>> create(const std::string &path);
    /// Into an open file, which is complete after finish() and the file's own commit().
    [[nodiscard]] static Result<std::unique_ptr<McapWriter>> create(const OutputFile &place);
    ~McapWriter();

    [[nodiscard]] std::uint16_t addChannel(const McapChannel &channel);
    /// `nanoseconds`: Unix time. `lost` samples are known missing before it; `gap`: it does not connect.
    void write(std::uint16_t channel, std::int64_t nanoseconds, double value, std::uint64_t lost, bool gap);
    /// Named facts, such as the parameters of a device. The same name may come again; the last one counts.
    void metadata(const std::string &name, const mcap::Map &facts);
    /// Hands everything to the kernel: it survives the end of this process. NotKept when the disk is full.
    [[nodiscard]] Result<void> flush();
    /// Summary and end. Nothing may be written afterwards.
    [[nodiscard]] Result<void> finish();

    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }
    [[nodiscard]] std::uint64_t samples() const { return m_samples; }

private:
    struct Close {
        void operator()(std::FILE *file) const { std::fclose(file); }
    };
    [[nodiscard]] static Result<std::unique_ptr<McapWriter>> onto(const std::string &path, std::FILE *file);
    McapWriter(std::string path, std::FILE *file);
    void record(mcap::Kind kind, const std::string &content);
    void raw(const void *data, std::size_t size);
    void writeSummary();

    std::string m_path;
    std::unique_ptr<std::FILE, Close> m_file;
    std::vector<std::string> m_channels; ///< contents of their records, for the summary
    std::vector<std::uint64_t> m_counts;
    struct Fact {
        std::uint64_t offset;
        std::uint64_t length;
        std::string name;
    };
    std::vector<Fact> m_facts;
    mcap::Content m_content;
    std::uint64_t m_bytes = 0;
    std::uint64_t m_samples = 0;
    std::uint64_t m_firstTime = 0;
    std::uint64_t m_lastTime = 0;
    std::uint32_t m_sequence = 0;
    int m_error = 0; ///< errno of the first write that failed
};

} // namespace mb
